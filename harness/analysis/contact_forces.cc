#include "harness/analysis/contact_forces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "harness/analysis/analyses.h"
#include "harness/analysis/collision_sweep.h"
#include "harness/analysis/modal_body.h"

namespace mb {

namespace {

constexpr double at_rest = 1e-8;    // [-] what time_to_rest is good to (mechanics/contact)
constexpr double rounding = 1e-12;  // errors below are none: heights are known to 1e-16 of the body's size

Finding errors_table() {
  std::vector<FindingColumn> columns{
      {"shape", ""}, {"depth", "-"}, {"contender", ""}, {"samples", ""}, {"error of exact", "-"}};
  for (const std::string& name : contact_error_names()) {
    columns.push_back({name, "-"});
    columns.push_back({name + " worst", "-"});
  }
  return table(
      "contact-forces", "contact-forces", "Errors of contact forces of a rigid body on a layer",
      "A rigid body pressed into the layer of a plane, p = k_n g per area of the body, to a depth given as share of "
      "its "
      "least half extent. Relative errors against the exact cap, mean and worst over orientations spread evenly: of "
      "force, area and greatest depth; of the resultant of Hertz's pressure on the same region (spheres alone); of an "
      "impact that exactly reaches this depth its peak force, its duration, and the impulse delivered until the exact "
      "body rests (the whole impulse is right for every contender: the layer keeps energy). Vertices of a "
      "triangulation with their areas, or all alike; quadrature on the exact surface with as many points, uniform or "
      "in the region of contact alone; the closed form by principal curvatures has no samples. k_n and the mass drop "
      "out. Error of exact: of the exact cap, worst over orientations.",
      std::move(columns));
}

Finding orders_table() {
  return table("contact-forces", "contact-forces-orders",
               "How errors of contact forces fall with the number of samples",
               "Exponent p of error ~ n^-p, errors averaged over orientations, by least squares in logarithms.",
               {{"shape", ""},
                {"depth", "-"},
                {"contender", ""},
                {"quantity", ""},
                {"sizes fitted", ""},
                {"exponent", "-"},
                {"standard error", "-"}});
}

Finding claim_table() {
  return table("contact-forces", "contact-forces-claim",
               "Claim C12: are analytic contact regions more accurate than vertex contact?",
               "Gain: mean error of vertices (with areas or alike, whichever is better) over that of the analytic "
               "contender, at every depth and number of samples; its geometric mean, and the least. Unbounded where "
               "the analytic contender errs by no more than rounding. Bars: of both errors, of the mean their mean.",
               {{"claim", ""}, {"compared", ""}, {"gain", "-"}, {"least gain", "-"}, {"verdict", ""}});
}

// Errors of one contender with so many samples (NaN: none), by rows as contact_error_names().
struct Marks {
  std::string contender;
  double n_samples;
  VectorXd mean, worst;
  double error_of_exact;
};

template <class ErrorsOf>
Marks marks(const std::string& contender, double n_samples, const std::vector<PressedBody>& bodies,
            const ErrorsOf& errors_of) {
  Marks all{contender, n_samples, VectorXd::Zero(n_contact_errors), VectorXd::Zero(n_contact_errors), 0};
  for (const PressedBody& body : bodies) {
    const VectorXd one = as_vector(errors_of(body));
    all.error_of_exact = std::max(all.error_of_exact, body.cap.error);
    all.mean += one / static_cast<double>(bodies.size());
    for (Index i = 0; i < one.size(); ++i)
      all.worst[i] = std::isnan(all.worst[i]) || one[i] <= all.worst[i] ? all.worst[i] : one[i];
  }
  return all;
}

// Every contender on one shape at one depth.
std::vector<Marks> contest(const Shape& shape, double depth, const ContactSizes& sizes) {
  std::vector<PressedBody> bodies;
  const Matrix3Xd down = directions(sizes.n_orientations);
  for (Index i = 0; i < down.cols(); ++i) bodies.push_back(pressed_body(shape, down.col(i), depth));
  std::vector<Marks> all;
  for (const int edges : sizes.edges) {
    const int k = std::holds_alternative<Sphere>(shape) ? edges : edges / 2;
    const auto add = [&](const char* name, const SurfacePoints& samples) {
      all.push_back(marks(name, static_cast<double>(samples.weights.size()), bodies,
                          [&](const PressedBody& body) { return errors_of_samples(body, samples); }));
    };
    const SurfacePoints by_area = vertices_by_areas(shape, k);
    const Index n = by_area.weights.size();
    add(by_areas, by_area);
    add(by_equal, vertices_by_equal(shape, k));
    add(by_uniform, uniform_quadrature(shape, k));
    all.push_back(marks(by_region, static_cast<double>(n), bodies,
                        [&](const PressedBody& body) { return errors_of_samples(body, region_quadrature(body, n)); }));
  }
  all.push_back(marks(by_curvatures, std::numeric_limits<double>::quiet_NaN(), bodies, errors_of_curvatures));
  return all;
}

std::vector<FindingCell> error_row(const std::string& shape, double depth, const Marks& one) {
  std::vector<FindingCell> row{shape, depth, one.contender, one.n_samples, one.error_of_exact};
  for (Index i = 0; i < one.mean.size(); ++i) {
    row.emplace_back(one.mean[i]);
    row.emplace_back(one.worst[i]);
  }
  return row;
}

// [-] Relative errors against the exact cap are no better known than that, those of an impact than time_to_rest is.
double bar_of(const Marks& one, bool of_impact) { return std::max(one.error_of_exact, of_impact ? at_rest : rounding); }

void add_errors(Finding& errors, const std::string& shape, double depth, const Marks& one) {
  errors.rows.push_back(error_row(shape, depth, one));
  std::vector<std::pair<const char*, double>> bars;
  for (size_t j = 5; j < errors.columns.size(); ++j) {
    const std::string& name = errors.columns[j].name;
    const bool of_impact = name.starts_with("duration") || name.starts_with("impulse");
    if (std::isfinite(std::get<double>(errors.rows.back()[j]))) bars.emplace_back(name.c_str(), bar_of(one, of_impact));
  }
  bar_last_row(errors, bars);
}

// What forces are judged by: places in contact_error_names().
struct Judged {
  Index place;
  const char* name;
  bool of_impact;
};
constexpr Judged judged[] = {{0, "force", false}, {3, "Hertz force", false}, {4, "impulse", true}};

void add_orders(Finding& orders, const std::string& shape, double depth, const std::vector<Marks>& all) {
  for (const char* contender : {by_areas, by_equal, by_uniform, by_region})
    for (const auto& [place, name, of_impact] : judged) {
      std::vector<double> n, error;
      for (const Marks& one : all)
        if (one.contender == contender) {
          n.push_back(one.n_samples);
          error.push_back(one.mean[place]);
        }
      const auto size = static_cast<Index>(n.size());
      const PowerLaw law =
          power_law(Eigen::Map<const VectorXd>(n.data(), size), Eigen::Map<const VectorXd>(error.data(), size));
      if (law.n_points == 0) continue;  // Hertz knows spheres alone
      orders.rows.push_back({shape, depth, contender, name, count(law.n_points), -law.exponent, law.standard_error});
    }
}

// An error with its bar [-], NaN where there is none.
struct Error {
  double value = std::numeric_limits<double>::quiet_NaN(), bar = value;
};
Error error_of(const std::vector<Marks>& all, const std::string& contender, double n, const Judged& by) {
  for (const Marks& one : all)
    if (one.contender == contender && (std::isnan(one.n_samples) || one.n_samples >= n - 2))
      return {one.mean[by.place], bar_of(one, by.of_impact)};
  return {};
}

struct Gains {
  std::vector<double> values, relative_bars;
};

// Of one depth, a gain for every number of samples; vertices may be weighted as suits them best.
void add_gains(Gains& gains, const std::vector<Marks>& all, const std::string& contender, const Judged& by) {
  for (const Marks& vertices : all) {
    if (vertices.contender != by_areas) continue;
    const double n = vertices.n_samples;  // quadratures have up to 2 fewer, and other sizes are far from it
    Error rival{vertices.mean[by.place], bar_of(vertices, by.of_impact)};
    if (const Error alike = error_of(all, by_equal, n, by); alike.value < rival.value) rival = alike;
    const Error own = error_of(all, contender, n, by);
    if (std::isnan(own.value) || std::isnan(rival.value)) continue;
    const bool unbounded = own.value <= rounding;
    gains.values.push_back(unbounded ? std::numeric_limits<double>::infinity() : rival.value / own.value);
    gains.relative_bars.push_back(unbounded ? std::numeric_limits<double>::quiet_NaN()
                                            : rival.bar / rival.value + own.bar / own.value);
  }
}

void add_claims(Finding& claim, const std::string& shape, const std::vector<std::vector<Marks>>& by_depth) {
  for (const char* contender : {by_curvatures, by_region, by_uniform})
    for (const Judged& by : judged) {
      Gains gains;
      for (const std::vector<Marks>& all : by_depth) add_gains(gains, all, contender, by);
      const auto n = static_cast<Index>(gains.values.size());
      if (n == 0) continue;
      const Eigen::Map<const VectorXd> values(gains.values.data(), n), bars(gains.relative_bars.data(), n);
      Index least = 0;
      values.minCoeff(&least);
      const double mean = std::exp(values.array().log().mean());
      claim.rows.push_back({"C12", fmt::format("{} by {}, {}", by.name, contender, shape), mean, values[least],
                            contact_verdict(gains.values)});
      bar_last_row(claim, {{"gain", mean * bars.mean()}, {"least gain", values[least] * bars[least]}});
    }
}

}  // namespace

ContactSizes usual_contact_sizes() { return {{0.01, 0.1}, {2, 4, 8, 16, 32}, 32}; }

std::string contact_verdict(const std::vector<double>& gains) {
  if (gains.empty()) return "not decided: nothing to compare";
  const auto n = std::count_if(gains.begin(), gains.end(), [](double gain) { return gain > 1; });
  const auto all = std::ssize(gains);
  if (n == all) return "holds";
  const std::string where = fmt::format("more accurate at {} of {} depths and numbers of samples", n, all);
  return (n == 0 ? "does not hold: " : "holds within limits: ") + where;
}

std::vector<Finding> contact_forces(const Shape& body, const ContactSizes& sizes) {
  Finding errors = errors_table(), orders = orders_table(), claim = claim_table();
  std::vector<std::pair<std::string, Shape>> shapes;
  if (std::holds_alternative<Superquadric>(body)) {
    shapes = {{"superquadric", body}};
  } else {
    shapes = {{"sphere", sphere_of_size(body)}, {"superquadric", superquadric_of_size(body)}};
  }
  for (const auto& [name, shape] : shapes) {
    std::vector<std::vector<Marks>> by_depth;
    for (const double share : sizes.depths) {
      by_depth.push_back(contest(shape, share * half_extents(shape).minCoeff(), sizes));
      for (const Marks& one : by_depth.back()) add_errors(errors, name, share, one);
      add_orders(orders, name, share, by_depth.back());
    }
    add_claims(claim, name, by_depth);
  }
  return {errors, orders, claim};
}

std::vector<Finding> contact_forces(const AnalysisContext& context) {
  return contact_forces(context.scene->bodies.front().shape, usual_contact_sizes());
}

}  // namespace mb
