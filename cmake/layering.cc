// layering ROOT: reads every #include below the folders of the project and names what breaks its structure:
//
//   mechanics <- cases <- {reference, modal, reports} <- harness <- benchmarks    one direction, no edge between
//   answers one door per third-party library: the only place that includes it
//
// Prints "file:line: message" per violation; exit code 0 none, 1 some, 2 unreadable tree.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

// Folder -> folders whose headers it may include, besides its own.
const std::map<std::string, std::set<std::string>> layers = {
    {"mechanics", {}},
    {"cases", {"mechanics"}},
    {"reference", {"mechanics", "cases"}},
    {"modal", {"mechanics", "cases"}},
    {"reports", {"mechanics", "cases"}},
    {"harness", {"mechanics", "cases", "reference", "modal", "reports"}},
    {"benchmarks", {"mechanics", "cases", "reference", "modal", "reports", "harness"}},
};
const std::set<std::string> optional_folders = {"benchmarks"};
// Tests of the reduced answer take their systems from real meshes.
const std::map<std::string, std::set<std::string>> layers_of_tests = {{"modal", {"reference"}}};

struct Door {
  std::string library, header /* regular expression, from the start */, place /* file or folder/ */;
};
const std::vector<Door> doors = {
    {"SuiteSparse", "cholmod|umfpack|SuiteSparse|suitesparse/|Eigen/(Cholmod|UmfPack|SPQR|KLU)Support",
     "mechanics/algebra/"},
    {"BLAS", "cblas|lapacke|openblas|mkl|Eigen/(PaStiX|Pardiso|SuperLU)Support", "mechanics/algebra/"},
    {"muParser", "muParser", "mechanics/history/expression.cc"},
    {"toml++", "toml\\+\\+/|toml\\.h", "cases/scene/toml.cc"},
    {"JSON", "nlohmann/", "cases/json/"},
    {"deal.II", "deal\\.II/", "reference/fem/"},
    {"SUNDIALS", "arkode|cvode|ida|kinsol|nvector/|sundials|sunmatrix/|sunlinsol/|sunnonlinsol/",
     "reference/sundials/"},
    {"ARPACK", "arpack|parpack", "modal/bases/arpack.cc"},
    {"CGAL", "CGAL/", "modal/polygons/tree.cc"},
    {"CLI11", "CLI/|CLI11", "harness/command_line.cc"},
    {"HDF5", "hdf5|H5", "harness/store/hdf5.cc"},
    {"valgrind", "valgrind/", "harness/instruction_counter.cc"},
    {"xxHash", "xxh", "harness/store/hash.cc"},
    {"zlib", "zlib|zconf", "harness/store/inflate.cc"},
    {"SLEPc", "slepc|petsc", "benchmarks/slepc.cc"},
    {"clock", "chrono$|sys/time\\.h|sys/times\\.h", "harness/measure.cc"},
};
// Clocks need no include of their own.
const std::regex clock_call(
    R"(\b(clock_gettime|gettimeofday|steady_clock|system_clock|high_resolution_clock|std::clock)\b)");

// Free everywhere: Eigen and fmt, the test frameworks, the standard library, POSIX.
const std::regex free_header(
    R"((Eigen|fmt|gtest|gmock|benchmark)/[\w./-]+)"
    R"(|(dlfcn|fcntl|sched|unistd|signal|sys/(file|resource|stat|types|wait|mman|mount|prctl|utsname))\.h)"
    R"(|algorithm|any|array|atomic|barrier|bit|bitset|cassert|cctype|cerrno|cfenv|cfloat|charconv|cinttypes)"
    R"(|climits|clocale|cmath|codecvt|compare|complex|concepts|condition_variable|coroutine|csetjmp|csignal|cstdarg)"
    R"(|cstddef|cstdint|cstdio|cstdlib|cstring|ctime|cuchar|cwchar|cwctype|deque|exception|execution|filesystem)"
    R"(|forward_list|fstream|functional|future|initializer_list|iomanip|ios|iosfwd|iostream|istream|iterator|latch)"
    R"(|limits|list|locale|map|memory|memory_resource|mutex|new|numbers|numeric|optional|ostream|queue|random)"
    R"(|ranges|ratio|regex|scoped_allocator|semaphore|set|shared_mutex|source_location|span|sstream|stack|stdexcept)"
    R"(|stop_token|streambuf|string|string_view|strstream|syncstream|system_error|thread|tuple|type_traits|typeindex)"
    R"(|typeinfo|unordered_map|unordered_set|utility|valarray|variant|vector|version)");

// Headers which the build writes, and the folder whose business they are.
const std::map<std::string, std::string> generated = {{"sources.h", "harness"}, {"version.h", "harness"}};

constexpr int max_lines = 300;  // of one file

struct Source {
  std::string path;    // from the root, e.g. "modal/bases/arpack.cc"
  std::string folder;  // its first part
  bool is_test;
};

// What is wrong with one include of a source; empty: nothing.
std::string project_include(const Source& source, const std::string& target) {
  const std::string folder = target.substr(0, target.find('/'));
  if (folder == source.folder || layers.at(source.folder).contains(folder)) return {};
  const auto tests = layers_of_tests.find(source.folder);
  if (source.is_test && tests != layers_of_tests.end() && tests->second.contains(folder)) return {};
  return source.folder + " must not include " + folder + ": \"" + target + "\"";
}

std::string library_include(const Source& source, const std::string& header) {
  for (const Door& door : doors) {
    if (!std::regex_search(header, std::regex("^(" + door.header + ")"))) continue;
    const bool inside = door.place.back() == '/' ? source.path.starts_with(door.place) : source.path == door.place;
    return inside ? "" : "<" + header + "> outside the door of " + door.library + ", " + door.place;
  }
  return std::regex_match(header, free_header) ? "" : "<" + header + "> is of no known library: give it a door";
}

// Quoted headers of the project are found from its root or beside the file that includes them.
std::string include_violation(const Source& source, const fs::path& root, bool quoted, const std::string& header) {
  const std::string first = header.substr(0, header.find('/'));
  if (layers.contains(first) && first != header) return project_include(source, header);
  if (quoted) {
    if (const auto it = generated.find(header); it != generated.end())
      return project_include(source, it->second + "/" + header);
    const fs::path beside = (fs::path(source.path).parent_path() / header).lexically_normal();
    if (layers.contains(beside.begin()->string()) && fs::exists(root / beside))
      return project_include(source, beside.generic_string());
  }
  return library_include(source, header);
}

std::vector<std::string> violations(const fs::path& root, const Source& source) {
  static const std::regex include(R"re(^\s*#\s*include(?:_next)?\s*(["<])([^">]+)[">])re");
  std::ifstream file(root / source.path);
  if (!file) throw std::runtime_error("cannot read " + source.path);
  std::vector<std::string> found;
  int number = 0;
  const auto add = [&](const std::string& message) {
    if (!message.empty()) found.push_back(source.path + ":" + std::to_string(number) + ": " + message);
  };
  for (std::string line; std::getline(file, line);) {
    ++number;
    std::smatch match;
    if (std::regex_search(line, match, include)) add(include_violation(source, root, match[1] == "\"", match[2]));
    const std::string code = line.substr(0, line.find("//"));
    if (source.path != "harness/measure.cc" && std::regex_search(code, match, clock_call))
      add(match.str() + " outside the door of clock, harness/measure.cc");
  }
  if (number > max_lines) add("longer than " + std::to_string(max_lines) + " lines");
  return found;
}

std::vector<Source> sources(const fs::path& root) {
  std::vector<Source> found;
  for (const auto& [folder, lower] : layers) {
    if (optional_folders.contains(folder) && !fs::exists(root / folder)) continue;
    if (!fs::is_directory(root / folder)) throw std::runtime_error("no folder " + folder + " in " + root.string());
    for (auto it = fs::recursive_directory_iterator(root / folder); it != fs::end(it); ++it) {
      const fs::path& path = it->path();
      if (it->is_directory() && path.filename() == "node_modules") it.disable_recursion_pending();
      if (!it->is_regular_file() || (path.extension() != ".h" && path.extension() != ".cc")) continue;
      found.push_back(
          {path.lexically_relative(root).generic_string(), folder, path.stem().string().ends_with("_test")});
    }
  }
  std::sort(found.begin(), found.end(), [](const Source& a, const Source& b) { return a.path < b.path; });
  return found;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("usage: layering ROOT");
  int n_violations = 0;
  const std::vector<Source> files = sources(argv[1]);
  for (const Source& source : files)
    for (const std::string& message : violations(argv[1], source)) {
      std::puts(message.c_str());
      ++n_violations;
    }
  std::printf("%zu files, %d violations\n", files.size(), n_violations);
  return n_violations == 0 ? 0 : 1;
} catch (const std::exception& error) {
  std::fprintf(stderr, "layering: %s\n", error.what());
  return 2;
}
