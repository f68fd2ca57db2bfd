#include "cases/scene/read_direction.h"

#include <fmt/format.h>

namespace mb {

std::optional<Vector3d> read_direction(Section& section, const std::string& key) {
  const auto direction = section.vector(key, {-1e6, 1e6});
  if (!direction) return std::nullopt;
  if (direction->norm() >= 1e-6) return direction->normalized();
  // below, its digits are mostly rounding of what was meant to be zero
  section.error(key, fmt::format("'{}' is zero: it points nowhere", key));
  return std::nullopt;
}

}  // namespace mb
