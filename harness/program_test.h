// The program run in a folder by a test, and a case of a few hundred degrees of freedom that runs in seconds.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "harness/main.h"

namespace mb {

namespace fs = std::filesystem;

struct Said {
  int code;
  std::string out, err;
};

// Runs the program in `folder`.
inline Said modalbench(const fs::path& folder, std::vector<std::string> words,
                       const Catalogue& catalogue = default_catalogue()) {
  const fs::path before = fs::current_path();
  fs::current_path(folder);
  words.insert(words.begin(), "modalbench");
  std::vector<char*> argv;
  for (auto& word : words) argv.push_back(word.data());
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  const int code = harness_main(static_cast<int>(argv.size()), argv.data(), catalogue);
  fs::current_path(before);
  return {code, ::testing::internal::GetCapturedStdout(), ::testing::internal::GetCapturedStderr()};
}

inline std::string text(const fs::path& file) {
  std::ostringstream all;
  all << std::ifstream(file).rdbuf();
  return all.str();
}

// A case of a few hundred degrees of freedom that runs in seconds.
inline std::string small_case(const std::string& at_most = "0.5",
                              const std::string& history = R"({ kind = "pulse", duration = 0.1 })") {
  return R"(schema = 1
name = "small"
title = "t"
purpose = "p"
source = "s"
[time]
duration = 0.1
frame_rate = 60
samples_per_second = 200
[[body]]
name = "body"
[body.shape]
kind = "cylinder"
radius = 0.05
length = 0.2
[body.material]
youngs_modulus = 2e4
poissons_ratio = 0.45
density = 1100
[body.resolution]
degree = 2
cells = [1, 2]
[[load]]
name = "squeeze"
history = )" +
         history + R"(
[[load.traction]]
body = "body"
face = "z-max"
traction = [0, 0, -400]
[[load.traction]]
body = "body"
face = "z-min"
traction = [0, 0, 400]
[[probe]]
name = "top"
body = "body"
point = [0, 0, 0.1]
direction = [0, 0, 1]
[truth]
relative_tolerance = 1e-4
finer = { degree = 3, cells = [1, 2] }
coarser = { degree = 2, cells = [1, 2] }
[study]
methods = ["static-correction"]
modes = [4, 12]
[[study.rival]]
integrator = "newmark"
degrees = [1]
cells = [[1, 2]]
time_steps = [0.01, 0.005]
[[check]]
method = "static-correction"
metric = "displacement-error"
truth = "same_mesh"
modes = 12
at_most = )" +
         at_most + R"(
why = "w"
)";
}

// small_case with these lines of [study] before its check.
inline std::string small_case_with(const std::string& study) {
  std::string all = small_case();
  return all.insert(all.find("\n[[check]]"), study);
}

// A rigid box without damping that falls by a centimetre. study: lines of [study], its contact_steps at least.
inline std::string bouncing_case(const std::string& study) {
  return R"(schema = 1
name = "small"
title = "t"
purpose = "p"
source = "s"
gravity = [0, 0, -9.81]
[time]
duration = 0.5
frame_rate = 60
samples_per_second = 600
[[body]]
name = "box"
pose = { position = [0, 0, 0.06] }
[body.shape]
kind = "box"
size = [0.1, 0.1, 0.1]
[body.material]
youngs_modulus = 1e6
poissons_ratio = 0.3
density = 1000
[body.resolution]
degree = 1
cells = [1, 1, 1]
[[obstacle]]
name = "floor"
shape = { kind = "half-space" }
[[contact]]
body = "box"
obstacle = "floor"
stiffness = 1e6
[truth]
relative_tolerance = 1e-3
finer = { degree = 1, cells = [2, 2, 2] }
coarser = { degree = 1, cells = [1, 1, 1] }
[study]
methods = ["eigenmodes"]
modes = [0]
)" + study +
         "\n";
}

inline fs::path written(const fs::path& file, const std::string& content) {
  std::ofstream(file) << content;
  return file;
}

}  // namespace mb
