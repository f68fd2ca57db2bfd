// Names: each once among its kind, and references to them.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "cases/scene/section.h"

namespace mb {

class Names {  // of one kind, each once
 public:
  explicit Names(std::string kind) : kind_(std::move(kind)) {}         // "body": for messages
  void add(Section& section, const std::optional<std::string>& name);  // records a name that is there already

 private:
  std::string kind_;
  std::set<std::string> names_;
};

// Of drafts: nothing for one whose name is wrong.
template <class Draft>
std::vector<std::optional<std::string>> names_of(const std::vector<Draft>& drafts) {
  std::vector<std::optional<std::string>> names;
  for (const Draft& draft : drafts) names.push_back(draft.name);
  return names;
}

// The one of the names that the key states; nothing where it is none of them. Where a name is missing, it was wrong
// itself and may be the one meant: then nothing is recorded. one, many: "body", "bodies".
std::optional<std::string> read_reference(Section& section, const std::string& key,
                                          const std::vector<std::optional<std::string>>& names, const std::string& one,
                                          const std::string& many);

}  // namespace mb
