// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/isolated/child_process.hpp"

#include <fcntl.h>
#include <stdio_ext.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <new>

#include "odeum/core/clocks.hpp"
#include "odeum/core/machine.hpp"

namespace odeum::isolated {
namespace {

/// The data of this process may grow by so much. A sanitizer's own data has no such limit.
void limit_memory(double gigabytes) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  std::ifstream sizes("/proc/self/statm");
  std::array<std::size_t, 6> pages{};  // the last: data and stack
  for (std::size_t& each : pages) sizes >> each;
  const auto page = static_cast<double>(sysconf(_SC_PAGESIZE));
  const auto most = static_cast<rlim_t>(static_cast<double>(pages.back()) * page + 1e9 * gigabytes);
  const rlimit data{most, most};
  setrlimit(RLIMIT_DATA, &data);
#else
  (void)gigabytes;
#endif
}

/// In the process of the work.
[[noreturn]] void work_alone(pid_t keeper, const sigset_t& mask, double gigabytes,
                             const std::function<void()>& work) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != keeper) _exit(1);
  // What the parent had not yet written is its own to write.
  __fpurge(stdout);
  __fpurge(stderr);
  dup2(STDERR_FILENO, STDOUT_FILENO);
  for (const int number : {SIGINT, SIGTERM, SIGPIPE}) signal(number, SIG_DFL);
  sigprocmask(SIG_SETMASK, &mask, nullptr);
  limit_memory(gigabytes);
  // Foreign code that calls exit() runs its own handlers, and not the parent's, which come after.
  on_exit([](int code, void*) { _exit(code); }, nullptr);
  work();
  _exit(0);
}

/// Sends a signal to every child; those of a child that ended are this process's own.
void kill_children() {
  char path[64];
  std::snprintf(path, sizeof path, "/proc/self/task/%d/children", getpid());
  const int file = open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return;
  char text[4096];
  const ssize_t size = read(file, text, sizeof text);
  close(file);
  pid_t process = 0;
  for (ssize_t k = 0; k < size; ++k) {
    if (text[k] >= '0' && text[k] <= '9') {
      process = 10 * process + (text[k] - '0');
    } else if (process > 0) {
      kill(process, SIGKILL);
      process = 0;
    }
  }
}

/// Ends all children, for a second at most where they make others all the time.
void end_children() {
  timespec begin{}, now{};
  clock_gettime(CLOCK_MONOTONIC, &begin);
  do {
    kill_children();
    while (waitpid(-1, nullptr, WNOHANG) > 0) continue;
    if (waitpid(-1, nullptr, WNOHANG) < 0 && errno == ECHILD) return;
    const timespec pause{0, 500'000};
    nanosleep(&pause, nullptr);
    clock_gettime(CLOCK_MONOTONIC, &now);
  } while (now.tv_sec - begin.tv_sec < 2);
}

/// Ends this process as another one has ended.
[[noreturn]] void end_as(int state) {
  if (!WIFSIGNALED(state)) _exit(WEXITSTATUS(state));
  signal(WTERMSIG(state), SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  kill(getpid(), WTERMSIG(state));
  _exit(128 + WTERMSIG(state));
}

/// Between the parent and the process of the work, whose children come to it when that ends.
[[noreturn]] void keep(pid_t parent, Lifetime lifetime, const std::function<void()>& work,
                       double gigabytes) {
  setpgid(0, 0);
  prctl(PR_SET_CHILD_SUBREAPER, 1);
  sigset_t awaited, before;
  sigemptyset(&awaited);
  sigaddset(&awaited, SIGCHLD);
  sigaddset(&awaited, SIGTERM);
  sigprocmask(SIG_BLOCK, &awaited, &before);
  signal(SIGCHLD, SIG_DFL);
  signal(SIGTERM, SIG_DFL);
  const rlimit none{0, 0};
  setrlimit(RLIMIT_CORE, &none);
  if (lifetime == Lifetime::thread) prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() != parent) _exit(1);
  const pid_t self = getpid(), worker = fork();
  if (worker < 0) _exit(1);
  if (worker == 0) work_alone(self, before, gigabytes, work);
  // The worker sees by its own ends of pipes alone that the parent has ended.
  close_range(STDERR_FILENO + 1, ~0U, 0);
  int state = 0;
  while (sigwaitinfo(&awaited, nullptr) != SIGTERM) {
    if (waitpid(worker, &state, WNOHANG) != worker) continue;
    end_children();
    end_as(state);
  }
  end_children();
  end_as(SIGKILL);
}

}  // namespace

SharedMemory::SharedMemory(std::size_t bytes)
    : bytes_(bytes),
      memory_(mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0)) {
  if (memory_ == MAP_FAILED) throw std::bad_alloc();
}

SharedMemory::~SharedMemory() { munmap(memory_, bytes_); }

void SharedMemory::seal() const { mprotect(memory_, bytes_, PROT_READ); }

pid_t start_child(Lifetime lifetime, const std::function<void()>& work) {
  const double gigabytes = number_of_environment("ODEUM_FOREIGN_GIGABYTES", 4);
  std::fflush(nullptr);
  const pid_t parent = getpid(), process = fork();
  if (process == 0) keep(parent, lifetime, work, gigabytes);
  return process;
}

int end_child(pid_t process) {
  const auto start = std::chrono::steady_clock::now();
  int state = 0;
  kill(process, SIGTERM);
  while (seconds_since(start) < 3) {
    const pid_t ended = waitpid(process, &state, WNOHANG);
    if (ended == process || (ended < 0 && errno != EINTR)) return state;
    const timespec pause{0, 200'000};
    nanosleep(&pause, nullptr);
  }
  kill(-process, SIGKILL);
  kill(process, SIGKILL);
  while (waitpid(process, &state, 0) < 0 && errno == EINTR) continue;
  return state;
}

}  // namespace odeum::isolated
