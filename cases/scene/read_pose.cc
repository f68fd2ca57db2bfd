#include "cases/scene/read_pose.h"

#include "cases/scene/read_direction.h"

namespace mb {

namespace {

const Range position_range{-1e4, 1e4, "m"};
const Range angle_range{-7, 7, "rad"};  // a whole turn either way
const Range velocity_range{-1e4, 1e4, "m/s"};
const Range angular_velocity_range{-1e6, 1e6, "rad/s"};

std::optional<Eigen::Quaterniond> read_orientation(Section& section) {
  const bool has_axis = section.has("axis"), has_angle = section.has("angle");
  if (!has_axis && !has_angle) return Eigen::Quaterniond::Identity();
  const auto axis = read_direction(section, "axis");
  const auto angle = has_angle ? section.number("angle", angle_range) : std::optional(0.0);
  if (!axis || !angle) return std::nullopt;
  return Eigen::Quaterniond(Eigen::AngleAxisd(*angle, *axis));
}

}  // namespace

std::optional<Pose> read_pose(Section& section, const std::string& key) {
  if (!section.has(key)) return Pose{};
  auto table = section.section(key);
  if (!table) return std::nullopt;
  const auto position = table->vector_or_zero("position", position_range);
  const auto orientation = read_orientation(*table);
  table->finish();
  if (!position || !orientation) return std::nullopt;
  return Pose{*position, *orientation};
}

std::optional<Twist> read_twist(Section& section) {
  const auto velocity = section.vector_or_zero("velocity", velocity_range);
  const auto angular_velocity = section.vector_or_zero("angular_velocity", angular_velocity_range);
  if (!velocity || !angular_velocity) return std::nullopt;
  return Twist{*velocity, *angular_velocity};
}

}  // namespace mb
