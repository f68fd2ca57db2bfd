// --set: whatever the words, they are refused in sentences that print, each where it was typed, or they make a study
// that a case file may state in this scene, and change it no further when they are given again.
//
// The first byte chooses the case, '0' the first; the words follow its line: one a line or, where one holds the end of
// a line itself, with NUL between them.
#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <sstream>
#include <stdexcept>
#include <string>

#include "cases/scene/case_files.h"
#include "cases/scene/printable.h"
#include "cases/scene/read_contact.h"
#include "cases/scene/read_study.h"
#include "cases/scene/utf8.h"
#include "harness/study/overrides.h"
#include "harness/study/study_table.h"

namespace {

using namespace mb;

void require(bool holds, const char* property) {
  if (!holds) throw std::logic_error(property);
}

bool prints(const std::string& line) {
  const bool is_plain = std::ranges::all_of(line, [](char c) { return c >= ' ' && c <= '~'; });  // nearly all, and fast
  return is_plain || printable(line, line.size()) == line;
}

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream rest(text);
  for (std::string part; std::getline(rest, part, separator);) parts.push_back(part);
  return parts;
}

const Vocabulary& vocabulary() {
  static const Vocabulary words = test::vocabulary();
  return words;
}

// A case without checks and profiles, which are of its own study, and its bodies as the reader of case files has them.
struct Base {
  Scene scene;
  std::vector<BodyDraft> bodies;
};

std::string own_study_alone(const std::string& text) {
  std::string kept;
  bool keep = true;
  for (const std::string& line : split(text, '\n')) {
    const std::string title = line.substr(std::min(line.find_first_not_of('['), line.size()));
    if (line.starts_with('[')) keep = !title.starts_with("check") && !title.starts_with("profile");
    if (keep) kept += line + "\n";
  }
  return kept;
}

std::vector<BodyDraft> bodies_in(const std::string& text, double duration) {
  Findings findings("case", text);
  const TomlTable table = parse_toml(text, findings).value();
  Section root(table, {}, "", false, findings);
  std::vector<BodyDraft> bodies;
  for (Section& section : root.sections("body", {1, 64}))
    bodies.push_back(read_body(section, {test::cases_folder(), duration}));
  return with_touches(bodies, read_contacts(root, bodies));
}

Base base_of(const char* file) {
  const std::string text = own_study_alone(test::content(test::cases_folder() / file));
  Scene scene = test::read(text);
  std::vector<BodyDraft> bodies = bodies_in(text, scene.duration);
  return {std::move(scene), std::move(bodies)};
}

const std::vector<Base>& bases() {
  static const std::vector<Base> all{base_of("scene/example.toml"), base_of("ball-on-two-by-four.toml"),
                                     base_of("hard/dashpot.toml"), base_of("spin-up-beam.toml"),
                                     base_of("zener-plate.toml")};
  return all;
}

std::string toml(const TomlValue& value) {
  if (const auto* number = std::get_if<double>(&value.value)) return fmt::format("{}", *number);
  if (const auto* integer = std::get_if<std::int64_t>(&value.value)) return fmt::format("{}", *integer);
  if (const auto* word = std::get_if<std::string>(&value.value)) return fmt::format("\"{}\"", *word);
  std::string items;
  for (const TomlValue& item : std::get<TomlArray>(value.value).items) items += toml(item) + ", ";
  return "[" + items + "]";
}

std::string toml(const std::string& title, const TomlFields& fields) {
  std::string lines = title + "\n";
  for (const auto& [key, value] : fields) lines += key + " = " + toml(value) + "\n";
  return lines;
}

std::string toml(const Study& study) {
  const StudyTable table = study_table(study);
  std::string text = toml("[study]", table.fields);
  for (const TomlFields& rival : table.rivals) text += toml("[[study.rival]]", rival);
  for (const TomlFields& stepping : table.steppings) text += toml("[[study.stepping]]", stepping);
  return text;
}

// The study of a case file that says this and what the base does.
Study stated(const std::string& text, const Base& base) {
  Findings findings("case", text);
  const auto table = parse_toml(text, findings);
  if (!table) throw CaseErrors(findings.found());
  Section root(*table, {}, "", false, findings);
  std::optional<Section> no_profile;
  Study study = read_study(root.section("study").value(), no_profile, base.bodies, vocabulary(),
                           {base.scene.duration, base.scene.duration});
  if (!findings.empty()) throw CaseErrors(findings.found());
  return study;
}

// Without the closed form a study has no methods of its own, which only --set can ask for: as a case it keeps those
// that it had.
Scene as_a_case(Scene scene, const Base& base) {
  if (scene.study.methods.empty()) scene.study.methods = base.scene.study.methods;
  return scene;
}

void require_told(const CaseErrors& errors, const std::vector<std::string>& words) {
  require(!errors.diagnostics().empty(), "refused without a reason");
  for (const std::string& line : split(errors.what(), '\n')) require(prints(line), "a message that does not print");
  for (const Diagnostic& problem : errors.diagnostics()) {
    require(!problem.message.empty() && prints(problem.message) && prints(problem.help), "a message that is none");
    if (problem.message.starts_with("more than ")) continue;  // problems: of no place
    require(problem.line >= 1 && problem.line <= static_cast<int>(words.size()), "a problem of no word");
    const std::string& word = words[static_cast<std::size_t>(problem.line - 1)];
    const int width = static_cast<int>(n_code_points(word));
    require(problem.column >= 1 && problem.column <= width + 1, "a problem beside the word");
    require(problem.length >= 1 && problem.column + problem.length <= width + 2, "a problem beyond the word");
  }
}

// What is right once is right again.
void require_study(const Scene& scene, const Overrides& overrides, const Base& base) try {
  const std::string study = toml(scene.study);
  require(toml(as_a_case(overrides.applied(scene), base).study) == study, "given twice, another study");
  require(toml(stated(study, base)) == study, "stated by a case, another study");
} catch (const CaseErrors& errors) {
  throw std::logic_error(std::string("a study that is refused: ") + errors.what());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(data, data + size);
  const std::size_t line_end = text.find('\n');
  if (line_end == text.npos) return 0;
  const Base& base = bases()[static_cast<unsigned char>(text[0] - '0') % bases().size()];
  const std::string rest = text.substr(line_end + 1);
  const std::vector<std::string> words = split(rest, rest.find('\0') == rest.npos ? '\n' : '\0');
  try {
    const Overrides overrides(words, vocabulary());
    require_study(as_a_case(overrides.applied(base.scene), base), overrides, base);
  } catch (const CaseErrors& errors) {
    require_told(errors, words);
  }
  return 0;
}
