#include "reports/verdict.h"

#include <algorithm>
#include <set>

#include "cases/contract/status.h"
#include "reports/environment.h"
#include "reports/number.h"
#include "reports/speedup.h"
#include "reports/times.h"
#include "reports/warnings.h"
#include "reports/words.h"

namespace mb {
namespace {

void count_checks(const Evaluation& evaluation, Verdict& verdict) {
  std::set<std::string> cases, outside;
  for (const Scene& scene : evaluation.input.scenes) cases.insert(scene.name);
  for (const CheckResult& result : evaluation.checks) {
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
    text += ", " + std::to_string(verdict.n_not_decidable) + " not decidable (bound within the error bar)";
  }
  if (verdict.n_not_measured) text += ", " + std::to_string(verdict.n_not_measured) + " not measured";
  return text + ".";
}

// "Median in the other norms: strain-error 12.3 (2 cases), surface-deviation none."
std::string other_norms_sentence(const Evaluation& evaluation) {
  std::string text;
  for (const std::string& norm : norms) {
    if (norm == headline_metric) continue;
    const auto pairs = at_target(evaluation, norm);
    const auto median = median_ratio(pairs);
    text += (text.empty() ? "" : ", ") + norm + " " + (median ? format_number(*median) : "none") + " (" +
            counted(pairs.size(), "case", "cases") + " within the target)";
  }
  return "Median speed-up at the same target in the other norms: " + text + ".";
}

std::string median_text(const std::vector<SpeedUp>& pairs) {
  const auto median = median_ratio(pairs);
  return median ? "median " + format_number(*median) : "none";
}

long count_compared(const std::vector<SpeedUp>& pairs) {
  return std::ranges::count_if(pairs, [](const SpeedUp& one) { return !one.rival.empty(); });
}

std::string speed_up_sentence(const Evaluation& evaluation, const Verdict& verdict) {
  const std::string at = "at " + percent(error_target) + " displacement error";
  if (verdict.at_target.empty()) {
    const char* of = theory_remark(evaluation).empty() ? "" : " of the cases that count";
    return "Speed-up " + at + ": no reduced run" + of + " is within that, error bar included.";
  }
  return "Speed-up " + at + ": " + median_text(verdict.at_target) + ", in " + std::to_string(verdict.n_compared) +
         " of " + counted(verdict.at_target.size(), "case", "cases") +
         " with a reduced run within that; the cheapest full-order run that is within it, too, over the cheapest "
         "reduced one, whose errors differ.";
}

// "At 5 %, which the truths' error bars leave open in fewer cases: median 80, in 8 of 8 cases."
std::string looser_sentence(const Evaluation& evaluation) {
  const std::vector<SpeedUp> pairs = at_target(evaluation, headline_metric, looser_target);
  return "Speed-up at " + percent(looser_target) +
         ", which the bars of the truths leave open in fewer cases: " + median_text(pairs) + ", in " +
         std::to_string(count_compared(pairs)) + " of " + counted(pairs.size(), "case", "cases") + ".";
}

bool is_of_theory(const Evaluation& evaluation, const std::string& case_name, const std::string& profile) {
  return theory_of(evaluation, case_name, profile) != Theory::solid;
}

// Cases where the truth's error bar leaves open whether any reduced run is within the target.
std::vector<std::string> open_cases(const Evaluation& evaluation, const Verdict& verdict) {
  std::set<std::string> names;
  for (const SpeedUp& one : of_norm(evaluation.speed_ups, headline_metric)) {
    const Run* run = run_of(evaluation, one.error);
    const bool is_best = run && one.error.truth == best_truth(*run, headline_metric);
    if (is_of_theory(evaluation, one.error.case_name, one.error.profile)) continue;
    if (is_best && smallest_error(one.error) <= error_target) names.insert(one.error.case_name);
  }
  for (const SpeedUp& one : verdict.at_target) names.erase(one.error.case_name);
  return {names.begin(), names.end()};
}

// "Limits of these speed-ups: ..."; "" where there are none.
std::string limits_sentence(const Evaluation& evaluation, const Verdict& verdict) {
  std::vector<std::string> limits;
  if (verdict.n_perturbed > 0) {
    limits.push_back(counted(verdict.n_perturbed, "rests", "rest") +
                     " on perturbed times, during which something else had the core (" +
                     cases_where(verdict.at_target, has_perturbed_time) + ")");
  }
  if (verdict.n_at_edge > 0) {
    limits.push_back(counted(verdict.n_at_edge, "has its", "have their") +
                     " rival at the edge of its sweep, beyond which a cheaper one may be (" +
                     cases_where(verdict.at_target, stands_at_edge) + ")");
  }
  if (const std::string remark = theory_remark(evaluation); !remark.empty()) limits.push_back(remark);
  const std::vector<std::string> open = open_cases(evaluation, verdict);
  if (!open.empty()) {
    limits.push_back("the error bar of the truth leaves open whether any reduced run is within the target in " +
                     counted(open.size(), "case", "cases") + " (" + listed(open) + ")");
  }
  const long n_left_out = count_times_left_out(evaluation.input.records);
  if (n_left_out > 0) {
    limits.push_back(counted(n_left_out, "time", "times") +
                     " taken on another machine than most of the case left out of every comparison");
  }
  return limits.empty() ? "" : "Limits of these speed-ups: " + joined(limits, "; ") + ".";
}

// "14 runs failed. 14 runs: point ... lies in no cell: Q1 1x2, newmark, 7 runs from ..."
std::string failure_sentence(const std::vector<Failure>& failures, int n_failed_runs) {
  if (n_failed_runs == 0) return "No run failed.";
  std::string text = counted(n_failed_runs, "run", "runs") + " failed.";
  std::size_t n_named = 0, n_reasons = 0;
  for (const Failure& one : failures) {
    if (one.undefined || is_unstable(one.reason) || ++n_reasons > 5) continue;
    ++n_named;
    text += " " + counted(one.n_runs, "run", "runs") + ": " + one.reason + ": " + one.contenders + ".";
  }
  if (n_reasons > n_named) text += " " + std::to_string(n_reasons - n_named) + " more reasons under failures.";
  return text;
}

int count_runs(const Evaluation& evaluation, bool (*is_counted)(const Record&)) {
  std::vector<std::pair<std::pair<std::string, std::string>, Contender>> counted;  // (name, profile), contender
  for (const Record& record : evaluation.input.records) {
    if (!is_counted(record)) continue;
    const std::pair of{record.case_name, record.profile};
    const bool known = std::any_of(counted.begin(), counted.end(), [&](const auto& one) {
      return one.first == of && same_contender(one.second, record.contender);
    });
    if (!known) counted.push_back({of, record.contender});
  }
  return static_cast<int>(counted.size());
}

void add_speed_ups(const Evaluation& evaluation, Verdict& verdict) {
  if (!verdict.is_timed) return verdict.sentences.push_back("No run was timed: there are no speed-ups.");
  verdict.sentences.push_back(speed_up_sentence(evaluation, verdict));
  verdict.sentences.push_back(looser_sentence(evaluation));
  const std::string limits = limits_sentence(evaluation, verdict);
  if (!limits.empty()) verdict.sentences.push_back(limits);
  verdict.sentences.push_back(other_norms_sentence(evaluation));
}

bool is_failed(const Record& record) { return !is_usable(record) && !is_undefined(record) && !is_unstable(record); }

std::string unstable_sentence(int n) {
  return counted(n, "run is unstable: its step is", "runs are unstable: their steps are") + " beyond the limit.";
}

// What stood there is not in this report: a check may lack its answer, a case its warnings.
std::string damage_sentence(const std::vector<std::string>& damaged) {
  constexpr std::size_t most_named = 5;
  std::string text = counted(damaged.size(), "damaged file of the store is", "damaged files of the store are") +
                     " left out, what stood there is missing here until it is run again";
  for (std::size_t i = 0; i < std::min(most_named, damaged.size()); ++i) text += (i ? "; " : ": ") + damaged[i];
  if (damaged.size() > most_named) text += "; and " + std::to_string(damaged.size() - most_named) + " more";
  return text + ".";
}

// "3 warnings in 2 cases (a, b): ..."; "" without any.
std::string warnings_sentence(const ReportInput& input) {
  std::size_t n = 0;
  std::set<std::string> cases;
  for (const Scene& scene : input.scenes) {
    const std::size_t of_scene = warnings(input.records, scene).size();
    n += of_scene;
    if (of_scene > 0) cases.insert(scene.name);
  }
  if (n == 0) return "";
  return counted(n, "warning", "warnings") + " in " + counted(cases.size(), "case", "cases") + " (" +
         listed({cases.begin(), cases.end()}) +
         "), told there: strain or rotation beyond linear theory, steps in contact that gain energy, or steps that may "
         "be past their limit.";
}

}  // namespace

std::vector<SpeedUp> at_target(const Evaluation& evaluation, const std::string& norm, double target) {
  std::vector<SpeedUp> all = speed_ups_at(target, evaluation.runs, norm);
  std::erase_if(all,
                [&](const SpeedUp& one) { return is_of_theory(evaluation, one.error.case_name, one.error.profile); });
  return all;
}

std::string theory_remark(const Evaluation& evaluation) {
  std::set<std::string> names;
  for (const Run& run : evaluation.runs) {
    if (is_of_theory(evaluation, run.case_name, run.profile)) names.insert(run.case_name);
  }
  if (names.empty()) return "";
  return "left out: " + listed({names.begin(), names.end()}) +
         ", of beam or plate theory, whose full-order runs are half waves, modes too, and no finite elements";
}

std::vector<std::pair<std::string, SpeedUp>> headline_pairs(const Evaluation& evaluation) {
  std::vector<std::pair<std::string, SpeedUp>> pairs;
  for (const std::string& norm : norms) {
    for (const SpeedUp& one : at_target(evaluation, norm)) pairs.emplace_back(norm, one);
  }
  return pairs;
}

Verdict verdict_of(const Evaluation& evaluation) {
  Verdict verdict;
  verdict.is_timed =
      std::ranges::any_of(evaluation.runs, [](const Run& run) { return run.online && is_usable(*run.online); });
  count_checks(evaluation, verdict);
  if (evaluation.input.records.empty()) {
    verdict.sentences.push_back(
        "There are no records to report: nothing has been run, or what is stored belongs to case files, settings or "
        "builds other than these. Run modalbench run first, or name the case files: modalbench report FILE.");
  }
  verdict.sentences.push_back(checks_sentence(verdict));
  if (const auto& damaged = evaluation.input.damaged; !damaged.empty())
    verdict.sentences.push_back(damage_sentence(damaged));
  verdict.at_target = at_target(evaluation, headline_metric);
  verdict.median = median_ratio(verdict.at_target);
  verdict.n_compared = count_compared(verdict.at_target);
  verdict.n_perturbed = std::ranges::count_if(verdict.at_target, has_perturbed_time);
  verdict.n_at_edge = std::ranges::count_if(verdict.at_target, stands_at_edge);
  if (!evaluation.input.records.empty()) {
    add_speed_ups(evaluation, verdict);
    verdict.n_failed_runs = count_runs(evaluation, is_failed);
    verdict.n_unstable_runs = count_runs(evaluation, is_unstable);
    verdict.sentences.push_back(failure_sentence(failures_of(evaluation), verdict.n_failed_runs));
    if (verdict.n_unstable_runs > 0) verdict.sentences.push_back(unstable_sentence(verdict.n_unstable_runs));
    if (const std::string text = warnings_sentence(evaluation.input); !text.empty()) verdict.sentences.push_back(text);
  }
  return verdict;
}

}  // namespace mb
