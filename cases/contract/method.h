// What an answer is, and how contenders give it. Contenders never time, print or grade themselves.
//
//   Method::prepare (offline: eigensolve, factorise) -> Prepared::simulate (online: step, reconstruct) -> Trajectory
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "cases/contract/model.h"

namespace mb {

// Explicit settings of one contender; what a method does not use stays at its default and is not recorded.
struct Settings {
  int modes = 0;                     // elastic modes asked for
  double time_step = 0;              // [s]
  double relative_tolerance = 1e-6;  // [-]
  double load_tolerance = 1e-5;      // [-] resampling of chirps and expressions
  RotationCoupling rotation = RotationCoupling::rigid;
};

struct Sampling {
  VectorXd t;               // [s] ascending
  bool strain = true;       // whether strains are wanted, at EvaluationPoints::strained()
  bool reconstruct = true;  // whether anything is wanted at the points: false steps only, for timing
  double shutter = 0;  // [s] >= 0: answers are exact means over this interval around each time; 0: at the time itself
};

// An effect that was simulated or left out, and why.
struct Decision {
  std::string effect, subject;
  bool on;
  double estimate, tolerance;
  std::string reason;
};

struct BodyTrajectory {
  MatrixXd displacement;  // [m] 3 p x n_t at EvaluationPoints::all()
  MatrixXd strain;        // [-] 6 p x n_t at EvaluationPoints::strained(), or 0 columns where not wanted
  // In scenes with contact, else of size 0, but for energies of finite kinematics. Where there is contact displacements
  // of free bodies are x - X, from the body's frame to the world.
  ContactHistory contact = {};  // of all its obstacles together, world axes
  VectorXd energy = {};  // [J] kinetic, elastic, of the weight since t = 0 and in contacts; n_t, or 0 where not wanted
  // 6 x n_t, or 0 columns: of free bodies alone, whose supports take none. World axes, by the answer's own mass.
  MatrixXd momentum = {};  // [kg m/s] linear, less the weight's since t = 0; [kg m^2/s] angular about the origin
};
struct Trajectory {
  VectorXd t;  // [s]
  std::vector<BodyTrajectory> bodies;
  Work work;
  Status status = Status::ok;
  std::string case_name = {};  // whose it is, in a store
};

class Prepared {
 public:
  virtual ~Prepared() = default;
  virtual Trajectory simulate(const Sampling& sampling) const = 0;
  virtual std::vector<Decision> decisions() const { return {}; }
  virtual int modes_used() const { return -1; }  // elastic modes after rounding up to whole multiplets; -1: not modal
  virtual Index n_unknowns() const = 0;
  virtual double load_error() const { return 0; }  // [-] see Stepper
};

// Makes a stepper for a full or reduced system: the harness pairs integrators with systems of either kind.
struct Integrator {
  std::string name, doc;
  std::unique_ptr<Stepper> (*prepare)(const System& system, const Settings& settings, double duration);
  enum class Knob { none, time_step, tolerance } knob = Knob::time_step;  // what its accuracy is set by
  bool conditionally_stable = false;                                      // blows up beyond a largest step
  // The same in contact, from the first touch on; none: it cannot. Contacts must outlive the stepper.
  std::unique_ptr<Stepper> (*prepare_in_contact)(const System& system, const std::vector<Contact>& contacts,
                                                 const Settings& settings, double duration) = nullptr;
};

class Method {
 public:
  virtual ~Method() = default;
  virtual std::string name() const = 0;
  virtual std::string doc() const = 0;
  virtual bool takes_modes() const { return true; }  // whether settings.modes means anything to it
  // The model must outlive what is prepared.
  virtual std::unique_ptr<Prepared> prepare(const Model& model, const Settings& settings,
                                            const Integrator& integrator) const = 0;
};

}  // namespace mb
