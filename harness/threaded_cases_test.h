// Small cases, each with something of its own that threads could make differ.
#pragma once

namespace mb::faults {

// Damping that couples the modes, and the map of steps by every integrator.
inline constexpr const char* dashpot_case = R"(schema = 1
name = "damper"
title = "t"
purpose = "p"
source = "s"
[time]
duration = 0.1
frame_rate = 60
samples_per_second = 200
[[body]]
name = "bar"
[body.shape]
kind = "box"
size = [0.05, 0.06, 0.2]
[body.material]
youngs_modulus = 2e4
poissons_ratio = 0.3
density = 1100
[body.damping]
beta = 1e-4
[body.resolution]
degree = 2
cells = [1, 1, 3]
[[body.support]]
kind = "fixed"
face = "z-min"
[[body.dashpot]]
face = "z-max"
direction = [0.6, 0, 0.8]
damping = 2
[[load]]
name = "knock"
history = { kind = "pulse", duration = 0.02 }
[[load.traction]]
body = "bar"
face = "x-max"
traction = [-40, 10, 16]
[truth]
relative_tolerance = 1e-5
finer = { degree = 3, cells = [2, 2, 6] }
coarser = { degree = 2, cells = [2, 2, 6] }
[study]
methods = ["eigenmodes"]
modes = [4, 16]
analyses = ["damping-coupling", "stability-map"]
[[study.rival]]
integrator = "newmark"
degrees = [2]
cells = [[1, 1, 3]]
time_steps = [0.005]
)";

// A box that falls flat and rebounds, by kicks.
inline constexpr const char* contact_case = R"(schema = 1
name = "bounce"
title = "t"
purpose = "p"
source = "s"
gravity = [0, 0, -9.81]
[time]
duration = 0.04
frame_rate = 60
samples_per_second = 1000
[[body]]
name = "box"
pose = { position = [0, 0, 0.0301] }
velocity = [0, 0, -0.3]
[body.shape]
kind = "box"
size = [0.1, 0.08, 0.06]
[body.material]
youngs_modulus = 1e5
poissons_ratio = 0.3
density = 1000
[body.resolution]
degree = 2
cells = [2, 2, 2]
[[obstacle]]
name = "floor"
shape = { kind = "half-space" }
[[contact]]
body = "box"
obstacle = "floor"
stiffness = "auto"
[truth]
relative_tolerance = 1e-4
finer = { degree = 2, cells = [4, 4, 4] }
coarser = { degree = 2, cells = [2, 2, 2] }
[study]
methods = ["eigenmodes", "static-correction"]
modes = [12]
contact_steps = [5e-5]
analyses = ["contact-stability"]
)";

// A free rod of finite strain that is spun up: modes coupled by rotation, loads that turn with it.
inline constexpr const char* turning_case = R"(schema = 1
name = "turning"
title = "t"
purpose = "p"
source = "s"
[time]
duration = 0.2
frame_rate = 60
samples_per_second = 200
[[body]]
name = "rod"
kinematics = "finite"
[body.shape]
kind = "box"
size = [0.3, 0.05, 0.04]
[body.material]
youngs_modulus = 1e6
poissons_ratio = 0.3
density = 1000
[body.damping]
beta = 1e-3
[body.resolution]
degree = 2
cells = [6, 1, 1]
[[load]]
name = "thruster"
axes = "body"
history = { kind = "pulse", duration = 0.2 }
[[load.traction]]
body = "rod"
face = "x-max"
traction = [0, 300, 0]
[[load.traction]]
body = "rod"
face = "x-min"
traction = [0, -300, 0]
[truth]
relative_tolerance = 1e-4
finer = { degree = 3, cells = [6, 1, 1] }
coarser = { degree = 2, cells = [6, 1, 1] }
[study]
methods = ["eigenmodes"]
modes = [4, 12]
rotation = ["coupled"]
[[study.rival]]
integrator = "newmark"
degrees = [2]
cells = [[6, 1, 1]]
time_steps = [0.005]
)";

// Two free bodies that meet: surfaces of two meshes.
inline constexpr const char* collision_case = R"(schema = 1
name = "collision"
title = "t"
purpose = "p"
source = "s"
[time]
duration = 0.03
frame_rate = 60
samples_per_second = 1000
[[body]]
name = "ball"
pose = { position = [0.01, 0, 0.0801] }
velocity = [0, 0, -0.5]
[body.shape]
kind = "sphere"
radius = 0.05
[body.material]
youngs_modulus = 1e5
poissons_ratio = 0.3
density = 1000
[body.damping]
beta = 1e-4
[body.resolution]
degree = 1
cells = [2]
[[body]]
name = "block"
[body.shape]
kind = "box"
size = [0.1, 0.08, 0.06]
[body.material]
youngs_modulus = 1e5
poissons_ratio = 0.3
density = 1000
[body.damping]
beta = 1e-4
[body.resolution]
degree = 2
cells = [2, 2, 2]
[[contact]]
body = "ball"
obstacle = "block"
stiffness = "auto"
[truth]
relative_tolerance = 1e-4
finer = { degree = 2, cells = [2], graded = 1, others = { block = { degree = 2, cells = [3, 3, 3] } } }
coarser = { degree = 1, cells = [2], others = { block = { degree = 2, cells = [2, 2, 2] } } }
[study]
methods = ["eigenmodes", "static-correction"]
modes = [12]
contact_steps = [5e-5]
)";

}  // namespace mb::faults
