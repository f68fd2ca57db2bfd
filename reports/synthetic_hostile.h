// The made-up study with markup and the beginnings of formulas in every text that a case file, a record or a store may
// hold freely: what must come out as text, on the page, too.
#pragma once

#include <iterator>
#include <string>
#include <variant>

#include "reports/synthetic.h"

namespace mb::synthetic {

inline constexpr const char* markup =
    "=1+1</script><script>document.title='hostile'</script><img src=x onerror=\"document.title='hostile'\">"
    "<a href=\"javascript:alert(1)\">&lt;b&gt;</a>\\input{/etc/passwd}*\x1b]0;t\x07";
// What spreadsheets take for the begin of a formula, as behind blanks and in wide forms.
inline constexpr const char* begins[] = {"", " ", "\u00a0", "\u3000\uff1d", "@", "+", "-", "\uff0b", "\uff0d", "\uff20"};

inline ReportInput hostile() {
  ReportInput all = input();
  for (Record& record : all.records) {
    if (!record.subject.empty()) record.subject += markup;
    record.provenance["processor"] += markup;
  }
  std::size_t n_texts = 0;
  for (Finding& finding : all.findings) {
    finding.title += markup;
    finding.note += markup;
    for (auto& row : finding.rows) {
      for (FindingCell& cell : row) {
        if (auto* text = std::get_if<std::string>(&cell))
          *text = begins[n_texts++ % std::size(begins)] + (markup + *text);
      }
    }
  }
  for (Scene& scene : all.scenes) {
    for (std::string* text : {&scene.title, &scene.purpose, &scene.source, &scene.exercises, &scene.hard})
      *text += markup;
    for (Check& check : scene.checks) check.why += markup;
  }
  for (auto& [name, value] : all.environment) value += markup;
  for (auto& [name, text] : all.metric_docs) text += markup;
  return all;
}

}  // namespace mb::synthetic
