// What parts of a scene are called: values with their units, shapes, and all that presses on bodies but loads.
#pragma once

#include <string>
#include <vector>

#include "cases/scene/scene.h"

namespace mb {

std::string in(double value, const char* unit);           // "0.05 m"
std::string in(const Vector3d& value, const char* unit);  // "(0, 0, -9.81) m/s^2"; rounding next to 0 is 0
std::string describe(const Shape& shape);                 // "sphere of radius 0.06 m"
std::string placed(const Pose& pose);                     // "at (0, 0, 0.5) m, turned by 17.2 deg about (0, 1, 0)"
std::string describe(const RigidSurface& surface);        // "half-space with normal (0, 0, 1) through (0, 0, 0) m"

// Gravity, how bodies start, obstacles and contacts, a sentence each without its full stop; none of a scene without any
// of them. The size of a contact, its speed and the time of the first touch are those of cases/contract/touchdown.h;
// they are left out where the scene is not valid.
std::vector<std::string> contact_sentences(const Scene& scene);

}  // namespace mb
