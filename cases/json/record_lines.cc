#include <fstream>
#include <sstream>
#include <stdexcept>

#include "cases/json/json.h"
#include "cases/json/record_json.h"

namespace mb {

namespace {

constexpr std::size_t max_line = 64 * 1024;                   // [bytes]
constexpr std::uintmax_t max_file = std::uintmax_t{1} << 30;  // [bytes]
constexpr std::size_t max_refused = 1000;                     // lines of a file: then it is of something else

enum class Line { whole, too_long, none };

// The next line without its end; of a line that is too long nothing is kept.
Line next_line(std::streambuf& from, std::string& line) {
  using Traits = std::char_traits<char>;
  line.clear();
  bool too_long = false, any = false;
  for (int c = from.sbumpc(); c != Traits::eof(); c = from.sbumpc()) {
    any = true;
    if (c == '\n') break;
    too_long = too_long || line.size() == max_line;
    if (!too_long) line.push_back(Traits::to_char_type(c));
  }
  return too_long ? Line::too_long : any ? Line::whole : Line::none;
}

RecordLines records_from(std::streambuf& from, const std::filesystem::path& file) {
  RecordLines result;
  std::string line;
  int number = 0;
  for (Line read = next_line(from, line); read != Line::none; read = next_line(from, line)) {
    ++number;
    if (result.refused.size() == max_refused) {
      result.refused.push_back({file, number, "and what follows is not read: 1000 lines before are no records"});
      break;
    }
    try {
      if (read == Line::too_long) throw std::runtime_error("line is longer than 64 KiB");
      if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
      result.records.push_back(record_from_json(parse_json(line)));
    } catch (const std::runtime_error& fault) {
      result.refused.push_back({file, number, fault.what()});
    }
  }
  return result;
}

}  // namespace

std::string to_string(const RefusedLine& refused) {
  const std::string line = refused.line > 0 ? std::to_string(refused.line) + ":" : "";
  return refused.file.string() + ":" + line + " " + refused.reason;
}

RecordLines read_records(const std::filesystem::path& file) {
  const auto refused = [&](const std::string& reason) { return RecordLines{{}, {{file, 0, reason}}}; };
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return refused("is not a readable file");
  if (std::filesystem::file_size(file, error) > max_file || error) return refused("is larger than 1 GiB");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return refused("cannot be opened for reading");
  return records_from(*stream.rdbuf(), file);
}

RecordLines read_records(std::string_view text, const std::filesystem::path& file) {
  std::istringstream stream{std::string(text)};
  return records_from(*stream.rdbuf(), file);
}

}  // namespace mb
