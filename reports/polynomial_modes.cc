#include "reports/polynomial_modes.h"

#include <algorithm>
#include <limits>

namespace mb {
namespace {

const Record* usable(const Run& run, const std::string& metric, const std::string& body) {
  for (const auto& [measure, record] : run.measures)
    if (measure.metric == metric && measure.subject == body && is_against_best(run, measure) && is_usable(record))
      return &record;
  return nullptr;
}

// A record of the only body of a scene may name no subject.
const Body* body_of(const Scene& scene, const std::string& subject) {
  for (const Body& body : scene.bodies)
    if (body.name == subject || scene.bodies.size() == 1) return &body;
  return nullptr;
}

bool touches(const Scene& scene, const Body& body) {
  return std::ranges::any_of(
      scene.contacts, [&](const ContactPair& pair) { return pair.body == body.name || pair.obstacle == body.name; });
}

void add_marks(std::vector<PolynomialMark>& all, const Run& run, const Scene& scene) {
  for (const auto& [measure, record] : run.measures) {
    if (measure.metric != headline_metric || !is_against_best(run, measure) || !is_usable(record)) continue;
    const Body* body = body_of(scene, measure.subject);
    if (!body || body->theory != Theory::solid) continue;
    const auto of = [&](const char* metric) { return usable(run, metric, measure.subject); };
    const bool touching = touches(scene, *body);
    all.push_back({run.case_name, run.profile, body->name, run.contender.method, aspect_ratio(body->shape), touching,
                   &record, touching ? of("peak-force") : nullptr, touching ? of("impulse") : nullptr,
                   of("pose-translation"), of("pose-rotation")});
  }
}

bool is_finer(const Run& a, const Run& b) {
  return a.case_name == b.case_name && a.profile == b.profile && a.contender.method == b.contender.method &&
         a.contender.integrator == b.contender.integrator && accuracy(a.contender) < accuracy(b.contender);
}

std::vector<const Record*> deciding(const PolynomialMark& mark) {
  std::vector<const Record*> all{mark.displacement, mark.peak_force, mark.impulse};
  std::erase(all, nullptr);
  return all;
}

Cell error_cell(const Record* record) { return record ? record_cell(record) : text_cell(""); }

}  // namespace

double aspect_ratio(const Shape& shape) {
  const Vector3d size = extents(shape);
  return size.maxCoeff() / size.minCoeff();
}

std::vector<PolynomialMark> polynomial_marks(const Evaluation& evaluation) {
  std::vector<PolynomialMark> all;
  for (const Run& run : evaluation.runs) {
    const std::string& method = run.contender.method;
    if ((method != "linear" && method != "quadratic") || run.contender.integrator != "exact") continue;
    const Scene* scene = scene_of(evaluation, run.case_name, run.profile);
    const bool superseded =
        std::ranges::any_of(evaluation.runs, [&](const Run& other) { return is_finer(other, run); });
    if (scene && !superseded) add_marks(all, run, *scene);
  }
  return all;
}

double worst_error(const PolynomialMark& mark) {
  double worst = 0;
  for (const Record* record : deciding(mark)) worst = std::max(worst, counted_error(*record));
  return worst;
}

std::optional<bool> suffices(const PolynomialMark& mark) {
  bool within = true;
  for (const Record* record : deciding(mark)) {
    if (smallest_error(*record) > still_suffices) return false;
    within = within && largest_error(*record) <= still_suffices;
  }
  return within ? std::optional(true) : std::nullopt;
}

std::string kind(const PolynomialMark& mark) {
  return std::string(mark.compact() ? "compact" : "disparate") + (mark.in_contact ? ", in contact" : ", under loads");
}

Sheet polynomials_table(const Evaluation& evaluation) {
  using Kind = Column::Kind;
  Sheet table{.name = "polynomial-modes",
              .title = "Rigid, linear and quadratic modes",
              .note =
                  "Runs in closed form against the best truth, in contact of the least step. Aspect: largest over "
                  "smallest extent; compact up to 5. They suffice where the displacement error, in contact peak force "
                  "and impulse, too, are at most 10 %; open: an error bar reaches across. Method linear: rigid and "
                  "linear modes.",
              .columns = {{"case", ""},
                          {"profile", ""},
                          {"body", ""},
                          {"aspect", "-", Kind::number},
                          {"kind", ""},
                          {"method", ""},
                          {"displacement error", "-", Kind::error},
                          {"peak force", "-", Kind::error},
                          {"impulse", "-", Kind::error},
                          {"pose translation", "m", Kind::error},
                          {"pose rotation", "rad", Kind::error},
                          {"suffices", ""}},
              .rows = {},
              .n_keys = 0};
  for (const PolynomialMark& mark : polynomial_marks(evaluation)) {
    const auto enough = suffices(mark);
    table.rows.push_back({text_cell(mark.case_name), text_cell(mark.profile), text_cell(mark.body),
                          number_cell(mark.aspect), text_cell(kind(mark)), text_cell(mark.method),
                          error_cell(mark.displacement), error_cell(mark.peak_force), error_cell(mark.impulse),
                          error_cell(mark.translation), error_cell(mark.rotation),
                          text_cell(!enough   ? "open"
                                    : *enough ? "yes"
                                              : "no")});
  }
  return table;
}

}  // namespace mb
