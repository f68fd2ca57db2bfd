// Reading a JSON object from outside, member by member: types, ranges and lengths checked, unknown keys refused.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "cases/json/json_type.h"

namespace mb {

// Every function throws std::runtime_error with one sentence that names the key. The object must outlive this.
class Members {
 public:
  Members(const Json& object, std::string name);

  const Json* find(const std::string& key);          // nullptr where absent
  const Json& get(const std::string& key);           // refused where absent
  std::string text(const std::string& key);          // at most 4096 bytes, one line that prints (printable.h)
  std::string name(const std::string& key);          // [a-z0-9][a-z0-9-]{0,63}
  std::string name_or_none(const std::string& key);  // or ""
  long integer(const std::string& key, long lowest, long highest);
  double number(const std::string& key);     // finite
  std::string hash(const std::string& key);  // content hash of 32 hex digits
  std::string one_of(const std::string& key, const std::vector<std::string>& choices);
  std::map<std::string, std::string> texts(const std::string& key);  // at most 64, keys of at most 64 bytes
  void expect_no_more() const;                                       // refuses keys that were not asked for

 private:
  const Json& object_;
  std::string name_;
  std::set<std::string> asked_;
};

[[noreturn]] void refuse(const std::string& key, const std::string& fault);
long integer(const Json& json, const std::string& key, long lowest, long highest);
std::string text(const Json& json, const std::string& key);

}  // namespace mb
