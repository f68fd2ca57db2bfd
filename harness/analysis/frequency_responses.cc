#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "harness/analysis/frequencies.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/peak.h"
#include "mechanics/system/frequency_response.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Index n_frequencies = 40;
constexpr int highest_mode = 24;  // elastic: where the range ends

Finding curves_table(const Probe& probe, bool damped) {
  std::string note = fmt::format(
      "Steady displacement at probe '{}' under a load of unit factor, full order on the body's mesh and reduced. From "
      "a fifth of the first elastic frequency to that of mode {}, in equal ratios. Static correction adds the residual "
      "flexibility, which is real and the same at all frequencies. Phase: that of the displacement against the load.",
      probe.name, highest_mode);
  if (!damped)
    note += " The body is undamped: peaks are unbounded, and frequencies keep 1 % away from those of the modes known.";
  return table(
      "frequency-response", "frequency-response", "Frequency response, full and reduced", note,
      {{"load", ""}, {"contender", ""}, {"modes r", ""}, {"frequency", "Hz"}, {"amplitude", "m"}, {"phase", "deg"}});
}

Finding errors_table() {
  return table(
      "frequency-response", "frequency-response-error", "Error of reduced frequency responses",
      "Error: root of the sum over the frequencies of |u_r - u|^2 over that of |u|^2, complex, so that phase "
      "counts. Largest deviation: the largest |u_r - u| / |u|, and where.",
      {{"load", ""}, {"contender", ""}, {"modes r", ""}, {"error", "-"}, {"largest deviation", "-"}, {"at", "Hz"}});
}

Finding peaks_table() {
  return table("frequency-response", "frequency-response-peaks", "Highest peak of the frequency response",
               "Near the largest of the frequencies looked at in full order, by golden section to 1e-4 in frequency. "
               "Amplitude: for a load of unit factor.",
               {{"contender", ""}, {"load", ""}, {"modes r", ""}, {"frequency", "Hz"}, {"amplitude", "m"}});
}

std::string load_name(const Scene& scene, Index load) {
  const auto l = static_cast<size_t>(load);
  return l < scene.loads.size() ? scene.loads[l].name : "base acceleration";
}

// Responses at one probe under one load.
class Responses {
 public:
  Responses(const AnalysisContext& context, const ModalBody& body, const Probe& probe, const VectorXd& f)
      : scene_(*context.scene),
        body_(body),
        f_(f),
        probe_((body.model.full->displacement_at(probe.point).transpose() * probe.direction).transpose()),
        static_response_(inertia_relief(body.system, body.shifted, body.system.F)),
        curves_(curves_table(probe, is_damped(body.system))),
        errors_(errors_table()),
        peaks_(peaks_table()) {}

  // all: mode counts to mark; drawn: those of them whose curves are kept.
  void add(Index load, const std::vector<int>& all, const std::vector<int>& drawn) {
    const VectorXcd full = of_full(load, f_);
    draw(load, "full order", nan, full);
    Index k = 0;
    full.cwiseAbs().maxCoeff(&k);
    const bool has_peak = is_damped(body_.system) && k > 0 && k + 1 < f_.size();
    if (has_peak) peak(load, "full order", nan, k, [&](const VectorXd& f) { return of_full(load, f); });
    for (const int r : all) {
      const Modes modes = leading(body_.modes, r);
      const System reduced = project(body_.system, modes);
      const Eigen::RowVectorXd at_probe = probe_ * modes.Phi;
      const double rest = probe_.dot(residual_flexibility(body_.system, modes, static_response_).col(load));
      const auto used = static_cast<double>(modes.size() - modes.n_rigid);
      const bool is_drawn = std::find(drawn.begin(), drawn.end(), r) != drawn.end();
      for (const auto& [name, flexibility] : {std::pair("eigenmodes", 0.0), std::pair("static-correction", rest)}) {
        const auto response = [&](const VectorXd& f) -> VectorXcd {
          const VectorXcd u = (at_probe.cast<Complex>() * frequency_response(reduced, load, 2 * pi * f)).transpose();
          return u.array() + flexibility;
        };
        const VectorXcd u = response(f_);
        if (is_drawn) draw(load, name, used, u);
        if (is_drawn && has_peak) peak(load, name, used, k, response);
        mark(load, name, used, u, full);
      }
    }
  }
  std::vector<Finding> findings() && {
    std::vector<Finding> all{std::move(curves_), std::move(errors_)};
    if (!peaks_.rows.empty()) all.push_back(std::move(peaks_));
    return all;
  }

 private:
  void draw(Index load, const std::string& contender, double r, const VectorXcd& u) {
    for (Index k = 0; k < f_.size(); ++k)
      curves_.rows.push_back({load_name(scene_, load), contender, r, f_(k), std::abs(u(k)), std::arg(u(k)) * 180 / pi});
  }
  void mark(Index load, const std::string& contender, double r, const VectorXcd& u, const VectorXcd& full) {
    Index at = 0;
    const VectorXd deviation = (u - full).cwiseAbs().cwiseQuotient(full.cwiseAbs());
    const double largest = deviation.maxCoeff(&at);
    errors_.rows.push_back({load_name(scene_, load), contender, r, (u - full).norm() / full.norm(), largest, f_(at)});
  }

  VectorXcd of_full(Index load, const VectorXd& f) const {
    return (probe_ * frequency_response(body_.system, load, 2 * pi * f)).transpose();
  }
  // Between the neighbours of the k-th frequency.
  void peak(Index load, const std::string& contender, double r, Index k,
            const std::function<VectorXcd(const VectorXd&)>& response) {
    const Peak peak =
        highest([&](double f) { return std::abs(response(VectorXd::Constant(1, f))(0)); }, f_(k - 1), f_(k + 1));
    peaks_.rows.push_back({contender, load_name(scene_, load), r, peak.at, peak.height});
  }

  const Scene& scene_;
  const ModalBody& body_;
  VectorXd f_;
  Eigen::RowVectorXd probe_;  // displacement along the probe's direction
  MatrixXd static_response_;
  Finding curves_, errors_, peaks_;
};

}  // namespace

std::vector<Finding> frequency_responses(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const std::string& name = scene.bodies.front().name;
  const auto probe =
      std::find_if(scene.probes.begin(), scene.probes.end(), [&](const Probe& p) { return p.body == name; });
  if (probe == scene.probes.end()) return {};  // nowhere to look
  const std::vector<int> counts = mode_counts(context);
  const ModalBody body = modal_body(context, std::max(counts.back(), highest_mode));
  const Index n_elastic = body.modes.size() - body.modes.n_rigid;
  if (n_elastic < 2) return {};
  const VectorXd known = body.modes.omega.tail(n_elastic) / (2 * pi);
  const double last = known(std::min<Index>(highest_mode, n_elastic) - 1);
  const VectorXd f =
      frequencies_between(known(0) / 5, last, n_frequencies, is_damped(body.system) ? VectorXd() : known);
  Responses responses(context, body, *probe, f);
  for (Index load = 0; load < body.system.F.cols(); ++load) responses.add(load, counts, few(counts, 4));
  return std::move(responses).findings();
}

}  // namespace mb
