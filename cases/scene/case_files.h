// What tests of case files share: the words that the harness's catalogues supply, files of the source tree, and text
// read as a case.
#pragma once

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "cases/scene/read_scene.h"

namespace mb::test {

inline Vocabulary vocabulary() {
  return {{"eigenmodes", "static-correction", "linear", "quadratic", "full", "full-order"},
          {"exact", "newmark", "central-difference", "explicit-euler", "symplectic-euler", "sundials"},
          {"displacement-error", "strain-error", "surface-deviation", "pose-translation", "pose-rotation",
           "probe-error", "contact-duration", "peak-force", "impulse", "restitution", "first-touch", "energy-gain",
           "energy-defect", "momentum-defect", "force-error", "momentum-drift", "free-gain"},
          {"linear", "quadratic", "full"},
          {"sundials"},
          {"newmark", "central-difference", "explicit-euler", "symplectic-euler", "sundials"},
          {"budget",   "step-limits", "stability-map",  "aliasing",       "frequency-response", "mode-amplitudes",
           "damping",  "frequencies", "probe-extremes", "collision-cost", "contact-forces",     "contact-stiffness",
           "contact",  "flight-cost", "amplitude",      "instructions",   "slenderness",        "damping-coupling",
           "long-run", "multiplets",  "locking",        "linearity",      "contact-stability",  "aspect"},
          {"stability-map", "aliasing", "frequency-response", "probe-extremes", "damping", "slenderness",
           "damping-coupling", "long-run", "locking", "linearity", "aspect"},
          {"contact-stiffness", "contact", "flight-cost", "amplitude", "instructions", "contact-stability"},
          {"step-limits"},
          {"contact-stiffness"},
          {"displacement-error", "strain-error", "surface-deviation", "pose-translation", "pose-rotation",
           "probe-error", "probe-magnitude", "probe-phase", "probe-combined", "probe-von-mises"},
          // Those that checks of the suite's cases name.
          {{"budget", "budget"},
           {"step-limits", "step-limits"},
           {"step-limit-runs", "step-limits"},
           {"step-limit-summary", "step-limits"},
           {"stability-summary", "stability-map"},
           {"damping", "damping"},
           {"damping-coupling", "damping-coupling"},
           {"damping-coupling-modes", "damping-coupling"},
           {"aspect", "aspect"},
           {"long-run", "long-run"},
           {"locking-growth", "locking"},
           {"locking-dynamics", "locking"},
           {"linearity", "linearity"},
           {"multiplets", "multiplets"},
           {"multiplets-kept", "multiplets"},
           {"multiplets-answers", "multiplets"},
           {"frequencies", "frequencies"},
           {"frequency-response-peaks", "frequency-response"},
           {"probe-extremes", "probe-extremes"},
           {"slenderness", "slenderness"},
           {"contact-meetings", "contact"},
           {"contact-stability-summary", "contact-stability"},
           {"corrected-stability-summary", "contact-stability"}}};
}

inline std::filesystem::path cases_folder() { return std::filesystem::path(MB_SOURCE_DIR) / "cases"; }

inline std::string content(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

// A cylinder under compression, to be changed line by line.
inline std::string cylinder_text() { return content(cases_folder() / "scene/example.toml"); }

// A ball that falls on a step: every key of a scene with contact.
inline std::string contact_text() { return content(cases_folder() / "scene/example_contact.toml"); }

// The text with one passage replaced; throws where it does not stand there exactly once, so that no test is void.
inline std::string with(std::string text, const std::string& passage, const std::string& replacement) {
  const std::size_t at = text.find(passage);
  if (at == std::string::npos || text.find(passage, at + 1) != std::string::npos) {
    throw std::logic_error("not exactly once in the text: " + passage);
  }
  return text.replace(at, passage.size(), replacement);
}

inline Scene read(const std::string& text, const std::string& profile = "quick") {
  return read_scene(text, "test.toml", cases_folder(), vocabulary(), profile);
}

// All messages, or nothing where the text reads. The file's folder is left out of them.
inline std::string problems(const std::filesystem::path& file) {
  try {
    read_toml(file, vocabulary());
    return "";
  } catch (const CaseErrors& errors) {
    std::string all;
    for (Diagnostic diagnostic : errors.diagnostics()) {
      diagnostic.file = file.filename().string();
      all += to_string(diagnostic);
    }
    return all;
  }
}

inline std::string problems_of_text(const std::string& text) {
  try {
    read(text);
    return "";
  } catch (const CaseErrors& errors) {
    return errors.what();
  }
}

}  // namespace mb::test
