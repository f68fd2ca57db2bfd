// Case files: TOML in, Scene out, or every problem at once.
//
// Unknown keys are errors, and so are keys that are understood but cannot be simulated yet. Case files are untrusted:
// names match [a-z0-9][a-z0-9-]{0,63}, paths stay below the file's folder, expressions may not assign.
#pragma once

#include <filesystem>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "cases/scene/scene.h"

namespace mb {

struct Diagnostic {
  std::string file;
  int line = 0, column = 0, length = 1;  // 1-based; line 0: the file as a whole
  std::string message;                   // one sentence with the value, its range and unit
  std::string excerpt;                   // the line of the case file, control characters replaced
  std::string help;                      // "did you mean 'youngs_modulus'?", or empty
};
// bad.toml:3:1: error: unknown key 'youngs_modulos' in [body.material]  + excerpt with carets + help
std::string to_string(const Diagnostic& diagnostic);

class CaseErrors : public std::runtime_error {
 public:
  explicit CaseErrors(std::vector<Diagnostic> found);
  const std::vector<Diagnostic>& diagnostics() const { return diagnostics_; }  // sorted by line, column

 private:
  std::vector<Diagnostic> diagnostics_;
};

// Names that a case may use; the catalogues of the harness supply them.
struct Vocabulary {
  std::vector<std::string> methods, integrators, metrics;
  std::vector<std::string> methods_without_modes;  // of methods: those that take no mode count
  std::vector<std::string> adaptive_integrators;   // of integrators: those that take a tolerance instead of a step
  std::vector<std::string> impact_integrators;     // of integrators: of full order in contact or of finite kinematics
  std::vector<std::string> analyses;
  std::vector<std::string> analyses_of_loads = {};         // of analyses: those of scenes without contact
  std::vector<std::string> analyses_of_contact = {};       // of analyses: those of scenes with it
  std::vector<std::string> analyses_of_single_modes = {};  // of analyses: not where a dashpot couples modes
  std::vector<std::string> analyses_of_theories = {};      /* of analyses: those that take beam and plate theory */
  std::vector<std::string> metrics_of_steps = {};          // of metrics: those that truth same_modes is asked in
  std::map<std::string, std::string> tables = {};          // that checks may name: the analysis that makes each
};

// profile: "quick", "standard" or "full". Throws CaseErrors.
Scene read_toml(const std::filesystem::path& file, const Vocabulary& vocabulary, const std::string& profile = "quick");

// What determines a run, as canonical text (no prose, no checks): the content that hashes name.
std::string canonical(const Scene& scene);

}  // namespace mb
