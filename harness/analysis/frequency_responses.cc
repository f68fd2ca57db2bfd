#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

#include "harness/analysis/analyses.h"
#include "harness/analysis/frequencies.h"
#include "harness/analysis/modal_body.h"
#include "harness/analysis/peak.h"
#include "harness/analysis/told.h"
#include "mechanics/system/frequency_response.h"
#include "modal/methods/projection.h"

namespace mb {

namespace {

using Eigen::MatrixXcd;
using Eigen::RowVectorXcd;
using Eigen::RowVectorXd;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr Index n_frequencies = 40;
constexpr double peak_to = 1e-4;  // [-] golden section in frequency (peak.h)
constexpr int highest_mode = 24;  // elastic: where the range ends

Finding curves_table(const Probe& probe, bool damped) {
  std::string note = fmt::format(
      "Steady displacement at probe '{}' under a load of unit factor, full order on the body's mesh and reduced. From "
      "a fifth of the first elastic frequency to that of mode {}, in equal ratios. Static correction adds the residual "
      "flexibility, which is real and the same at all frequencies. Phase: that of the displacement against the load. "
      "Bars: twice the distance to the same on the finer mesh of the case, at the same frequencies.",
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
      "counts. Largest deviation: the largest |u_r - u| / |u|, and where. Bars: twice the distance to the same on the "
      "finer mesh of the case; of where, at least the next of the frequencies that are looked at.",
      {{"load", ""}, {"contender", ""}, {"modes r", ""}, {"error", "-"}, {"largest deviation", "-"}, {"at", "Hz"}});
}

Finding peaks_table() {
  return table(
      "frequency-response", "frequency-response-peaks", "Highest peak of the frequency response",
      "Near the largest of the frequencies looked at in full order, by golden section to 1e-4 in frequency. "
      "Amplitude: for a load of unit factor. Bars: twice the distance to the same on the finer mesh of the case.",
      {{"contender", ""}, {"load", ""}, {"modes r", ""}, {"frequency", "Hz"}, {"amplitude", "m"}});
}

std::string load_name(const Scene& scene, Index load) {
  const auto l = static_cast<size_t>(load);
  return l < scene.loads.size() ? scene.loads[l].name : "base acceleration";
}

using Response = std::function<RowVectorXcd(double f)>;  // at the probe, under every load of unit factor

struct Answer {
  std::string contender;
  double r;  // modes used; NaN: full order
  bool is_drawn;
  Response response;
  MatrixXcd u;  // [m] frequencies x loads
};

// at_probe: displacement along the probe's direction, 1 x n.
Response of_system(std::shared_ptr<const System> system, const RowVectorXd& at_probe) {
  const auto response = std::make_shared<FrequencyResponse>(*system);
  return [system, response, at_probe](double f) -> RowVectorXcd { return at_probe * (*response)(2 * pi * f); };
}

Answer answer(const std::string& contender, double r, bool is_drawn, const Response& response, const VectorXd& f,
              Index n_loads) {
  Answer a{contender, r, is_drawn, response, MatrixXcd(f.size(), n_loads)};
  for (Index k = 0; k < f.size(); ++k) a.u.row(k) = response(f(k));
  return a;
}

struct Reduced {
  double r;  // modes used
  Response plain, corrected;
};
// Without and with static correction. static_response: of the loads, n x L.
Reduced reduced(const ModalBody& body, const RowVectorXd& probe, int r, const MatrixXd& static_response) {
  const Modes modes = leading(body.modes, r);
  const Response plain =
      of_system(std::make_shared<System>(project(body.system, modes)), RowVectorXd(probe * modes.Phi));
  const RowVectorXcd rest = (probe * residual_flexibility(modes, body.system.F, static_response)).cast<Complex>();
  return {static_cast<double>(modes.size() - modes.n_rigid), plain,
          [=](double at) -> RowVectorXcd { return plain(at) + rest; }};
}

// Full order first, then every mode count; that with static correction of the most modes last.
std::vector<Answer> answers(const ModalBody& body, const RowVectorXd& probe, const VectorXd& f,
                            const std::vector<int>& counts) {
  const Index n_loads = body.system.F.cols();
  const std::vector<int> drawn = few(counts, 4);
  const MatrixXd static_response = inertia_relief(body.system, body.shifted, body.system.F);
  std::vector<Answer> all;
  all.push_back(answer("full order", nan, true, of_system(std::make_shared<System>(body.system), probe), f, n_loads));
  for (const int r : counts) {
    const bool is_drawn = std::find(drawn.begin(), drawn.end(), r) != drawn.end();
    const auto [used, plain, corrected] = reduced(body, probe, r, static_response);
    all.push_back(answer("eigenmodes", used, is_drawn, plain, f, n_loads));
    all.push_back(answer("static-correction", used, is_drawn, corrected, f, n_loads));
  }
  return all;
}

RowVectorXd at_probe(const ModalBody& body, const Probe& probe) {
  return probe.direction.transpose() * body.model.full->displacement_at(Matrix3Xd(probe.point));
}

// Tables of what a probe answers under every load.
class Responses {
 public:
  // has_peaks: every mode is damped, so that a largest amplitude exists.
  Responses(const Scene& scene, const Probe& probe, const VectorXd& f, bool has_peaks)
      : scene_(scene),
        f_(f),
        has_peaks_(has_peaks),
        curves_(curves_table(probe, has_peaks)),
        errors_(errors_table()),
        peaks_(peaks_table()) {}

  void add(Index load, const std::vector<Answer>& answers) {
    const VectorXcd full = answers.front().u.col(load);
    Index k = 0;
    full.cwiseAbs().maxCoeff(&k);
    if (has_peaks_ && k > 0 && k + 1 < f_.size()) add_peaks(answers, {load, f_(k - 1), f_(k + 1)});
    for (const Answer& a : answers) {
      if (a.is_drawn) draw(load, a);
      if (!std::isnan(a.r)) mark(load, a, full);
    }
  }
  std::vector<Finding> findings() && {
    std::vector<Finding> all{std::move(curves_), std::move(errors_)};
    if (!peaks_.rows.empty()) all.push_back(std::move(peaks_));
    return all;
  }

 private:
  void draw(Index load, const Answer& a) {
    for (Index k = 0; k < f_.size(); ++k)
      curves_.rows.push_back({load_name(scene_, load), a.contender, a.r, f_(k), std::abs(a.u(k, load)),
                              std::arg(a.u(k, load)) * 180 / pi});
  }
  void mark(Index load, const Answer& a, const VectorXcd& full) {
    Index at = 0;
    const VectorXcd difference = a.u.col(load) - full;
    const double largest = difference.cwiseAbs().cwiseQuotient(full.cwiseAbs()).maxCoeff(&at);
    errors_.rows.push_back(
        {load_name(scene_, load), a.contender, a.r, difference.norm() / full.norm(), largest, f_(at)});
    const Index before = std::max<Index>(at - 1, 0), after = std::min(at + 1, f_.size() - 1);
    bar_last_row(errors_, {{"at", std::max(f_(at) - f_(before), f_(after) - f_(at))}});
  }
  struct Bracket {
    Index load;
    double from, to;  // [Hz] neighbours of the frequency where the response is largest
  };
  static Peak highest_of(const Response& response, const Bracket& at) {
    return highest([&](double f) { return std::abs(response(f)(at.load)); }, at.from, at.to);
  }
  void add_peaks(const std::vector<Answer>& answers, const Bracket& at) {
    for (const Answer& a : answers) {
      if (!a.is_drawn) continue;
      const Peak peak = highest_of(a.response, at);
      peaks_.rows.push_back({a.contender, load_name(scene_, at.load), a.r, peak.at, peak.height});
      bar_last_row(peaks_, {{"frequency", peak_to * peak.at}});
    }
  }

  const Scene& scene_;
  VectorXd f_;
  bool has_peaks_;
  Finding curves_, errors_, peaks_;
};

std::vector<Finding> on_mesh(const AnalysisContext& context, const Probe& probe, const Resolution& mesh,
                             const VectorXd& f, bool has_peaks) {
  const std::vector<int> counts = mode_counts(context);
  const ModalBody body = modal_body(context, counts.back(), mesh);
  const std::vector<Answer> all = answers(body, at_probe(body, probe), f, counts);
  Responses responses(*context.scene, probe, f, has_peaks);
  for (Index load = 0; load < body.system.F.cols(); ++load) responses.add(load, all);
  return std::move(responses).findings();
}

// Frequencies at which no steady response exists: those of the modes that nothing damps.
VectorXd resonances(const VectorXd& hertz, const VectorXd& zeta) {
  std::vector<double> undamped;
  for (Index i = 0; i < hertz.size(); ++i)
    if (!(zeta(i) > 1e-9)) undamped.push_back(hertz(i));  // rounding of a ratio of 0
  return Eigen::Map<const VectorXd>(undamped.data(), std::ssize(undamped));
}

}  // namespace

std::vector<Finding> frequency_responses(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const std::string& name = scene.bodies.front().name;
  const auto probe =
      std::find_if(scene.probes.begin(), scene.probes.end(), [&](const Probe& p) { return p.body == name; });
  if (probe == scene.probes.end()) return {};  // nowhere to look
  const ModalBody body = modal_body(context, highest_mode);
  const Index n_elastic = body.modes.size() - body.modes.n_rigid;
  if (n_elastic < 2) return {};
  const VectorXd known = body.modes.omega.tail(n_elastic) / (2 * pi);
  const double last = known(std::min<Index>(highest_mode, n_elastic) - 1);
  const VectorXd undamped = resonances(known, damping_ratios(body.system, body.modes));
  const VectorXd f = frequencies_between(known(0) / 5, last, n_frequencies, undamped);
  const bool has_peaks = undamped.size() == 0;
  std::vector<Finding> found = on_mesh(context, *probe, own_meshes(scene), f, has_peaks);
  const auto [meshes, bar_per_distance] = another_mesh(scene);
  add_bars(found, on_mesh(context, *probe, meshes, f, has_peaks), PerDistance(bar_per_distance));
  return found;
}

}  // namespace mb
