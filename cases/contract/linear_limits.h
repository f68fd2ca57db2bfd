// Up to where linear theory is taken without a warning. Beyond, it is off by a per cent and more: of strain by about
// the strain itself, of the displacement of what bends by the tip's way over the length, of what turns by half the
// square of the rotation.
#pragma once

namespace mb {

inline constexpr double strain_limit = 0.01;   // [-] largest principal strain
inline constexpr double rotation_limit = 0.1;  // [rad] of a piece of the body, rigid motion taken out

}  // namespace mb
