#include "reports/verdict.h"

#include <algorithm>
#include <set>
#include <tuple>

#include "reports/number.h"
#include "reports/speedup.h"

namespace mb {
namespace {

std::string counted(int n, const std::string& one, const std::string& many) {
  return std::to_string(n) + " " + (n == 1 ? one : many);
}

void count_checks(const Analysis& analysis, Verdict& verdict) {
  std::set<std::string> cases, outside;
  for (const Scene& scene : analysis.input.scenes) cases.insert(scene.name);
  for (const CheckResult& result : analysis.checks) {
    ++verdict.n_checks;
    verdict.n_hold += result.holds;
    verdict.n_not_measured += !result.measured;
    verdict.n_not_decidable += result.measured && !result.decidable;
    if (!result.holds) outside.insert(result.case_name);
  }
  verdict.n_cases = static_cast<int>(cases.size());
  verdict.n_cases_within = verdict.n_cases - static_cast<int>(outside.size());
}

std::string checks_sentence(const Verdict& verdict) {
  if (verdict.n_checks == 0) return "No case in this report states a check.";
  std::string text = std::to_string(verdict.n_cases_within) + " of " + counted(verdict.n_cases, "case", "cases") +
                     " within all checks: " + std::to_string(verdict.n_hold) + " of " +
                     counted(verdict.n_checks, "check holds", "checks hold");
  if (verdict.n_not_decidable) {
    text += ", " + std::to_string(verdict.n_not_decidable) + " not decidable (bound below the error bar)";
  }
  if (verdict.n_not_measured) text += ", " + std::to_string(verdict.n_not_measured) + " not measured";
  return text + ".";
}

std::string speed_up_sentence(const Verdict& verdict) {
  const std::string at =
      "at " + format_number(100 * error_target, 1) + " % displacement error against " + headline_truth;
  if (verdict.at_target.empty()) return "Speed-up " + at + ": no reduced run reaches that error.";
  std::string text = "Speed-up " + at + ": ";
  text += verdict.median ? "median " + format_number(*verdict.median) : std::string("none reached by any rival");
  for (const SpeedUp& one : verdict.at_target) {
    text += "; " + one.error.case_name + " (" + one.error.profile + ") " + describe(one.error.contender) + ": " +
            ratio_cell(one).text;
    if (!one.rival.empty()) text += " over " + describe(one.rival[0].contender);
  }
  return text + ".";
}

std::string failure_sentence(const Analysis& analysis, Verdict& verdict) {
  std::set<std::string> reasons;
  std::set<std::tuple<std::string, std::string, std::string>> runs;
  const Sheet failures = failures_table(analysis);
  for (const auto& row : failures.rows) {
    runs.insert({row[0].text, row[1].text, row[3].text});
    reasons.insert(row[3].text + " (" + row[5].text + ")");
  }
  verdict.n_failed_runs = static_cast<int>(runs.size());
  verdict.n_failed_records = static_cast<int>(failures.rows.size());
  if (runs.empty()) return "No run failed.";
  std::string text = counted(verdict.n_failed_runs, "run", "runs") + " failed: ";
  std::size_t n_named = 0;
  for (const std::string& reason : reasons) {
    if (n_named == 5) {
      text += "; and " + std::to_string(reasons.size() - n_named) + " more, listed under failures";
      break;
    }
    text += (n_named++ ? "; " : "") + reason;
  }
  return text + ".";
}

// Names from a store are untrusted, and readers paste commands into a shell: only plain words become part of one.
bool is_plain_word(const std::string& text) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  };
  return !text.empty() && text.size() <= 64 && text[0] != '-' && std::all_of(text.begin(), text.end(), is_plain);
}

}  // namespace

Verdict verdict_of(const Analysis& analysis) {
  Verdict verdict;
  count_checks(analysis, verdict);
  if (analysis.input.records.empty()) {
    verdict.sentences.push_back(
        "There are no records: nothing has been run, or the store is empty. "
        "Run modalbench run first.");
  }
  verdict.sentences.push_back(checks_sentence(verdict));
  verdict.at_target = cheapest_within(analysis.speed_ups, headline_truth, error_target);
  verdict.median = median_ratio(verdict.at_target);
  if (!analysis.input.records.empty()) {
    verdict.sentences.push_back(speed_up_sentence(verdict));
    verdict.sentences.push_back(failure_sentence(analysis, verdict));
  }
  return verdict;
}

std::vector<Definition> definitions(const Analysis& analysis) {
  std::vector<Definition> all;
  for (const auto& [metric, text] : analysis.input.metric_docs) all.push_back({metric, text});
  const std::vector<Definition> terms = {
      {"truth finer",
       "A full-order answer of higher degree or on a finer mesh, integrated tightly: errors against it "
       "hold truncation, time stepping and discretisation."},
      {"truth same_mesh",
       "A full-order answer with the contender's own M and K, integrated tightly: errors against it "
       "hold truncation and time stepping alone."},
      {"error bar",
       "How far the truth itself may be off, by the same metric. An error below it prints as <= bar and "
       "counts as the bar wherever errors are compared."},
      {"r",
       "Elastic modes asked for; rigid modes always stay. Modes of equal frequency are kept whole, so that the "
       "number used may be larger: both are recorded."},
      {"online time",
       "Wall clock of load projection, time stepping and reconstruction at the evaluation points at the "
       "frame times: median of the repeats, with half their spread."},
      {"offline time",
       "Wall clock of everything before: assembly, factorisation, eigenproblem; counted on both sides."},
      {"speed-up",
       "Online time of the cheapest full-order contender whose error is at most that of the reduced run, "
       "over the online time of the reduced run; no interpolation between runs. None reached: no "
       "full-order contender of the sweep reaches that error."},
      {"break-even",
       "Simulated seconds after which offline plus online time of the reduced run falls below that of "
       "its rival; never where its online time is not the smaller one."},
      {"check",
       "A bound that the case file sets. It is not decidable where the bound lies below the error bar and the "
       "measured value is nearer to it than that bar."}};
  all.insert(all.end(), terms.begin(), terms.end());
  return all;
}

std::vector<std::string> reproducing_commands(const Analysis& analysis) {
  std::vector<std::string> commands;
  const auto& environment = analysis.input.environment;
  const auto commit = environment.find("commit");
  if (commit != environment.end() && is_plain_word(commit->second)) {
    commands.push_back("git checkout " + commit->second);
  }
  std::set<std::pair<std::string, std::string>> cases;
  for (const Record& record : analysis.input.records) cases.insert({record.case_name, record.profile});
  for (const auto& [name, profile] : cases) {
    if (!is_plain_word(name) || !is_plain_word(profile)) continue;
    commands.push_back("modalbench run " + name + " --profile " + profile);
  }
  commands.push_back("modalbench report");
  return commands;
}

}  // namespace mb
