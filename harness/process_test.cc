#include "harness/process_test.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <thread>

namespace mb {

namespace {

std::string content(const std::filesystem::path& file) {
  std::ostringstream all;
  all << std::ifstream(file).rdbuf();
  return all.str();
}

struct State {
  char letter = '?';  // of proc(5): R, S, Z, ...; '?': there is none
  pid_t parent = 0;
};

// "id (name) S parent ...", where the name may hold anything.
State state_of(pid_t process) {
  const std::string line = content("/proc/" + std::to_string(process) + "/stat");
  const auto end_of_name = line.rfind(") ");
  State state;
  if (end_of_name != std::string::npos)
    std::istringstream(line.substr(end_of_name + 2)) >> state.letter >> state.parent;
  return state;
}

// Of a line of numbers to that base in /proc/PROCESS/status; 0 where it has ended.
unsigned long long status_of(pid_t process, std::string_view key, int base) {
  std::ifstream status(std::filesystem::path("/proc") / std::to_string(process) / "status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(key)) return std::stoull(line.substr(key.size()), nullptr, base);
  return 0;
}

void become(int descriptor, const char* file) {
  const int opened = ::open(file, O_WRONLY | O_CREAT | O_TRUNC, 0644);
  ::dup2(opened, descriptor);
}

}  // namespace

Process::Process(const std::filesystem::path& folder, const std::vector<std::string>& words,
                 const std::function<void()>& prepare) {
  static int n_started = 0;
  const std::string name = ".process-" + std::to_string(++n_started);
  out_ = folder / (name + ".out");
  err_ = folder / (name + ".err");
  std::vector<char*> argv{const_cast<char*>(MB_PROGRAM)};
  for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  process_ = ::fork();
  if (process_ < 0) throw std::runtime_error("no process");
  if (process_ > 0) return;
  become(STDOUT_FILENO, out_.c_str());
  become(STDERR_FILENO, err_.c_str());
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, SIG_DFL);
  if (::chdir(folder.c_str()) != 0) ::_exit(126);
  if (prepare) prepare();
  ::execv(MB_PROGRAM, argv.data());
  ::_exit(127);
}

Process::~Process() {
  if (ended_) return;
  ::kill(process_, SIGKILL);
  ::waitpid(process_, &status_, 0);
}

void Process::send(int signal) const {
  if (!ended_) ::kill(process_, signal);
}
void Process::send_to_group(int signal) const { ::kill(-process_, signal); }

bool Process::reap(int options) {
  rusage used{};
  ended_ = ::wait4(process_, &status_, options, &used) == process_;
  if (ended_) most_resident_ = used.ru_maxrss;
  return ended_;
}

bool Process::ends_within(double seconds) {
  for (double waited = 0; !ended_ && waited <= seconds; waited += 0.002) {
    if (!reap(WNOHANG)) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return ended_;
}

int Process::code() {
  if (!ended_) reap(0);
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : -WTERMSIG(status_);
}

double Process::most_memory() {
  code();
  return 1024.0 * static_cast<double>(most_resident_);
}

double Process::most_memory_of_its_own() {
  unsigned long long most = 0;  // [KiB]
  while (!ended_ && !reap(WNOHANG)) {
    most = std::max(most, status_of(process_, "RssAnon:", 10) + status_of(process_, "VmSwap:", 10));
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return 1024 * static_cast<double>(most);
}

std::vector<pid_t> Process::children() const {
  std::vector<pid_t> found;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    if (state_of(std::stoi(name)).parent == process_ && is_running(std::stoi(name))) found.push_back(std::stoi(name));
  }
  return found;
}

bool Process::handles(int signal) const { return status_of(process_, "SigCgt:", 16) >> (signal - 1) & 1; }

bool metis_takes_signals() { return MB_METIS_TAKES_SIGNALS; }

bool is_running(pid_t process) { return std::string_view("?ZX").find(state_of(process).letter) == std::string::npos; }

std::string Process::out() const { return content(out_); }
std::string Process::err() const { return content(err_); }

}  // namespace mb
