#include "cases/scene/diagnostics.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>
#include <utility>

#include "cases/scene/utf8.h"

namespace mb {

namespace {

// A hostile file may hold a problem in every byte; nobody reads more than this.
constexpr std::size_t most_findings = 200;
constexpr std::size_t most_excerpt = 160;

bool before(const Diagnostic& a, const Diagnostic& b) {
  return std::tie(a.line, a.column, a.message) < std::tie(b.line, b.column, b.message);
}

std::string summary(const std::vector<Diagnostic>& found) {
  std::string all;
  for (const Diagnostic& diagnostic : found) all += to_string(diagnostic);
  return all;
}

std::vector<Diagnostic> sorted(std::vector<Diagnostic> found) {
  std::stable_sort(found.begin(), found.end(), before);
  return found;
}

}  // namespace

Findings::Findings(std::string file, std::string_view text)
    : file_(printable(file, 4096)), text_(text), line_starts_{0} {
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '\n') line_starts_.push_back(at + 1);
  }
}

std::string Findings::excerpt(int line) const {
  const auto index = static_cast<std::size_t>(line - 1);
  if (line < 1 || index >= line_starts_.size()) return "";
  const std::size_t start = line_starts_[index];
  std::string_view content = text_.substr(start, text_.find('\n', start) - start);
  if (content.ends_with('\r')) content.remove_suffix(1);
  return printable(content, most_excerpt);
}

void Findings::error(const Position& where, std::string message, std::string help) {
  if (found_.size() > most_findings) return;
  const auto same = [&](const Diagnostic& other) {
    return other.line == where.line && other.column == where.column && other.message == message;
  };
  if (std::any_of(found_.begin(), found_.end(), same)) return;
  if (found_.size() == most_findings) {
    found_.push_back(
        {file_, 0, 0, 1, fmt::format("more than {} problems: the rest is not shown", most_findings), "", ""});
    return;
  }
  found_.push_back({file_, where.line, where.column, std::max(where.length, 1), std::move(message), excerpt(where.line),
                    std::move(help)});
}

std::string to_string(const Diagnostic& diagnostic) {
  std::string out = diagnostic.file;
  if (diagnostic.line > 0) out += fmt::format(":{}:{}", diagnostic.line, diagnostic.column);
  out += fmt::format(": error: {}\n", diagnostic.message);
  if (diagnostic.line > 0) {
    out += fmt::format("{:>5} | {}\n", diagnostic.line, diagnostic.excerpt);
    const int width = static_cast<int>(n_code_points(diagnostic.excerpt));
    if (diagnostic.column <= width + 1) {  // carets stop where a clipped excerpt ends
      const int length = std::clamp(diagnostic.length, 1, std::max(1, width + 1 - diagnostic.column));
      out += fmt::format("      | {}{}\n", std::string(static_cast<std::size_t>(diagnostic.column - 1), ' '),
                         std::string(static_cast<std::size_t>(length), '^'));
    }
  }
  if (!diagnostic.help.empty()) out += fmt::format("  help: {}\n", diagnostic.help);
  return out;
}

CaseErrors::CaseErrors(std::vector<Diagnostic> found)
    : std::runtime_error(summary(sorted(found))), diagnostics_(sorted(std::move(found))) {}

}  // namespace mb
