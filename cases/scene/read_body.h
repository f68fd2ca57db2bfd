// [[body]]: theory, shape, material, damping, resolution, supports, dashpots, and how it starts.
#pragma once

#include "cases/scene/read_dashpot.h"
#include "cases/scene/read_material.h"
#include "cases/scene/read_pose.h"
#include "cases/scene/read_support.h"
#include "cases/scene/scene.h"

namespace mb {

// A body as far as it could be read: what refers to it is still checked where something else in it is wrong.
struct BodyDraft {
  std::optional<std::string> name;
  std::optional<Shape> shape, of_kind;  // read_shape.h
  std::optional<Material> material;
  std::optional<Resolution> resolution;
  DampingDraft damping;
  SupportDrafts supports;
  std::optional<Pose> pose = Pose{};
  std::optional<Twist> twist = Twist{};
  std::optional<Theory> theory = Theory::solid;  // nothing: wrong
  std::optional<Kinematics> kinematics = Kinematics::linear;
  bool settled = false;
  DashpotDrafts dashpots;
  std::optional<bool> touches = std::nullopt;  // whether a contact names it; nothing: not known
};

// Whether a contact names any of them; nothing: not known, nor for no bodies.
std::optional<bool> touch(const std::vector<BodyDraft>& bodies);

BodyDraft read_body(Section section, const HistoryContext& context);

// The body, of which nothing may be missing.
Body completed(const BodyDraft& draft);

}  // namespace mb
