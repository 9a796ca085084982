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
#include <string_view>
#include <thread>

#include "odeum/core/interrupt.hpp"
#include "odeum/core/machine.hpp"

namespace odeum::formula {
namespace {

constexpr rlim_t most_memory = rlim_t{2} << 30U;
constexpr double wall_seconds = 8;  // for each of the processor
constexpr int out_of_time = 124;    // what the watcher exits with

/// What the program is given.
struct Start {
  std::vector<std::string> words, variables;
  std::vector<char*> arguments, environment;
  std::string log;

  // Its temporary files are in the folder of the log, with which they go when it is ended.
  Start(const std::vector<std::string>& command, const std::filesystem::path& log_file)
      : words(command), log(log_file.string()) {
    for (char** each = ::environ; each && *each; ++each)
      if (!std::string_view(*each).starts_with("TMPDIR=")) variables.emplace_back(*each);
    variables.push_back("TMPDIR=" + log_file.parent_path().string());
    for (std::string& word : words) arguments.push_back(word.data());
    for (std::string& variable : variables) environment.push_back(variable.data());
    arguments.push_back(nullptr);
    environment.push_back(nullptr);
  }
};

/// Becomes the program in the new process, with its output in the log.
[[noreturn]] void become(const Start& start, double seconds) {
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  const int file = ::open(start.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
  const rlimit memory{most_memory, most_memory};
  const auto whole = static_cast<rlim_t>(std::ceil(seconds));
  const rlimit processor{whole, whole + 1};
  if (file < 0 || nothing < 0 || ::dup2(nothing, 0) < 0 || ::dup2(file, 1) < 0 ||
      ::dup2(file, 2) < 0 || ::setrlimit(RLIMIT_AS, &memory) != 0 ||
      ::setrlimit(RLIMIT_CPU, &processor) != 0)
    ::_exit(127);
  ::execve(start.arguments[0], start.arguments.data(), start.environment.data());
  ::_exit(127);
}

/// In a process between this and the program, the head of a group: ends the group, itself among
/// it, once its parent has ended or the time is over. Only what is safe after fork is called.
[[noreturn]] void watch(pid_t parent, const Start& start, double seconds) {
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
  if (program == 0) become(start, seconds);
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
    // The limit counts by ticks of the clock, of which a shared machine loses some.
    const bool limited = WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU;
    ::_exit(limited || taken >= 0.8 * seconds ? out_of_time : 127);
  }
  ::kill(0, SIGKILL);
  ::_exit(127);
}

}  // namespace

double compiler_seconds() { return number_of_environment("ODEUM_COMPILER_SECONDS", 60); }

std::string run_limited(const std::vector<std::string>& command, const std::filesystem::path& log,
                        double seconds) {
  const Start start(command, std::filesystem::absolute(log));
  const pid_t self = ::getpid();
  const pid_t watcher = ::fork();
  if (watcher < 0) return "failed";
  if (watcher == 0) watch(self, start, seconds);
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
