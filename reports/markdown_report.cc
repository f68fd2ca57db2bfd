#include "reports/markdown_report.h"

#include "reports/hard_cases.h"

#include "reports/claims.h"
#include "reports/definitions.h"
#include "reports/environment.h"
#include "reports/findings.h"
#include "reports/matrix.h"
#include "reports/number.h"
#include "reports/orders.h"
#include "reports/polynomial_modes.h"
#include "reports/render.h"
#include "reports/speedup.h"
#include "reports/verdict.h"
#include "reports/words.h"

namespace mb {
namespace {

std::string parts(const Sheet& table) {
  std::string text;
  for (const Sheet& part : split(table)) {
    text += "### " + markdown_text(part.title) + "\n\n";
    if (!part.note.empty()) text += markdown_text(part.note) + "\n\n";
    text += markdown(part) + "\n";
  }
  return text;
}

std::string section(const Sheet& table, const std::string& heading, const std::string& empty) {
  return "## " + heading + "\n\n" + (table.rows.empty() ? empty + "\n\n" : parts(table));
}

std::string findings_sections(const Evaluation& evaluation, bool before_speed_up) {
  std::string text;
  for (const FindingGroup& group : finding_groups(evaluation)) {
    if (stands_before_speed_up(group.analysis) != before_speed_up) continue;
    text += "## " + markdown_text(group.heading) + "\n\n";
    for (const Finding* finding : group.findings) {
      const Sheet all = sheet_of(*finding);
      const Sheet table = shortened(all, longest_text_table, "data/" + file_stem(evaluation, *finding) + ".csv");
      text += "### " + markdown_text(table.title) + "\n\n";
      if (!table.note.empty()) text += markdown_text(table.note) + "\n\n";
      text += table.rows.empty() ? "No rows.\n\n" : markdown(table) + "\n";
    }
  }
  return text;
}

std::string cases_section(const Evaluation& evaluation) {
  if (evaluation.input.scenes.empty()) return "";
  std::string text = "## Cases\n\n";
  for (const Scene& scene : evaluation.input.scenes) {
    text += "- **" + markdown_text(scene.name) + "** (profile " + markdown_text(scene.profile) + ", " +
            format_number(scene.duration) + " s): " + markdown_text(scene.title) + ". " +
            markdown_text(joined({scene.purpose, scene.hard}, " "));
    for (const std::string& sentence : truth_sentences(evaluation, scene)) text += " " + markdown_text(sentence);
    if (!scene.source.empty()) text += " Source: " + markdown_text(scene.source);
    text += "\n  - " + markdown_text(case_line(evaluation, scene)) + "\n";
  }
  return text + "\n";
}

std::string definitions_section(const Evaluation& evaluation) {
  std::string text = "## Definitions\n\n";
  for (const Explanation& one : definitions(evaluation)) {
    text += "- **" + markdown_text(one.term) + "**: " + markdown_text(one.text) + "\n";
  }
  return text + "\n";
}

// Indented, not fenced: nothing in a command can end the block.
std::string reproduce_section(const Evaluation& evaluation) {
  std::string text = "## To reproduce\n\n";
  for (const std::string& command : reproducing_commands(evaluation)) {
    std::string line;
    for (const char c : command) line += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    text += "    " + line + "\n";
  }
  return text;
}

}  // namespace

std::string markdown_report(const Evaluation& evaluation) {
  std::string text = "# Modalbench report\n\n## Verdict\n\n";
  for (const std::string& sentence : verdict_of(evaluation).sentences) text += "- " + markdown_text(sentence) + "\n";
  text += "\n" + parts(headline_table(evaluation));
  const std::vector<SpeedUp> front = on_front(evaluation.speed_ups);
  text += section(checks_table(evaluation), "Checks", "No case states a check.");
  text += section(matrix_table(evaluation), "Cases and contenders", "Nothing was run.");
  text += section(reduced_table(evaluation), "Error against r", "No reduced run is recorded.");
  text += section(orders_table(curves(evaluation)), "Observed orders", "No curve has three runs.");
  text += section(rivals_table(evaluation), "Full-order contenders", "No full-order contender is recorded.");
  text += findings_sections(evaluation, true);
  text += section(speed_up_table(evaluation, front), "Speed-up at equal error",
                  "No reduced run has both an error and a time.");
  text += section(phases_table(evaluation, front), "What the times are made of",
                  "No reduced run has both an error and a time.");
  text += findings_sections(evaluation, false);
  if (const Sheet table = polynomials_table(evaluation); !table.rows.empty()) text += section(table, table.title, "");
  text += section(claims_table(evaluation), "The paper's claims", "");
  for (const Sheet& hard : {hard_cases_table(evaluation), hard_integrators_table(evaluation)})
    if (!hard.rows.empty()) text += section(hard, hard.title, "");
  text += section(probes_table(evaluation), "Probe signals", "No probe is recorded.");
  if (const Sheet failures = failures_table(evaluation); !failures.rows.empty()) {
    text += section(failures, "Failures", "");
  }
  text += cases_section(evaluation) + definitions_section(evaluation);
  text += section(environment_table(evaluation), "Environment", "Nothing is known of it.");
  return text + reproduce_section(evaluation);
}

}  // namespace mb
