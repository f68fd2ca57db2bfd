// A scene: what happens, stated once, simulated in full by the truth. Values only; read_toml makes them from a case
// file.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mechanics/contact/rigid_surface.h"
#include "mechanics/geometry/patch.h"
#include "mechanics/geometry/pose.h"
#include "mechanics/geometry/shape.h"
#include "mechanics/history/history.h"
#include "mechanics/material/damping.h"
#include "mechanics/material/elasticity.h"

namespace mb {

// Hexahedra of degree 1 to 4. cells: box {along x, along y, along z}; cylinder {edge splits of the five blocks of the
// disc (a power of two), layers along z}: 5 splits^2 layers cells, or {0, layers}: the disc is one block; sphere {edge
// splits of its seven blocks (a power of two)}.
// graded: so many times every cell near the first touch of each contact is halved in all directions, cells nearer
// more often (reference/fem/grading.h).
// Of a body of beam or plate theory: degree 1, cells the numbers of half waves {along x} or {along x, along y}.
struct Resolution {
  int degree;              // in [1, 4]
  std::vector<int> cells;  // each in [1, 1024]; splits of a cylinder also 0
  int graded = 0;          // in [0, 12]; only in scenes with contact
  // Of boxes: the last cell's edge over the first's along x, y, z, the others between in geometric progression;
  // none: 1.
  std::vector<double> bias = {};  // each in [1e-3, 1e3]
  // Of boxes: so much of the shortest edge beside it every vertex is moved at random along each axis, within its face.
  double distorted = 0;  // [-] in [0, 0.4]
  // Where it stands for a whole scene: of the bodies after the first, in the scene's order.
  std::vector<Resolution> others = {};
};
bool operator==(const Resolution&, const Resolution&);
std::string to_string(const Resolution& resolution);  // "Q4 1x4", of two bodies "Q3 2 graded 1 + Q2 24x2x1"
// That of one body, by its place in the scene, of a whole scene's.
Resolution of_body(const Resolution& scene_mesh, std::size_t body);

// A base that moves as a rigid whole: u(t) is the displacement relative to it, and every point of the body feels the
// d'Alembert force -rho a(t) direction. Damping acts on the relative velocity.
struct Drive {
  Vector3d direction;   // [-] unit
  History acceleration; /* [m/s^2] of the base along the direction, from rest */
};

struct Support {
  enum class Kind { fixed, sliding, mean, diaphragm, driven };
  // u = 0; u.n = 0; area mean of w u.n = 0; u - n (u.n) = 0; u = 0 relative to the moving base
  Kind kind;
  Patch patch;                               // all but mean: a whole face (sliding and diaphragm: a plane one)
  std::optional<Drive> drive = std::nullopt; /* of driven supports; all of a body state the same */
};

// How a body deforms: as a solid, or as the theory of thin bodies has it, which states its supports, too: an
// Euler-Bernoulli beam is a box along x that bends along z, simply supported at both ends; a Kirchhoff plate is a box
// thin along z, simply supported on its four edges (reference/theory/theory_model.h).
enum class Theory { solid, euler_bernoulli, kirchhoff };
const char* to_string(Theory theory);  // "solid", "euler-bernoulli", "kirchhoff"

// Whether strains are small or of any size. Finite: a compressible neo-Hookean body (mechanics/material/neo_hookean.h),
// of full order; methods that reduce take it as linear about rest. Of isotropic solids with Rayleigh damping.
enum class Kinematics { linear, finite };
const char* to_string(Kinematics kinematics);  // "linear", "finite"

// A damper between the body and the ground, spread over a patch: with v the patch's mean velocity, weighted as it is,
//
//   force on the body = -c (v . n) n
struct Dashpot {
  Patch patch;
  Vector3d direction; /* n [-] unit, body frame */
  double damping;     /* c [N s/m] > 0 */
};

struct Body {
  std::string name;
  Shape shape;
  Material material;
  Rayleigh damping;
  std::vector<double> damping_ratios;  // [-] in [0, 1e9]: of the first elastic modes, in the place of Rayleigh's
  Resolution resolution;               // the mesh of the `same_mesh` truth and of the modal contenders
  std::vector<Support> supports;
  Pose pose = {};   // at t = 0, of the frame in which the shape is centred
  Twist twist = {}; /* at t = 0 */
  Theory theory = Theory::solid;
  Kinematics kinematics = Kinematics::linear;
  bool settled = false;                // at t = 0 in equilibrium with its weight, at rest; of bodies with supports
  std::vector<Dashpot> dashpots = {};  // of bodies with supports that touch nothing, of linear kinematics
};
bool is_held(const Body& body);  // by supports or by its theory: its frame stands still

// Makes an obstacle a ball that moves along z alone, as a rigid one: at t = 0 it touches the middle of a body's top
// face and comes down. Its elasticity counts in Hertz's law.
struct Striker {
  double mass;            // m [kg] > 0
  double speed;           // v [m/s] > 0, along -z
  double youngs_modulus;  // [Pa] > 0
  double poissons_ratio;  /* [-] in (-1, 1/2) */
};

// A rigid thing that stands still, or strikes.
struct Obstacle {
  std::string name;
  RigidSurface surface;
  std::optional<Striker> striker = std::nullopt;  // then the surface is a sphere, where it is at t = 0
};

// penalty: a layer on the body's surface, whose meshes and modes carry the local compliance. hertz: lumped, that of
// both bodies in one point, F = k delta^(3/2): for theories, which have no local compliance.
enum class ContactLaw { penalty, hertz };

// What happens where a body meets an obstacle or another body: points of the surface of `body` feel the law
// (mechanics/contact/law.h), and what they meet feels the opposite.
struct ContactPair {
  std::string body, obstacle;  // the latter the name of either
  double stiffness;            // k_n [Pa/m], of hertz k [N/m^1.5]; 0: auto, from the bodies and the size of the contact
  double damping = 0;          // d [s/m]
  double friction = 0;         // mu [-]; 0: frictionless
  double slip_speed = 0;       // v_eps [m/s] of friction
  ContactLaw law = ContactLaw::penalty;
};

struct Traction {
  std::string body;
  Patch patch;
  Vector3d traction;    // [Pa] dead load per reference area, times the patch weight
  double pressure = 0;  // [Pa] adds -pressure n, n the reference normal
};
struct Load {
  std::string name;
  History history;
  std::vector<Traction> tractions;  // one spatial pattern, one history
  // Whether it turns with its body's frame; else it keeps the axes of the start. Of free bodies of finite kinematics.
  bool follows = false;
};

struct Probe {
  std::string name, body;
  Vector3d point;      // [m] body frame
  Vector3d direction;  // [-] unit; the signal is u(point) . direction
};

// Full-order contenders: every degree x cells x time step, or x tolerance for adaptive integrators; without degrees and
// cells on the bodies' own meshes.
struct Rival {
  std::string integrator;
  std::vector<int> degrees;
  std::vector<std::vector<int>> cells;
  std::vector<double> time_steps;           // [s]; one of the two is empty
  std::vector<double> relative_tolerances;  // [-]
  int graded = 0;                           // of all its meshes, as that of a resolution
  // Those of the second body, as many as `cells` has, at the same degrees; none: its own mesh, as all further bodies.
  std::vector<std::vector<int>> second_cells = {};
};
// Reduced contenders that step with another integrator than the closed form: every method x mode count x time step or
// tolerance.
struct Stepping {
  std::string integrator;
  std::vector<std::string> methods;
  std::vector<int> modes;                   // not looked at by methods that take no mode count
  std::vector<double> time_steps;           // [s]; one of the two is empty
  std::vector<double> relative_tolerances;  // [-]
};
// What a free body's spin does to its modes and they to it (modal/frame/spin.h): nothing, everything, or all but the
// stiffening by stresses that rotation brings.
enum class RotationCoupling { rigid, coupled, unstiffened };
const char* to_string(RotationCoupling rotation);

struct Study {
  std::vector<std::string> methods;  // reduced methods in closed form, each at every mode count if it takes one
  std::vector<int> modes;            // elastic modes r >= 0; rigid modes always stay
  // [s] steps while bodies touch, of methods in closed form; only in scenes with contact
  std::vector<double> contact_steps;
  std::vector<RotationCoupling> rotations{RotationCoupling::rigid};  // of methods in closed form, each with each
  std::vector<Stepping> steppings;
  std::vector<Rival> rivals;
  std::vector<std::string> analyses;  // what else is found out: names of the catalogue of analyses
  double load_tolerance = 1e-5;       // [-] of resampling chirps and expressions, relative to their peak
};

struct TruthSettings {
  double relative_tolerance;  // [-] of the adaptive integration, in [1e-12, 1e-2]; error bars take a hundredth of it
  Resolution finer, coarser;  // truth `finer` and its neighbour, which tells its discretisation bar: of all bodies
  std::string exact;          // name of a closed form (cases/exact/exact.h), or ""
};

// Published natural frequencies of the first body, for the analysis `frequencies`.
struct ReferenceFrequencies {
  std::vector<double> hertz;  // [1/s] elastic, ascending, multiplets as often as they occur
  double uncertainty = 0;     // [-] relative
};

// What must hold; decides exit codes. Exactly one of at_most, at_least and status. Of runs: method, modes, rotation,
// integrator, time_step, and metric and truth or status. Of a table that an analysis makes: table and column, every row
// of it, or those whose first cell is `row`.
struct Check {
  std::string table, column, row;     // "" where the check is of runs
  std::string method, metric, truth;  // truth: a TruthKind, by name
  int modes;                          // 0 for methods that take no mode count
  std::optional<double> at_most, at_least;
  std::string why;
  std::string rotation = {};               // the coupling, or "": of all in the study
  std::string integrator = {};             // or "": the closed form, and of full order all
  std::optional<double> time_step = {};    // [s] of fixed steps; nothing: all
  std::vector<std::string> profiles = {};  // in which it is asked
  std::string status = {};                 // what all of the runs must end in, "unstable"; "": as metric and bound say
  std::string reference = {}, kind = {};   // of a table: what this number is held to; "": as the table says
};
std::string runs_of(const Check& check);  // "eigenmodes r=16 newmark dt=0.001 s"; "" of a table

struct Scene {
  std::string name, title, purpose, source;
  std::string exercises;                                          // what of the suite the case tries, one line
  std::string hard;                                               // of hard cases: what is hard, what must hold
  std::vector<std::string> runs_in{"quick", "standard", "full"};  // profiles in which it runs where none is named
  std::vector<Body> bodies;
  std::vector<Load> loads;
  Vector3d gravity = Vector3d::Zero();  // [m/s^2]
  std::vector<Obstacle> obstacles;
  std::vector<ContactPair> contacts;
  std::vector<Probe> probes;
  double duration;            // [s] of the profile asked for
  double frame_rate;          // [1/s] frames: aliasing, motion and timed runs
  double samples_per_second;  // [1/s] error measures
  double samples_from = 0;    // [s] error measures begin then: of contact alone, after the flight before
  TruthSettings truth;
  Study study;
  std::vector<Check> checks;
  ReferenceFrequencies reference_frequencies;
  std::string profile;  // "quick", "standard" or "full"
};

// The obstacle that strikes the body; nullptr: none does.
const Obstacle* striker_of(const Scene& scene, const Body& body);
// The body that another meets in this contact; nullptr: it meets an obstacle.
const Body* partner_of(const Scene& scene, const ContactPair& pair);
Resolution own_meshes(const Scene& scene);        // the bodies' own, of the whole scene
Scene on_meshes(Scene scene, Resolution meshes);  // with these for its bodies' own; of the whole scene

VectorXd frame_times(const Scene& scene);   // [s] 0, 1/rate, ... up to the duration
VectorXd sample_times(const Scene& scene);  // [s] likewise at samples_per_second, those from samples_from on

}  // namespace mb
