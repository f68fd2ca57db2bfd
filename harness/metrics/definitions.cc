#include "harness/metrics/definitions.h"

#include "harness/metrics/metric.h"

namespace mb {

namespace {

struct Origin {
  std::string formula, source;
};

// Of the metrics, by name.
const std::map<std::string, Origin>& origins() {
  static const std::string l2 = "Oberkampf and Roy 2010, Verification and Validation in Scientific Computing";
  static const std::string sprague =
      "Sprague and Geers 2004, Commun. Numer. Meth. Engng 20; Schwer 2007, Eng. with Computers 23";
  static const std::string frame =
      "rigid frame of least squares: Kabsch 1976, Acta Cryst. A32; Umeyama 1991, IEEE Trans. PAMI 13(4)";
  static const std::string u = "; u: displacement, of a free body in the answer's own best rigid frame";
  static const std::string weights = "; *: the truth; tau, w: weights of times (trapezoidal rule) and points";
  static const std::string signal = "; s: of the answer, s*: of the truth; tau: weights of times (trapezoidal rule)";
  static const std::string touch = "mechanics/contact/touches.h";
  static const std::string first =
      "; of the first contact: the first touch and all that begin before the truth's first touch has ended plus half "
      "of "
      "its duration, from t_0 of the first to t_1 of the last; separations shorter than a tenth of the longer touch "
      "beside them are none; *: the truth";
  static const std::map<std::string, Origin> all = {
      {"displacement-error",
       {"sqrt(sum_t tau sum_i w_i rho |u_i - u*_i|^2 / sum_t tau sum_i w_i rho |u*_i|^2)" + u + weights,
        l2 + "; " + frame}},
      {"strain-error",
       {"sqrt(sum_t tau sum_i w_i (e_i - e*_i)^T D (e_i - e*_i) / sum_t tau sum_i w_i e*_i^T D e*_i), e: linear strain "
        "as the answer gives it" +
            weights,
        l2 + "; energy norm: Strang and Fix 1973, An Analysis of the Finite Element Method, ch. 1"}},
      {"surface-deviation",
       {"max_t max_i |u_i - u*_i| / l, i on the surface, l the largest edge of the bounding box" + u + "; *: the truth",
        "maximum norm, " + l2}},
      {"pose-translation", {"max_t |c - c*|, c the centroid of the best rigid frame; *: the truth", frame}},
      {"pose-rotation", {"max_t angle(R R*^T), R the rotation of the best rigid frame; *: the truth", frame}},
      {"probe-error",
       {"sqrt(sum_t tau (s - s*)^2 / sum_t tau s*^2), s = u(point) . direction, u: displacement with rigid motion" +
            signal,
        l2}},
      {"probe-magnitude", {"M = sqrt(<s s> / <s* s*>) - 1, <a b> = sum_t tau a b" + signal, sprague}},
      {"probe-phase", {"P = arccos(<s s*> / sqrt(<s s> <s* s*>)) / pi, <a b> = sum_t tau a b" + signal, sprague}},
      {"probe-combined", {"C = sqrt(M^2 + P^2), M of probe-magnitude, P of probe-phase", sprague}},
      {"probe-von-mises",
       {"sqrt(sum_t tau (s - s*)^2 / sum_t tau s*^2), s = sqrt(3/2 s':s'), s' the deviator of D e at the probe, e: "
        "strain" +
            signal,
        "von Mises 1913, Nachr. Ges. Wiss. Goettingen; " + l2}},
      {"truth-above-band",
       {"sum_{f > F/20} E(f) / sum_f E(f), E(f) = f^2 sum_i w_i |U_i(f)|^2, F = samples_per_second, Hann window, "
        "U: spectrum of the truth's u" +
            u + "; w: weights of points",
        "window: Harris 1978, Proc. IEEE 66(1); harness/metrics/spectrum.h"}},
      {"truth-strain", {"max_t max_i |e|, e: principal values of the strain of the truth at point i", "linear theory"}},
      {"truth-rotation",
       {"max_t max_i |curl p|/2 at point i, p: polynomials of degree 3 fitted to the truth's u" + u, "linear theory"}},
      {"first-touch", {"|t_0 - t_0*|, t_0 the time at which surfaces first meet; *: the truth", touch}},
      {"contact-duration", {"|T - T*| / T*, T = t_1 - t_0" + first, touch}},
      {"peak-force", {"|F - F*| / F*, F = max_t |f(t)|, f: all contact forces on the body" + first, touch}},
      {"impulse",
       {"|J - J*| / |J*|, J = sum of int f dt over the touches by the integrator's own quadrature" + first, touch}},
      {"touches", {"number of touches n" + first, touch}},
      {"energy-defect",
       {"|E(T) + D(T) - E(0)| / max(m v^2 / 2, max_t S(t), max_t W(t)), T: last time, 0: first; the rest as in "
        "energy-gain",
        "conservation of energy"}},
      {"restitution",
       {"|e - e*|, e = -(v + J/m + g (t_1 - t_0)) . j / (v . j), j = J/|J|, v: velocity of the centroid at t_0; of a "
        "ball that strikes the body |J|/(m v) - 1, m and v: the ball's" +
            first,
        "Stronge 2000, Impact Mechanics, sect. 2.5"}},
      {"force-error", {"sqrt(sum_t tau |f - f*|^2 / sum_t tau |f*|^2)" + signal, l2}},
      {"energy-gain",
       {"max_t (E(t) + D(t) - E(0)) / max(m v^2 / 2, max_t S(t), max_t W(t)), E: kinetic, elastic, of the weight and "
        "stored in contacts; D: lost in contacts; S: stored there; W: work of the weight; v: at the first touch",
        "conservation of energy"}},
      {"free-gain",
       {"(max_{t >= t_0} E(t) - E(t_0)) / max_{t <= t_0} E(t), E: kinetic, by the consistent mass, and stored; t_0: "
        "when "
        "the last load ends",
        "conservation of energy"}},
      {"momentum-defect",
       {"|[c - v t - g t^2/2] - int J dt / m| / |int J dt / m|, [ ]: last time less the first, c: centroid, v: at t = "
        "0",
        "conservation of momentum"}},
      {"momentum-drift",
       {"max of |P(t) - P(0) - J(t)| while nothing presses, of two bodies |J_a + J_b|, of two free ones |sum P(t) - "
        "sum "
        "P(0)|, over max_t |J|; P: by the mass that is stepped, the mesh's or the modes', less m g t; J: impulse "
        "of contacts since t = "
        "0",
        "conservation of momentum"}},
      {"angular-drift",
       {"max_t |L(t) - L(0)| / (l max_t |J|), L: sum over the bodies of int rho x x v dV about the origin, l: extent",
        "conservation of angular momentum: linear kinematics keep it to O(|u|/l), finite ones to the tolerance"}},
  };
  return all;
}

std::vector<MeasureDoc> all_docs() {
  std::vector<MeasureDoc> all;
  for (const Metric& metric : metric_catalogue()) {
    const auto origin = origins().find(metric.name);
    const Origin known = origin == origins().end() ? Origin{} : origin->second;
    all.push_back({metric.name, metric.unit, metric.doc, known.formula, known.source});
  }
  const std::string ours = "this suite's rule: harness/study/bench.h, harness/measure.h";
  all.push_back(
      {"online-time", "s",
       "Stepping under the given load histories and reconstruction of displacements at the frame times, one thread, "
       "median of at least 5 runs (3 where one takes 0.05 s or more) and 0.02 s after a warm-up; the bar is half the "
       "distance of the quartiles. Taken anew, up to three times, where the thread had the processor for less than "
       "95 % of the time. A time without a bar is that of a single run. Load patterns are known beforehand: projecting "
       "them is offline.",
       "median of wall-clock times of stepping + reconstruction", ours});
  all.push_back({"stepping-time", "s",
                 "The part of online-time that steps; the rest of it is reconstruction at the evaluation points.",
                 "median of wall-clock times of stepping", ours});
  all.push_back({"offline-time", "s",
                 "What is done once before the first step, on either side: assembly of the mesh, factorisation, "
                 "eigensolve with its gate, projection of the load patterns, static solves. One run.",
                 "assembly-time + wall-clock time of preparation", ours});
  all.push_back({"assembly-time", "s", "The part of offline-time that makes the mesh and its matrices. One run.",
                 "wall-clock time of assembly", ours});
  all.push_back({"load-error", "-",
                 "Largest error in representing the load by lines and cosines, relative to a chirp's peak, or to an "
                 "expression's own size and its mean at least: 0 for all other histories; those two are resampled to "
                 "[study] load_tolerance.",
                 "max_t |s - s_resampled| / max(mean |s|, |s|); of a chirp / max_t |s|",
                 "mechanics/history/resample.h"});
  return all;
}

}  // namespace

const std::vector<MeasureDoc>& measure_docs() {
  static const std::vector<MeasureDoc> all = all_docs();
  return all;
}

std::map<std::string, std::string> meanings() {
  std::map<std::string, std::string> all;
  for (const MeasureDoc& definition : measure_docs()) all[definition.name] = definition.meaning;
  return all;
}

}  // namespace mb
