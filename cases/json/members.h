// Reading a JSON object from outside, member by member: types, ranges and lengths checked, unknown keys refused.
#pragma once

#include <set>
#include <string>

#include "cases/json/json.h"

namespace mb {

// Every function throws std::runtime_error with one sentence that names the key. The object must outlive this.
class Members {
 public:
  Members(const Json& object, std::string name);

  const Json* find(const std::string& key);  // nullptr where absent
  const Json& get(const std::string& key);   // refused where absent
  std::string text(const std::string& key);  // at most 4096 bytes
  std::string name(const std::string& key);  // [a-z0-9-]{0,64}
  long integer(const std::string& key, long lowest, long highest);
  double number(const std::string& key);  // finite
  void expect_no_more() const;            // refuses keys that were not asked for

 private:
  const Json& object_;
  std::string name_;
  std::set<std::string> asked_;
};

[[noreturn]] void refuse(const std::string& key, const std::string& fault);
long integer(const Json& json, const std::string& key, long lowest, long highest);
std::string text(const Json& json, const std::string& key);

}  // namespace mb
