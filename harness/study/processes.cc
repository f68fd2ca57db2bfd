#include "harness/study/processes.h"

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <iostream>
#include <system_error>
#include <vector>

namespace mb {

namespace {

int exit_code(pid_t process) {
  int status = 0;
  while (waitpid(process, &status, 0) < 0)
    if (errno != EINTR) return 3;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 3;
}

}  // namespace

int in_processes(int n, const std::function<int(int)>& work) {
  std::cout.flush(), std::cerr.flush(), std::fflush(nullptr);  // or children would print it again
  std::vector<pid_t> processes;
  int error = 0;
  for (int i = 1; i <= n && error == 0; ++i) {
    const pid_t process = fork();
    if (process == 0) {
      int code = 3;
      try {
        code = work(i);
      } catch (const std::exception& failure) {
        std::cerr << failure.what() << '\n';
      }
      std::cout.flush(), std::cerr.flush();
      _exit(code);  // destructors of what the parent owns are the parent's
    }
    if (process < 0)
      error = errno;
    else
      processes.push_back(process);
  }
  int code = 0;
  for (const pid_t process : processes) code = std::max(code, exit_code(process));
  if (error != 0) throw std::system_error(error, std::generic_category(), "fork");
  return code;
}

}  // namespace mb
