// C14: what a simulated second costs in instructions, beside the time it takes here.
//
//   MIPS for real time = instructions / simulated time / 1e6,   claimed about 1
#include <fmt/format.h>

#include <cmath>

#include "cases/scene/read_toml.h"
#include "harness/analysis/analyses.h"
#include "harness/analysis/instruction_contest.h"
#include "harness/analysis/modal_body.h"
#include "harness/commands/find_cases.h"
#include "harness/instruction_counter.h"
#include "harness/measure.h"
#include "harness/study/identity.h"

namespace mb {

namespace {

constexpr double at_most = 300;  // [s] that counting may take
constexpr double about = 2;      // [-] a factor by which "about one" is still one

Finding instruction_table(const std::string& missing) {
  std::string note =
      "Instructions of stepping and of displacements at the frames, counted by valgrind's callgrind on the program "
      "that is timed; what is prepared before is not counted. MIPS for real time: million instructions a simulated "
      "second, claimed about 1; at most 2 holds. Flight is in closed form, so that a longer fall makes a second "
      "cheaper; a step: the same over the steps in contact. Times are medians, of full order a single run's. Full "
      "order: the bodies' own meshes by newmark, counted over the first twentieth of the time after the first touch, "
      "in contact, where a step costs most, and extrapolated by the number of steps: an estimate from above.";
  if (!missing.empty()) note += " Not counted: " + missing + ".";
  return table("instructions", "instructions", "Instructions a simulated second", note,
               {{"claim", ""},
                {"contender", ""},
                {"modes r", ""},
                {"dt", "s"},
                {"steps", ""},
                {"share counted", "-"},
                {"instructions", "1e6"},
                {"a step", "1e6"},
                {"MIPS for real time", "1e6/s"},
                {"time", "s"},
                {"real-time factor", "-"},
                {"verdict", ""}});
}

std::string verdict(double mips) {
  if (std::isnan(mips)) return "not decided: not counted";
  if (mips <= about) return "holds";
  return fmt::format("does not hold: {:.3g} million instructions a simulated second, not about 1", mips);
}

// What is counted is read from a file, by another process.
InstructionCounts counts_of(const Scene& scene, const Vocabulary& vocabulary) try {
  const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "modalbench";
  if (!std::filesystem::exists(program)) return {{}, "no program modalbench stands beside this one"};
  const auto file = std::filesystem::absolute(find_case(scene.name));
  if (analysis_hash(read_toml(file, vocabulary, scene.profile), "instructions") != analysis_hash(scene, "instructions"))
    return {{}, "the case that is found by its name is another one, or --set changed it"};
  return count_instructions(program, {"count", file.string(), "--profile", scene.profile}, at_most);
} catch (const UsageError&) {
  return {{}, "the case is not found by its name"};
} catch (const CaseErrors&) {
  return {{}, "the case that is found by its name is another one, with errors"};
}

}  // namespace

std::vector<Finding> instructions(const AnalysisContext& context) {
  const Scene& scene = *context.scene;
  const InstructionCounts counts = counts_of(scene, context.catalogue.vocabulary());
  Finding found = instruction_table(counts.missing);
  const Model& model = context.model(own_meshes(scene));
  for (const CountedContender& contender : counted_contenders(scene)) {
    const auto prepared = prepare(contender, context.catalogue, model);
    CountedContender whole = contender;
    whole.until = scene.duration;
    const VectorXd part = counted_times(scene, contender), all = counted_times(scene, whole);
    const bool full = contender.method == "full-order";
    Trajectory answer;
    const auto work = [&] { answer = counted_work(*prepared, all); };
    const double time = full ? seconds(work) : (work(), measure(work).median);
    const double n_steps = static_cast<double>(answer.work.steps);
    const double share = full ? static_cast<double>(counted_work(*prepared, part).work.steps) / n_steps : 1;
    const auto of = counts.by_name.find(contender.name);
    const double millions = of == counts.by_name.end() ? std::nan("") : of->second / share / 1e6;
    const double mips = millions / scene.duration;
    const bool claims = contender.name == "quadratic" || contender.name == "linear" || contender.name == "rigid";
    found.rows.push_back({claims ? "C14" : "", contender.name, full ? not_applicable() : count(prepared->modes_used()),
                          contender.settings.time_step, n_steps, share, millions, millions / n_steps, mips, time,
                          scene.duration / time, claims ? verdict(mips) : std::string()});
  }
  return {found};
}

}  // namespace mb
