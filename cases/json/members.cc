#include "cases/json/members.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "cases/json/json.h"
#include "cases/scene/name.h"
#include "cases/scene/printable.h"

namespace mb {

void refuse(const std::string& key, const std::string& fault) { throw std::runtime_error("'" + key + "' " + fault); }

long integer(const Json& json, const std::string& key, long lowest, long highest) {
  const bool fits = json.is_number_integer() &&
                    (!json.is_number_unsigned() || json.get<std::uint64_t>() <= std::numeric_limits<long>::max());
  if (!fits || json.get<long>() < lowest || json.get<long>() > highest) {
    refuse(key, "is not an integer in [" + std::to_string(lowest) + ", " + std::to_string(highest) + "]");
  }
  return json.get<long>();
}

std::string text(const Json& json, const std::string& key) {
  constexpr std::size_t max_size = 4096;
  if (!json.is_string()) refuse(key, "is not a string");
  const std::string& value = json.get_ref<const std::string&>();
  if (value.size() > max_size) refuse(key, "is longer than " + std::to_string(max_size) + " bytes");
  if (unprintable(value)) refuse(key, "holds a character that does not print");
  return value;
}

Members::Members(const Json& object, std::string name) : object_(object), name_(std::move(name)) {
  if (!object.is_object()) refuse(name_, "is not an object");
}

const Json* Members::find(const std::string& key) {
  asked_.insert(key);
  const auto member = object_.find(key);
  return member == object_.end() ? nullptr : &*member;
}

const Json& Members::get(const std::string& key) {
  const Json* const member = find(key);
  if (member == nullptr) refuse(key, "is missing");
  return *member;
}

std::string Members::text(const std::string& key) { return mb::text(get(key), key); }

std::string Members::name(const std::string& key) {
  std::string value = name_or_none(key);
  if (value.empty()) refuse(key, "is empty");
  return value;
}

std::string Members::name_or_none(const std::string& key) {
  std::string value = text(key);
  if (!value.empty() && !is_name(value))
    refuse(key, "is not a name of at most 64 characters a-z, 0-9 and -, the last not first");
  return value;
}

long Members::integer(const std::string& key, long lowest, long highest) {
  return mb::integer(get(key), key, lowest, highest);
}

double Members::number(const std::string& key) {
  const Json& json = get(key);
  if (!json.is_number() || !std::isfinite(json.get<double>())) refuse(key, "is not a finite number");
  return json.get<double>();
}

std::string Members::hash(const std::string& key) {
  std::string value = text(key);
  const bool is_hash = value.size() == 32 && value.find_first_not_of("0123456789abcdef") == std::string::npos;
  if (!is_hash) refuse(key, "is not a content hash of 32 hex digits");
  return value;
}

std::string Members::one_of(const std::string& key, const std::vector<std::string>& choices) {
  std::string value = text(key);
  if (std::ranges::find(choices, value) == choices.end()) refuse(key, "is none of its possible values");
  return value;
}

std::map<std::string, std::string> Members::texts(const std::string& key) {
  const Json& json = get(key);
  if (!json.is_object()) refuse(key, "is not an object");
  if (json.size() > 64) refuse(key, "has more than 64 entries");
  std::map<std::string, std::string> values;
  for (const auto& [name, value] : json.items()) {
    if (name.size() > 64) refuse(key, "has a key longer than 64 bytes");
    if (unprintable(name)) refuse(key, "has a key that does not print");
    values[name] = mb::text(value, key);
  }
  return values;
}

void Members::expect_no_more() const {
  for (const auto& item : object_.items()) {
    // The key itself is not echoed: it is text from outside.
    if (!asked_.contains(item.key())) refuse(name_, "has a key that schema 1 does not know");
  }
}

}  // namespace mb
