// Case files: whatever the bytes, they read, or problems are told in characters that print. A scene that reads keeps to
// the bounds of the format, and reads the same again.
#include <algorithm>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>

#include "cases/scene/case_files.h"
#include "cases/scene/printable.h"
#include "cases/scene/resolution.h"

namespace {

using namespace mb;

void require(bool holds, const char* property) {
  if (!holds) throw std::logic_error(property);
}

bool is_name(const std::string& text) {
  return !text.empty() && text.size() <= 64 && text.front() != '-' &&
         std::ranges::all_of(text, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; });
}

bool prints(const std::string& line) { return printable(line, line.size()) == line; }

bool lines_print(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (!prints(line)) return false;
  return true;
}

void require_texts_print(const Scene& scene) {
  for (const std::string* text : {&scene.title, &scene.exercises})
    require(prints(*text), "a title that does not print");
  for (const std::string* text : {&scene.purpose, &scene.source, &scene.hard})
    require(!unprintable(*text, true), "prose that does not print");
  for (const Check& check : scene.checks) {
    require(prints(check.column) && prints(check.row) && prints(check.reference), "a check that does not print");
    require(!unprintable(check.why, true), "a reason that does not print");
  }
}

void require_bounds(const Scene& scene) {
  require(is_name(scene.name), "a scene's name is none");
  require(!scene.bodies.empty(), "a scene without bodies");
  for (const Body& body : scene.bodies) {
    require(is_name(body.name), "a body's name is none");
    const double n = n_dofs(body.shape, body.resolution, body.theory);
    require(n > 0 && n <= most_dofs, "a mesh beyond the limit");
  }
  for (const Load& load : scene.loads) require(is_name(load.name), "a load's name is none");
  for (const Obstacle& obstacle : scene.obstacles) require(is_name(obstacle.name), "an obstacle's name is none");
  for (const Probe& probe : scene.probes) require(is_name(probe.name), "a probe's name is none");
  require(scene.duration > 0 && scene.frame_rate > 0 && scene.samples_per_second > 0, "no times to look at");
  for (const Resolution& mesh : {scene.truth.finer, scene.truth.coarser})
    require(mesh.others.size() + 1 == scene.bodies.size(), "a truth that is not of all bodies");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    const Scene scene = test::read(text);
    require_bounds(scene);
    require_texts_print(scene);
    require(canonical(test::read(text)) == canonical(scene), "another scene the second time");
  } catch (const CaseErrors& errors) {
    require(!errors.diagnostics().empty(), "refused without a reason");
    require(lines_print(errors.what()), "a message that does not print");
  }
  return 0;
}
