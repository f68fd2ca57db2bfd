// What presses on the bodies of a scene besides loads: gravity, how they start, obstacles and contacts.
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "cases/contract/touchdown.h"
#include "reports/case_words.h"
#include "reports/number.h"
#include "reports/words.h"

namespace mb {
namespace {

// "ball starts at (0, 0, 5) m, with velocity (0, 0, -3.13) m/s"; "" of what stands still in a scene without contact.
std::string start_of(const Scene& scene, const Body& body) {
  const auto& [velocity, spin] = body.twist;
  std::vector<std::string> rates;
  if (!velocity.isZero(0)) rates.push_back("velocity " + in(velocity, "m/s"));
  if (!spin.isZero(0)) rates.push_back("spin " + in(spin, "rad/s"));
  if (scene.contacts.empty() && rates.empty()) return "";
  const std::string still = body.settled ? "at rest, bent by its weight" : "at rest";
  const std::string moving = rates.empty() ? still : "with " + joined(rates, " and ");
  return body.name + " starts " + joined({scene.contacts.empty() ? "" : placed(body.pose), moving}, ", ");
}

std::string describe(const Obstacle& obstacle) {
  const std::string what = "Obstacle " + obstacle.name + ": " + describe(obstacle.surface);
  if (!obstacle.striker) return what;
  const Striker& ball = *obstacle.striker;
  return what + "; it strikes with mass " + in(ball.mass, "kg") + " and speed " + in(ball.speed, "m/s") +
         " along -z; E = " + in(ball.youngs_modulus, "Pa") + ", nu = " + format_setting(ball.poissons_ratio);
}

using Meetings = std::vector<std::optional<Meeting>>;  // one a contact, in the scene's order

Meetings meetings_of(const Scene& scene) {
  Meetings all(scene.contacts.size());
  for (const Body& body : scene.bodies) {
    try {
      for (const Meeting& one : touchdown(scene, body).meetings) all.at(one.contact) = one;
    } catch (const std::logic_error&) {  // the scene is not valid: nothing is known of this body's contacts
    }
  }
  return all;
}

// "penalty per area, k = 9.31e9 Pa/m (auto)", "Hertz's law, lumped, k = 1e9 N/m^1.5 (given)"
std::string law_of(const ContactPair& pair, const std::optional<Meeting>& meeting) {
  const bool lumped = pair.law == ContactLaw::hertz;
  const std::string unit = lumped ? " N/m^1.5" : " Pa/m", law = lumped ? "Hertz's law, lumped" : "penalty per area";
  if (pair.stiffness > 0) return law + ", k = " + format_setting(pair.stiffness) + unit + " (given)";
  return law + (meeting ? ", k = " + format_number(meeting->size.stiffness) + unit + " (auto)" : ", k auto");
}

// Whether it touches in motion. The speed of ContactSize is otherwise what its size was estimated with, that of an
// impact as deep as the weight presses.
bool comes_in_motion(const Scene& scene, const ContactPair& pair, const Meeting& meeting) {
  if (partner_of(scene, pair) || obstacle_of(scene, pair).striker) return true;
  const auto body = std::ranges::find(scene.bodies, pair.body, &Body::name);
  const bool at_rest = body->twist.velocity.isZero(0) && body->twist.angular_velocity.isZero(0);
  return std::isfinite(meeting.t) && !(meeting.t == 0 && at_rest);
}

std::string size_of(const Scene& scene, const ContactPair& pair, const Meeting& meeting) {
  const bool touches = std::isfinite(meeting.t);
  const std::string when = touches ? "first touch at " + format_number(meeting.t) + " s"
                                   : "no touch within " + in(scene.duration, "s") + " unless deformed";
  return "expected radius a = " + format_number(meeting.size.radius) + " m, " +
         (comes_in_motion(scene, pair, meeting) ? "approach at " : "as of an approach at ") +
         format_number(meeting.size.speed) + " m/s, " + when;
}

std::string describe(const Scene& scene, const ContactPair& pair, const std::optional<Meeting>& meeting) {
  const std::string damping = pair.damping > 0 ? "damping " + in(pair.damping, "s/m") : "undamped";
  const std::string friction =
      pair.friction > 0 ? "friction " + format_setting(pair.friction) + " regularised at " + in(pair.slip_speed, "m/s")
                        : "frictionless";
  return "Contact of " + pair.body + " with " + pair.obstacle + ": " +
         joined(
             {joined({law_of(pair, meeting), damping, friction}, ", "), meeting ? size_of(scene, pair, *meeting) : ""},
             "; ");
}

}  // namespace

std::vector<std::string> contact_sentences(const Scene& scene) {
  std::vector<std::string> all;
  if (!scene.gravity.isZero(0)) all.push_back("Gravity " + in(scene.gravity, "m/s^2"));
  for (const Body& body : scene.bodies) {
    if (std::string start = start_of(scene, body); !start.empty()) all.push_back(std::move(start));
  }
  for (const Obstacle& obstacle : scene.obstacles) all.push_back(describe(obstacle));
  const Meetings meetings = meetings_of(scene);
  for (std::size_t i = 0; i < scene.contacts.size(); ++i) {
    all.push_back(describe(scene, scene.contacts[i], meetings[i]));
  }
  return all;
}

}  // namespace mb
