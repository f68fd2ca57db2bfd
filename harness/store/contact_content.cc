#include "harness/store/contact_content.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace mb {

namespace {

using Matrices = std::map<std::string, Hdf5Matrix>;

// rows x columns exactly, or nothing where the key is not there.
MatrixXd sized(const Matrices& content, const std::string& key, Index rows, Index columns) {
  const auto found = content.find(key);
  if (found == content.end()) throw std::runtime_error("'" + key + "' is missing");
  if (found->second.values.rows() != rows || found->second.values.cols() != columns)
    throw std::runtime_error("'" + key + "' has a wrong size");
  return found->second.values;
}
MatrixXd finite(const Matrices& content, const std::string& key, Index rows, Index columns) {
  MatrixXd values = sized(content, key, rows, columns);
  if (!values.allFinite()) throw std::runtime_error("'" + key + "' is not finite");
  return values;
}

// Touch i of times (start, end, peak) follows the one before it and ends after it starts; only the last one may last.
void require_touch(const MatrixXd& t, Index i) {
  const bool last = i + 1 == t.cols();
  if (!std::isfinite(t(0, i)) || !std::isfinite(t(2, i)) || !(t(1, i) >= t(0, i)) || (!last && !std::isfinite(t(1, i))))
    throw std::runtime_error("touch " + std::to_string(i) + " has times that are none");
  if (i > 0 && !(t(0, i) >= t(0, i - 1)))
    throw std::runtime_error("touch " + std::to_string(i) + " begins before the one before it");
}

// Throws std::invalid_argument where one is none.
void add_touches(const std::string& key, const std::vector<Touch>& touches, Matrices& content) {
  const auto n = static_cast<Index>(touches.size());
  if (n == 0) return;
  MatrixXd times(3, n), peaks(1, n), impulses(3, n);
  for (Index i = 0; i < n; ++i) {
    const Touch& touch = touches[static_cast<size_t>(i)];
    times.col(i) << touch.start, touch.end, touch.peak_time;
    peaks(0, i) = touch.peak_force;
    impulses.col(i) = touch.impulse;
    try {
      require_touch(times, i);
    } catch (const std::runtime_error& fault) {
      throw std::invalid_argument("trajectory: " + std::string(fault.what()));
    }
  }
  if (!peaks.allFinite() || !impulses.allFinite())
    throw std::invalid_argument("trajectory: '" + key + "_touch_peaks' or '_touch_impulses' is not finite");
  content[key + "_touch_times"] = {times, "s"};
  content[key + "_touch_peaks"] = {peaks, "N"};
  content[key + "_touch_impulses"] = {impulses, "N s"};
}

}  // namespace

Matrices contact_content(const std::string& key, const BodyTrajectory& body, Index n_t) {
  const auto& [force, impulse, stored, dissipated, touches] = body.contact;
  if (force.cols() == 0 && touches.empty()) return {};
  if (force.cols() != n_t || impulse.cols() != n_t || stored.size() != n_t || dissipated.size() != n_t ||
      (body.energy.size() != n_t && body.energy.size() != 0) ||
      (body.momentum.size() != 0 && (body.momentum.rows() != 6 || body.momentum.cols() != n_t)))
    throw std::invalid_argument("trajectory: sizes of its contacts do not agree with its times");
  MatrixXd energy(2, n_t);
  energy << stored.transpose(), dissipated.transpose();
  Matrices content{{key + "_contact_force", {force, "N"}},
                   {key + "_contact_impulse", {impulse, "N s"}},
                   {key + "_contact_energy", {energy, "J"}}};
  if (body.energy.size() > 0) content[key + "_energy"] = {body.energy.transpose(), "J"};
  if (body.momentum.size() > 0) content[key + "_momentum"] = {body.momentum, "kg m/s, kg m^2/s"};
  for (const auto& [name, matrix] : content)
    if (!matrix.values.allFinite()) throw std::invalid_argument("trajectory: '" + name + "' is not finite");
  add_touches(key, touches, content);
  return content;
}

void read_contact(const Matrices& content, const std::string& key, Index n_t, BodyTrajectory& body) {
  if (!content.contains(key + "_contact_force")) return;
  body.contact.force = finite(content, key + "_contact_force", 3, n_t);
  body.contact.impulse = finite(content, key + "_contact_impulse", 3, n_t);
  const MatrixXd energy = finite(content, key + "_contact_energy", 2, n_t);
  body.contact.stored = energy.row(0);
  body.contact.dissipated = energy.row(1);
  if (content.contains(key + "_energy")) body.energy = finite(content, key + "_energy", 1, n_t).transpose();
  if (content.contains(key + "_momentum")) body.momentum = finite(content, key + "_momentum", 6, n_t);
  const auto times = content.find(key + "_touch_times");
  if (times == content.end()) return;
  const Index n = times->second.values.cols();
  const MatrixXd t = sized(content, key + "_touch_times", 3, n), peaks = finite(content, key + "_touch_peaks", 1, n),
                 impulses = finite(content, key + "_touch_impulses", 3, n);
  for (Index i = 0; i < n; ++i) {
    require_touch(t, i);
    body.contact.touches.push_back({t(0, i), t(1, i), peaks(0, i), t(2, i), impulses.col(i)});
  }
}

}  // namespace mb
