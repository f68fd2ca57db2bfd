#include "reports/markdown_report.h"

#include "reports/number.h"
#include "reports/render.h"
#include "reports/verdict.h"

namespace mb {
namespace {

std::string section(const Sheet& table, const std::string& heading, const std::string& empty) {
  std::string text = "## " + heading + "\n\n";
  if (table.rows.empty()) return text + empty + "\n\n";
  for (const Sheet& part : split(table)) {
    text += "### " + markdown_text(part.title) + "\n\n";
    if (!part.note.empty()) text += markdown_text(part.note) + "\n\n";
    text += markdown(part) + "\n";
  }
  return text;
}

std::string cases_section(const Analysis& analysis) {
  if (analysis.input.scenes.empty()) return "";
  std::string text = "## Cases\n\n";
  for (const Scene& scene : analysis.input.scenes) {
    text += "- **" + markdown_text(scene.name) + "** (profile " + markdown_text(scene.profile) + ", " +
            format_number(scene.duration) + " s): " + markdown_text(scene.title) + ". " + markdown_text(scene.purpose);
    for (const std::string& sentence : truth_sentences(analysis, scene)) text += " " + markdown_text(sentence);
    if (!scene.source.empty()) text += " Source: " + markdown_text(scene.source);
    text += "\n";
  }
  return text + "\n";
}

std::string definitions_section(const Analysis& analysis) {
  std::string text = "## Definitions\n\n";
  for (const Definition& one : definitions(analysis)) {
    text += "- **" + markdown_text(one.term) + "**: " + markdown_text(one.text) + "\n";
  }
  return text + "\n";
}

std::string environment_section(const Analysis& analysis) {
  std::string text = "## Environment\n\n| what | value |\n| --- | --- |\n";
  for (const auto& [key, value] : analysis.input.environment) {
    text += "| " + markdown_text(key) + " | " + markdown_text(value) + " |\n";
  }
  return text + "\n";
}

// Indented, not fenced: nothing in a command can end the block.
std::string reproduce_section(const Analysis& analysis) {
  std::string text = "## To reproduce\n\n";
  for (const std::string& command : reproducing_commands(analysis)) {
    std::string line;
    for (const char c : command) line += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    text += "    " + line + "\n";
  }
  return text;
}

}  // namespace

std::string markdown_report(const Analysis& analysis) {
  std::string text = "# Modalbench report\n\n## Verdict\n\n";
  for (const std::string& sentence : verdict_of(analysis).sentences) text += "- " + markdown_text(sentence) + "\n";
  text += "\n";
  text += section(checks_table(analysis), "Checks", "No case states a check.");
  text += section(reduced_table(analysis), "Error against r", "No reduced run is recorded.");
  text += section(speed_up_table(analysis), "Speed-up at equal error", "No reduced run has both an error and a time.");
  text += section(rivals_table(analysis), "Full-order contenders", "No full-order contender is recorded.");
  text += section(probes_table(analysis), "Probe signals", "No probe is recorded.");
  if (const Sheet failures = failures_table(analysis); !failures.rows.empty()) {
    text += section(failures, "Failures", "");
  }
  text += cases_section(analysis) + definitions_section(analysis) + environment_section(analysis);
  return text + reproduce_section(analysis);
}

}  // namespace mb
