#include "harness/commands/open_page.h"

#include <fcntl.h>
#include <fmt/ostream.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

namespace mb {

namespace {

constexpr int not_there = 127;  // as a shell says it

// Exit code of `xdg-open file`; its own output is of no interest here.
int xdg_open(const std::string& file) {
  const pid_t child = ::fork();
  if (child < 0) return not_there;
  if (child == 0) {
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(nowhere, stream);
    ::execlp("xdg-open", "xdg-open", file.c_str(), static_cast<char*>(nullptr));
    ::_exit(not_there);
  }
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

}  // namespace

void open_page(const std::vector<std::filesystem::path>& report, std::ostream& err) {
  const auto page = std::ranges::find(report, "report.html", [](const auto& file) { return file.filename(); });
  if (page == report.end()) {
    fmt::print(err, "--open: there is no report.html to show\n");
    return;
  }
  const std::string file = std::filesystem::absolute(*page);  // nothing that starts with a dash
  const int code = xdg_open(file);
  if (code == not_there)
    fmt::print(err, "--open: there is no xdg-open here; open {} in a browser\n", file);
  else if (code != 0)
    fmt::print(err, "--open: xdg-open shows nothing (exit code {}); open {} in a browser\n", code, file);
}

}  // namespace mb
