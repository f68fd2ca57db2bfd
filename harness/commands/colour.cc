#include "harness/commands/colour.h"

#include <unistd.h>

#include <cstdlib>
#include <iostream>
#include <string_view>

namespace mb {

namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? "" : value;
}

std::string painted(const char* code, const std::string& text, bool coloured) {
  return coloured ? std::string("\x1b[") + code + "m" + text + "\x1b[0m" : text;
}

}  // namespace

bool shows_colour(const std::ostream& stream) {
  const int descriptor = &stream == &std::cout ? STDOUT_FILENO : &stream == &std::cerr ? STDERR_FILENO : -1;
  return descriptor >= 0 && ::isatty(descriptor) == 1 && environment("NO_COLOR").empty() &&
         environment("TERM") != "dumb";
}

std::string yellow(const std::string& text, bool coloured) { return painted("33", text, coloured); }
std::string green(const std::string& text, bool coloured) { return painted("32", text, coloured); }

}  // namespace mb
