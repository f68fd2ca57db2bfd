// A command called by a test in a folder of its own, and what it told.
#pragma once

#include <filesystem>
#include <sstream>
#include <string>

#include "harness/commands/commands.h"

namespace mb::test {

struct Told {
  int code;
  std::string out, err;
};

// command(console) with `folder` as the current one.
template <class Command>
Told told(const std::filesystem::path& folder, Command command) {
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder);
  std::ostringstream out, err;
  try {
    const int code = command(Console{out, err});
    std::filesystem::current_path(before);
    return {code, out.str(), err.str()};
  } catch (...) {
    std::filesystem::current_path(before);
    throw;
  }
}

}  // namespace mb::test
