// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/isolated/child_process.hpp"

#include <stdio_ext.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <new>

namespace odeum::isolated {

SharedMemory::SharedMemory(std::size_t bytes)
    : bytes_(bytes),
      memory_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
  if (memory_ == MAP_FAILED) throw std::bad_alloc();
}

SharedMemory::~SharedMemory() { munmap(memory_, bytes_); }

pid_t start_child(const std::function<void()>& work) {
  std::fflush(nullptr);
  const pid_t process = fork();
  if (process != 0) return process;
  setpgid(0, 0);
  // What the parent had not yet written is its own to write.
  __fpurge(stdout);
  __fpurge(stderr);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  for (const int number : {SIGINT, SIGTERM, SIGPIPE}) signal(number, SIG_DFL);
  work();
  _exit(0);
}

int end_child(pid_t process) {
  kill(-process, SIGKILL);
  kill(process, SIGKILL);
  int state = 0;
  while (waitpid(process, &state, 0) < 0 && errno == EINTR) continue;
  return state;
}

}  // namespace odeum::isolated
