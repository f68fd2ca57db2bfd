#include <fmt/ostream.h>

#include "cases/scene/printable.h"
#include "harness/analysis/instruction_contest.h"
#include "harness/commands/commands.h"
#include "harness/commands/find_cases.h"
#include "harness/instruction_counter.h"
#include "harness/study/estimate.h"
#include "harness/study/memory.h"

namespace mb {

namespace {

constexpr double at_most = 3600;  // [s]

void require_memory_of(const CountedContender& one, const Scene& scene) try {
  require_memory(memory(scene, Contender{one.method, one.integrator, own_meshes(scene), one.settings}, true),
                 available_memory());
} catch (const std::runtime_error& error) {
  throw std::runtime_error(fmt::format("{}, {}: {}", printable(scene.name, 64), one.name, error.what()));
}

}  // namespace

int count_command(const CountOptions& options, const Catalogue& catalogue, const Console& console) {
  const auto file = find_case(options.case_name);
  const auto scene = std::make_shared<const Scene>(read_toml(file, catalogue.vocabulary(), options.profile));
  if (scene->contacts.empty() || scene->study.contact_steps.empty())
    throw UsageError(printable(scene->name, 64) + " has no contact or no contact_steps: nothing to count");
  const std::vector<CountedContender> contenders = counted_contenders(*scene);
  for (const CountedContender& one : contenders) require_memory_of(one, *scene);
  if (is_counting()) {
    count_contest(scene, catalogue);
    return 0;
  }
  const InstructionCounts counts = count_instructions(std::filesystem::read_symlink("/proc/self/exe"),
                                                      {"count", file.string(), "--profile", options.profile}, at_most);
  fmt::print(console.out, "{:<20}  {:>16}  {:>14}\n", "contender", "instructions", "simulated [s]");
  for (const CountedContender& contender : contenders)
    if (const auto count = counts.by_name.find(contender.name); count != counts.by_name.end())
      fmt::print(console.out, "{:<20}  {:>16.0f}  {:>14.6g}\n", contender.name, count->second, contender.until);
  if (!counts.missing.empty()) throw std::runtime_error(counts.missing);
  return 0;
}

}  // namespace mb
