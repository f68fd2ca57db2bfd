#include "harness/study/estimate.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "cases/scene/resolution.h"

namespace mb {

namespace {

constexpr double explicit_share = 1.0 / 3;  // [-] of a Newmark step
constexpr double adaptive_share = 30;       // [-] stages, error estimate and new factors of an adaptive step
constexpr double sudden = 6;                // [-] steps after a jump, to those of a smooth load
constexpr double sudden_damped = 2;         // [-] where stiffness damping soon takes the high frequencies away
constexpr double finite_share = 12;         // [-] of a linear step: stages iterate, each with factors of its own
constexpr double reduced_step = 1e-6;       // [s] + 20 ns a mode: a step of decoupled equations
constexpr double grade_per_sample = 1e-4;   // [s] marks at one time, and writing it
constexpr double timing = 0.02;             // [s] least total of repeated runs (measure.h)
constexpr double repeated_below = 0.05;     // [s] (bench.h)
constexpr double stability_map_of_modes = 8, stability_map_of_contact = 40;  // [s] in one process
constexpr double analysis_per_mode_count = 0.4;  // [-] share of making the modes of every count, for each analysis

struct Mesh {
  double n, front;  // [-] degrees of freedom: all, and those of the narrowest cross-section
  int degree;
};

double step(const Mesh& mesh) {
  const double row = 3 * std::pow(mesh.degree + 2, 3);  // entries of M and of K, away from the surface
  return 1e-9 * mesh.n * (0.22 * row + 0.3 * mesh.front);
}
double assembly(const Mesh& mesh) { return 2e-4 * mesh.n / mesh.degree; }
double modes(const Mesh& mesh, double r) { return (70 + r) * 9 * step(mesh); }
double dense(double n) { return 2e-9 * n * n * n; }

// A factor's rows are about as wide as what parts the mesh in two: a layer across its longest direction. Half waves of
// beams and plates know nothing of each other.
double front(const Body& body, const Resolution& resolution) {
  if (body.theory != Theory::solid) return 1;
  const Shape& shape = body.shape;
  const auto nodes = [&](size_t i) { return static_cast<double>(resolution.degree * resolution.cells[i] + 1); };
  const double n = n_dofs(shape, resolution);
  if (std::holds_alternative<Box>(shape)) return n / std::max({nodes(0), nodes(1), nodes(2)});
  const double across = 3 * nodes(0);  // three of the blocks of a disc or ball stand in a row
  return n / (std::holds_alternative<Cylinder>(shape) ? std::max(across, nodes(1)) : across);
}

// Of all bodies alike: the widest front.
Mesh mesh_of(const Scene& scene, const Resolution& resolution) {
  Mesh all{0, 0, resolution.degree};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const Resolution own = of_body(resolution, i);
    all.n += n_dofs(body.shape, own, body.theory);
    all.front = std::max(all.front, front(body, own));
  }
  return all;
}

class CaseEstimate {
 public:
  CaseEstimate(const Scene& scene, const Catalogue& catalogue)
      : scene_(scene), catalogue_(catalogue), n_samples_(static_cast<double>(sample_times(scene).size())) {}

  Estimate run() const {
    const Resolution own = own_meshes(scene_);
    const double rtol = scene_.truth.relative_tolerance;
    // Two at a time: the finer one beside the others.
    const double truth =
        std::max(truth_run(scene_.truth.finer, rtol),
                 truth_run(scene_.truth.coarser, rtol) + truth_run(own, rtol) + truth_run(own, rtol / 100));
    double all = 0;
    std::set<std::pair<std::string, int>> bases;  // shared among the integrators
    for (const Contender& c : contenders(scene_, catalogue_)) {
      if (bases.insert({c.method, c.settings.modes}).second) all += basis(c);
      all += this->contender(c);
    }
    return {truth, all, analyses()};
  }

 private:
  Mesh mesh(const Resolution& resolution) const { return mesh_of(scene_, resolution); }

  bool is_sudden() const {
    const auto driven = [](const Support& s) { return s.drive && std::holds_alternative<Step>(s.drive->acceleration); };
    const auto shaken = [&](const Body& body) { return std::ranges::any_of(body.supports, driven); };
    const auto struck = [](const Load& load) { return std::holds_alternative<Step>(load.history); };
    return std::ranges::any_of(scene_.loads, struck) || std::ranges::any_of(scene_.bodies, shaken);
  }

  // Steps of the adaptive integrator, as its tolerance alone rules them.
  double n_adaptive(double rtol) const {
    const bool damped = std::ranges::any_of(scene_.bodies, [](const Body& body) { return body.damping.beta > 0; });
    return 4 * std::pow(rtol, -0.3) * (!is_sudden() ? 1 : damped ? sudden_damped : sudden);
  }

  double full_step(const Mesh& mesh) const {
    const bool finite =
        std::ranges::any_of(scene_.bodies, [](const Body& body) { return body.kinematics != Kinematics::linear; });
    return step(mesh) * (finite ? finite_share : 1);
  }

  double truth_run(const Resolution& resolution, double rtol) const {
    const Mesh own = mesh(resolution);
    return assembly(own) + n_adaptive(rtol) * adaptive_share * full_step(own);
  }

  double stepping(const Contender& c, double newmark_step) const {
    const Integrator& integrator = catalogue_.integrator(c.integrator);
    if (integrator.knob == Integrator::Knob::tolerance)
      return n_adaptive(c.settings.relative_tolerance) * adaptive_share * newmark_step;
    if (!(c.settings.time_step > 0)) return n_samples_ * newmark_step;
    const double n_steps = scene_.duration / c.settings.time_step;
    return n_steps * newmark_step * (integrator.conditionally_stable ? explicit_share : 1);
  }

  double basis(const Contender& c) const {
    const Mesh own = mesh(c.resolution);
    if (is_full_order(c)) return 0;
    if (c.method == "full") return c.integrator == "exact" ? dense(own.n) : 0;
    const double r = catalogue_.method(c.method).takes_modes() ? c.settings.modes : 24;  // at most quadratic strain
    return modes(own, r);
  }

  double contender(const Contender& c) const {
    const Mesh own = mesh(c.resolution);
    const bool of_mesh = is_full_order(c) || c.method == "full", closed_form = c.integrator == "exact";
    const double r = catalogue_.method(c.method).takes_modes() ? c.settings.modes : 24;
    const double preparation = is_full_order(c) ? assembly(own) : 0;
    const double online = stepping(c, of_mesh && !closed_form ? step(own) : reduced_step + 2e-8 * r);
    // Online time and the time of stepping alone are repeated where they are short.
    const double timed = online < repeated_below ? 2 * std::max(timing, 6 * online) : online;
    return preparation + online + timed + n_samples_ * grade_per_sample;
  }

  double analyses() const {
    const Mesh own = mesh(own_meshes(scene_));
    double once = 0;
    for (const int r : scene_.study.modes) once += modes(own, r);
    // Those of contact answer in full order, too, in the mean about once.
    const double full = scene_.contacts.empty() ? 0 : truth_run(own_meshes(scene_), scene_.truth.relative_tolerance);
    double maps = 0;
    for (const std::string& analysis : scene_.study.analyses)
      maps += analysis == "stability-map"       ? stability_map_of_modes
              : analysis == "contact-stability" ? stability_map_of_contact
                                                : 0;
    return static_cast<double>(scene_.study.analyses.size()) * (analysis_per_mode_count * once + full) + maps;
  }

  const Scene& scene_;
  const Catalogue& catalogue_;
  double n_samples_;
};

}  // namespace

Estimate estimate(const Scene& scene, const Catalogue& catalogue) { return CaseEstimate(scene, catalogue).run(); }

namespace {

// [byte] The program itself, and what three threads that call the BLAS have of it: OpenBLAS asks for 128 MiB each, and
// asks for good where they are not there.
constexpr double program = (256 + 3 * 128) << 20;
constexpr double most_dense = 6000;  // unknowns that dense solvers take
constexpr double few_modes = 24;     // [-] at most, of methods without a mode count: quadratic strain

// Contact keeps what it finds of the inverse beside each of the factors, a column for each unknown that touches: most
// of a face, or few where a graded mesh says that bodies meet at a point.
double of_mesh(const Scene& scene, const Resolution& resolution) {
  const Mesh mesh = mesh_of(scene, resolution);
  const bool by_faces = !scene.contacts.empty() && resolution.graded == 0;
  const double factors = (by_faces ? 70 : 35) * mesh.front;
  return mesh.n * (300 * std::pow(mesh.degree + 2, 3) + factors);
}

// K, M, the matrix reduced by the factor of M, its eigenvectors, these once more without their rigid part, and what the
// solver works in.
double of_all_modes(double n) { return 9 * 8 * std::pow(std::min(n, most_dense), 2); }

// 3 (r + spare) + 16 blocks of vectors and as many images under M, then r modes (modal/bases/shift_invert.cc); the last
// of so few unknowns that these would span the system are found by a dense solver.
double of_modes(double n, double r) {
  r = std::min(r, n);
  return 3 * r > n || n < 2 * r + 184 ? of_all_modes(n) : 8 * n * (7 * r + 400);
}

double of_answer(const Scene& scene) {
  constexpr double values = 8 * (3 * 500 + 6 * 300);  // [byte] of a body at one time
  return values * static_cast<double>(scene.bodies.size()) * static_cast<double>(sample_times(scene).size());
}

// [-] What is timed answers at every frame, and at the end: more times than samples, perhaps.
double n_times(const Scene& scene, bool timed) {
  const Index frames = timed ? frame_times(scene).size() + 1 : 0;
  return static_cast<double>(std::max(sample_times(scene).size(), frames));
}

double of_frames(const Scene& scene) {
  constexpr double values = 2 * 8 * 3 * 500;  // [byte] of a body at one time, without strain, and once more in its axes
  return values * static_cast<double>(scene.bodies.size()) * static_cast<double>(frame_times(scene).size() + 1);
}

// What marks and tables are made of stands beside the answers: these in another frame, weighed, their spectra.
constexpr double answers_of_marks = 5, answers_of_analyses = 12;  // [-] answers: 3.5 and a closed form, 11

// The companion matrix of so many coupled modes, its Schur form, complex eigenvectors, these sorted and factorised.
double of_coupled_modes(double n) { return 2 * 8 * 60 * std::pow(n, 2); }

bool is_coupled(const Body& body) { return !body.dashpots.empty(); }

double of_states(double n_unknowns, double n_times) { return 4 * 8 * n_unknowns * n_times; }

// Body by body: each has modes of its own. Full order keeps what it evaluates alone.
double of_basis(const Scene& scene, const Contender& contender, bool timed) {
  if (is_full_order(contender)) return 0;
  const bool full = contender.method == "full";
  const double r = contender.settings.modes > 0 ? contender.settings.modes : few_modes;
  double sum = 0;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const Body& body = scene.bodies[i];
    const double n = n_dofs(body.shape, of_body(contender.resolution, i), body.theory);
    const double modes = !full ? of_modes(n, r) : contender.integrator == "exact" ? of_all_modes(n) : 0;
    sum += modes + of_states(full ? n : std::min(n, r), n_times(scene, timed));
    if (is_coupled(body) && (!full || contender.integrator == "exact"))  // steps are held to the closed form
      sum += of_coupled_modes(full ? n : std::min(n, r));
  }
  return sum;
}

Contender widest(const Scene& scene, const Resolution& mesh) {
  Contender contender{"eigenmodes", "exact", mesh, {}};
  for (const int r : scene.study.modes) contender.settings.modes = std::max(contender.settings.modes, r);
  return contender;
}

}  // namespace

double memory(const Scene& scene) {
  return memory_of_truths(scene, {scene.truth.finer, scene.truth.coarser, own_meshes(scene)});
}

double memory_of_truths(const Scene& scene, const std::vector<Resolution>& meshes) {
  std::vector<double> dearest{0, 0};
  for (const Resolution& mesh : meshes) dearest.push_back(of_mesh(scene, mesh));
  std::ranges::sort(dearest, std::greater());
  // Marks begin, with the truths' own bars, when no mesh is left.
  return std::max(dearest[0] + dearest[1], answers_of_marks * of_answer(scene)) + memory_of_answers(scene) + program;
}

double memory_of_answers(const Scene& scene) { return 5 * of_answer(scene); }

double memory(const Scene& scene, const Resolution& mesh) { return of_mesh(scene, mesh) + of_answer(scene) + program; }

double memory(const Scene& scene, const Contender& contender, bool timed) {
  return memory(scene, contender.resolution) + of_basis(scene, contender, timed);
}

double memory_of_modes(const Scene& scene, const Body& body, double n_modes) {
  Scene alone = scene;
  alone.bodies = {body};
  alone.contacts.clear();  // nothing is stepped
  return of_mesh(alone, body.resolution) + of_modes(n_dofs(body.shape, body.resolution, body.theory), n_modes) +
         program;
}

double memory_of_analysis(const Scene& scene, const Resolution& mesh) {
  return memory(scene, widest(scene, mesh), false);
}

double memory(const Scene& scene, const Job& job, bool timed) {
  timed = timed || takes_times(job);
  if (job.kind == Job::Kind::marks)
    return memory(scene, job.contender, timed) +
           std::max(answers_of_marks * of_answer(scene), timed ? of_frames(scene) : 0);
  return memory(scene, widest(scene, own_meshes(scene)), timed) + answers_of_analyses * of_answer(scene);
}

}  // namespace mb
