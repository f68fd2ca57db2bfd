#include "harness/instruction_counter.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>

#include "harness/callgrind_dump.h"
#include "harness/study/processes.h"
#include "reports/held_signals.h"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else  // built without valgrind: nothing is counted
#define RUNNING_ON_VALGRIND 0
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_STOP_INSTRUMENTATION
#define CALLGRIND_ZERO_STATS
#define CALLGRIND_DUMP_STATS_AT(name) static_cast<void>(name)
#endif

namespace mb {

namespace {

namespace fs = std::filesystem;

class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (fs::temp_directory_path() / "modalbench-count-XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw std::runtime_error("no folder can be made in " + fs::temp_directory_path().string());
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

constexpr int no_valgrind = 125;  // itself it says 127 of a program that is not there

// Of a child: nothing is allocated there, as another thread may have held the allocator's lock. Never returns.
[[noreturn]] void become(char* const* argv) {
  sigset_t ends;
  sigemptyset(&ends);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (std::signal(signal, SIG_DFL) == SIG_IGN) std::signal(signal, SIG_IGN);  // as nohup has it
    sigaddset(&ends, signal);
  }
  ::sigprocmask(SIG_UNBLOCK, &ends, nullptr);
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // it ends with its parent, however that ends
  const int nowhere = ::open("/dev/null", O_RDWR);
  for (const int stream : {0, 1, 2}) ::dup2(nowhere, stream);
  ::execvp(argv[0], argv);
  ::_exit(no_valgrind);
}

bool has_ended(pid_t child) {  // and is still to be waited for
  siginfo_t info{};
  return ::waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) != 0 || info.si_pid == child;
}

// Exit code of a child, or 128 and its signal; it is ended after so many seconds. Its number is free for others once it
// has been waited for: no signal is passed on to it by then.
int ended(pid_t child, double at_most, std::optional<Reached>& passed_on) {
  constexpr double look = 0.05;  // [s]
  for (double waited = 0; !has_ended(child); waited += look) {
    if (waited > at_most) ::kill(child, SIGKILL);
    ::usleep(static_cast<useconds_t>(1e6 * look));
  }
  passed_on.reset();
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

// A child that somebody ends, as Ctrl-C does, has counted nothing, and nothing follows for the program.
void require_not_ended_from_outside(int code) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (code == 128 + signal) throw std::runtime_error(fmt::format("valgrind was ended by signal {}", signal));
}

std::string reason(int code, double at_most) {
  switch (code) {
    case no_valgrind:
      return "valgrind is not installed";
    case 128 + SIGILL:
      return "valgrind does not know an instruction of this build (AVX); the portable one, preset 'release', can be "
             "counted";
    case 128 + SIGKILL:
      return fmt::format("valgrind had not finished after {:g} s", at_most);
    default:
      return fmt::format("valgrind ended with code {}", code);
  }
}

}  // namespace

bool is_counting() { return RUNNING_ON_VALGRIND != 0; }

void counted(const std::string& name, const std::function<void()>& work) {
  CALLGRIND_START_INSTRUMENTATION;
  CALLGRIND_ZERO_STATS;
  work();
  CALLGRIND_STOP_INSTRUMENTATION;
  CALLGRIND_DUMP_STATS_AT(name.c_str());
}

InstructionCounts count_instructions(const fs::path& program, const std::vector<std::string>& words, double at_most) {
  const ScratchFolder scratch;
  std::vector<std::string> line{"valgrind", "--tool=callgrind", "--instr-atstart=no",
                                "--callgrind-out-file=" + (scratch.path() / "out").string(), program.string()};
  line.insert(line.end(), words.begin(), words.end());
  std::vector<char*> argv;
  for (std::string& word : line) argv.push_back(word.data());
  argv.push_back(nullptr);
  auto held = std::make_optional<HeldSignals>();
  const pid_t child = ::fork();
  if (child < 0) return {{}, "no process can be made"};
  if (child == 0) become(argv.data());
  std::optional<Reached> passed_on(std::in_place, child);
  held.reset();
  const int code = ended(child, at_most, passed_on);
  require_not_ended_from_outside(code);
  InstructionCounts counts = read_dumps(scratch.path());
  if (code != 0)
    counts.missing = reason(code, at_most);  // which is why dumps are cut off, too
  else if (counts.by_name.empty() && counts.missing.empty())
    counts.missing = "the program was built without valgrind's headers";
  return counts;
}

InstructionCounts read_dumps(const fs::path& folder) {
  InstructionCounts counts;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::ifstream file(entry.path(), std::ios::binary);
    const DumpedCount count = dumped_count(std::string(std::istreambuf_iterator<char>(file), {}));
    if (!count.problem.empty())
      counts.missing = count.problem;
    else if (!count.name.empty())
      counts.by_name[count.name] = count.instructions;
  }
  return counts;
}

}  // namespace mb
