// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/limited_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <ctime>
#include <thread>

#include "odeum/core/interrupt.hpp"
#include "odeum/core/machine.hpp"

namespace odeum::formula {
namespace {

constexpr rlim_t most_memory = rlim_t{2} << 30U;
constexpr double wall_seconds = 8;  // for each of the processor
constexpr int out_of_time = 124;    // what the watcher exits with

/// Becomes the program in the new process, with its output in the log.
[[noreturn]] void become(char* const* arguments, const char* log, double seconds) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int file = ::open(log, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const rlimit memory{most_memory, most_memory};
  const auto whole = static_cast<rlim_t>(std::ceil(seconds));
  const rlimit processor{whole, whole};
  if (file < 0 || nothing < 0 || ::dup2(nothing, 0) < 0 || ::dup2(file, 1) < 0 ||
      ::dup2(file, 2) < 0 || ::setrlimit(RLIMIT_AS, &memory) != 0 ||
      ::setrlimit(RLIMIT_CPU, &processor) != 0)
    ::_exit(127);
  ::execv(arguments[0], arguments);
  ::_exit(127);
}

/// In a process between this and the program, the head of a group: ends the group, itself among
/// it, once its parent has ended or the time is over. Only what is safe after fork is called.
[[noreturn]] void watch(pid_t parent, char* const* arguments, const char* log, double seconds) {
  ::setpgid(0, 0);
  sigset_t awaited;
  sigemptyset(&awaited);
  sigaddset(&awaited, SIGCHLD);
  sigaddset(&awaited, SIGTERM);
  sigprocmask(SIG_SETMASK, &awaited, nullptr);
  ::signal(SIGCHLD, SIG_DFL);
  ::signal(SIGTERM, SIG_DFL);
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (::getppid() != parent) ::_exit(127);
  const pid_t program = ::fork();
  if (program < 0) ::_exit(127);
  if (program == 0) become(arguments, log, seconds);
  timespec left{};
  const double wall = wall_seconds * seconds;
  left.tv_sec = static_cast<time_t>(wall);
  left.tv_nsec = static_cast<long>(1e9 * (wall - std::floor(wall)));
  while (sigtimedwait(&awaited, nullptr, &left) == SIGCHLD) {
    int status = 0;
    if (::waitpid(program, &status, WNOHANG) != program) continue;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) ::_exit(0);
    rusage used{};
    ::getrusage(RUSAGE_CHILDREN, &used);
    const auto taken = static_cast<double>(used.ru_utime.tv_sec + used.ru_stime.tv_sec) +
                       1e-6 * static_cast<double>(used.ru_utime.tv_usec + used.ru_stime.tv_usec);
    ::_exit(taken >= 0.95 * seconds ? out_of_time : 127);
  }
  ::kill(0, SIGKILL);
  ::_exit(127);
}

}  // namespace

double compiler_seconds() { return seconds_of_environment("ODEUM_COMPILER_SECONDS", 60); }

std::string run_limited(const std::vector<std::string>& command, const std::filesystem::path& log,
                        double seconds) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const std::string log_name = log.string();
  const pid_t self = ::getpid();
  const pid_t watcher = ::fork();
  if (watcher < 0) return "failed";
  if (watcher == 0) watch(self, arguments.data(), log_name.c_str(), seconds);
  ::setpgid(watcher, watcher);  // as the watcher itself does: whoever comes first
  int status = 0;
  while (true) {
    const pid_t ended = ::waitpid(watcher, &status, WNOHANG);
    if (ended == watcher) break;
    if (ended < 0 && errno != EINTR) return "failed";
    if (interrupted) ::kill(-watcher, SIGKILL);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ::kill(-watcher, SIGKILL);  // what the program left behind
  if (WIFSIGNALED(status))
    return fmt::format("did not end within {:.3g} s and was ended with all that it had started",
                       wall_seconds * seconds);
  if (WEXITSTATUS(status) == out_of_time)
    return fmt::format("took more than {:.3g} s of the processor and was ended", seconds);
  return WEXITSTATUS(status) == 0 ? "" : "failed";
}

}  // namespace odeum::formula
