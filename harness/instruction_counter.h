// Instructions executed, counted by valgrind's tool callgrind: deterministic, where times depend on machine and load.
//
//   modalbench count CASE  ->  valgrind --tool=callgrind modalbench count CASE  ->  one dump a counted piece of work
//
// What is prepared before runs uncounted, at a few times its usual duration. valgrind 3.19 does not know all that g++
// makes of AVX: the portable build (preset `release`) is one that it counts.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

namespace mb {

bool is_counting();  // whether this process runs under callgrind
// Runs work, counted under that name, which is dumped at once; without callgrind it just runs.
void counted(const std::string& name, const std::function<void()>& work);

// Instructions by name, as far as it came. missing: why some or all are, "" where none is.
struct InstructionCounts {
  std::map<std::string, double> by_name;
  std::string missing;
};
// Starts the program with these words under callgrind, its output thrown away, for at most that long [s]. Throws
// std::runtime_error where it is ended by SIGINT, SIGTERM or SIGHUP, as a whole group of processes is by Ctrl-C.
InstructionCounts count_instructions(const std::filesystem::path& program, const std::vector<std::string>& words,
                                     double at_most);

// The dumps in a folder (callgrind_dump.h). missing: a problem of one of them.
InstructionCounts read_dumps(const std::filesystem::path& folder);

}  // namespace mb
