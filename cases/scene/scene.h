// A scene: what happens, stated once, simulated in full by the truth. Values only; read_toml makes them from a case
// file.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/geometry/patch.h"
#include "mechanics/geometry/shape.h"
#include "mechanics/history/history.h"
#include "mechanics/material/damping.h"
#include "mechanics/material/elasticity.h"

namespace mb {

// Hexahedra of degree 1 to 4. cells: box {along x, along y, along z}; cylinder {edge splits of the five blocks of the
// disc (a power of two), layers along z}: 5 splits^2 layers cells; sphere {edge splits of its seven blocks (a power of
// two)}.
struct Resolution {
  int degree;              // in [1, 4]
  std::vector<int> cells;  // each in [1, 256]
};
bool operator==(const Resolution&, const Resolution&);
std::string to_string(const Resolution& resolution);  // "Q4 1x4"

struct Support {
  enum class Kind { fixed, sliding, mean };  // u = 0; u.n = 0; area mean of w u.n = 0
  Kind kind;
  Patch patch;  // fixed and sliding: a whole face (sliding: a plane one)
};

struct Body {
  std::string name;
  Shape shape;
  Material material;
  Rayleigh damping;
  Resolution resolution;  // the mesh of the `same_mesh` truth and of the modal contenders
  std::vector<Support> supports;
};

struct Traction {
  std::string body;
  Patch patch;
  Vector3d traction;  // [Pa] dead load per reference area, times the patch weight
};
struct Load {
  std::string name;
  History history;
  std::vector<Traction> tractions;  // one spatial pattern, one history
};

struct Probe {
  std::string name, body;
  Vector3d point;      // [m] body frame
  Vector3d direction;  // [-] unit; the signal is u(point) . direction
};

// Full-order contenders: every degree x cells x time step.
struct Rival {
  std::string integrator;
  std::vector<int> degrees;
  std::vector<std::vector<int>> cells;
  std::vector<double> time_steps;  // [s]
};
struct Study {
  std::vector<std::string> methods;  // reduced methods, each at every mode count
  std::vector<int> modes;            // elastic modes r >= 0; rigid modes always stay
  std::vector<Rival> rivals;
  double load_tolerance = 1e-5;      // [-] of resampling chirps and expressions, relative to their peak
};

struct TruthSettings {
  double relative_tolerance;  // [-] of the adaptive integration, in [1e-12, 1e-2]; error bars take a hundredth of it
  Resolution finer, coarser;  // truth `finer` and the neighbour whose distance is its discretisation bar
};

// What must hold; decides exit codes. Exactly one of at_most and at_least.
struct Check {
  std::string method, metric, truth;  // truth: "finer" or "same_mesh"
  int modes;
  std::optional<double> at_most, at_least;
  std::string why;
};

struct Scene {
  std::string name, title, purpose, source;
  std::vector<Body> bodies;
  std::vector<Load> loads;
  std::vector<Probe> probes;
  double duration;            // [s] of the profile asked for
  double frame_rate;          // [1/s] frames: aliasing, motion and timed runs
  double samples_per_second;  // [1/s] error measures
  TruthSettings truth;
  Study study;
  std::vector<Check> checks;
  std::string profile;  // "quick", "standard" or "full"
};

VectorXd frame_times(const Scene& scene);   // [s] 0, 1/rate, ... up to the duration
VectorXd sample_times(const Scene& scene);  // [s] likewise at samples_per_second

}  // namespace mb
