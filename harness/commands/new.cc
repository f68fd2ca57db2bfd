#include <fcntl.h>
#include <fmt/ostream.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <system_error>

#include "cases/scene/keys.h"
#include "cases/scene/printable.h"
#include "harness/commands/commands.h"
#include "harness/commands/schema.h"
#include "harness/commands/usage_error.h"

namespace mb {

namespace {

bool is_name(const std::string& text) {
  return !text.empty() && text.size() <= 64 && std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-';
  });
}

// The template under the name of its file.
std::string template_named(const std::string& name) {
  std::string text = annotated_template();
  const std::string stated = "\"my-case\"";
  return is_name(name) ? text.replace(text.find(stated), stated.size(), "\"" + name + "\"") : text;
}

// O_EXCL: nothing that is there is written over, were it made this moment.
void write_new(const std::filesystem::path& file, const std::string& text) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (descriptor < 0 && errno == EEXIST) throw UsageError(file.string() + " is there already: name another file");
  if (descriptor < 0) throw UsageError(file.string() + " cannot be written: " + std::generic_category().message(errno));
  const ssize_t n = ::write(descriptor, text.data(), text.size());
  const bool whole = n == static_cast<ssize_t>(text.size());
  if (::close(descriptor) == 0 && whole) return;
  ::unlink(file.c_str());
  throw UsageError(file.string() + " cannot be written: is the disk full?");
}

}  // namespace

int new_command(const NewOptions& options, const Catalogue&, const Console& console) {
  if (options.json_schema) {
    fmt::print(console.out, "{}\n", case_schema());
    return 0;
  }
  const std::filesystem::path file = options.file;
  if (file.extension() != ".toml") throw UsageError("'" + options.file + "': the name of a case file ends in .toml");
  const std::string name = file.stem();
  write_new(file, template_named(name));
  fmt::print(console.out, "{}\n", printable(file.string(), 1000));
  fmt::print(console.err, "next: modalbench check {0}, modalbench run {0}, modalbench report {0}\n",
             printable(file.string(), 1000));
  return 0;
}

}  // namespace mb
