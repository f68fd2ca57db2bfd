#include "cases/json/json.h"

#include <set>
#include <stdexcept>
#include <vector>

namespace mb {

namespace {

// Refuses while parsing, so that neither deep nesting nor a repeated key ever becomes a value.
class Guard {
 public:
  explicit Guard(int max_depth) : max_depth_(max_depth) {}

  bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
    using Event = Json::parse_event_t;
    if (event == Event::object_start || event == Event::array_start) {
      if (depth >= max_depth_) throw std::runtime_error("JSON is nested deeper than " + std::to_string(max_depth_));
    }
    if (event == Event::object_start) keys_.emplace_back();
    if (event == Event::object_end) keys_.pop_back();
    if (event == Event::key && !keys_.back().insert(parsed.get<std::string>()).second) {
      throw std::runtime_error("JSON object has the same key twice");
    }
    return true;
  }

 private:
  int max_depth_;
  std::vector<std::set<std::string>> keys_;  // of the objects that are open
};

}  // namespace

Json parse_json(std::string_view text, int max_depth) {
  try {
    return Json::parse(text, Guard(max_depth));
  } catch (const Json::parse_error& error) {
    throw std::runtime_error("not valid JSON at byte " + std::to_string(error.byte));
  } catch (const Json::exception&) {
    throw std::runtime_error("JSON number outside the range of double");
  }
}

std::string to_line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace mb
