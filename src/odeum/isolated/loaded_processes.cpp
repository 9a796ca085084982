// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/isolated/loaded_processes.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstring>
#include <exception>
#include <filesystem>
#include <iterator>
#include <new>
#include <string>
#include <utility>

#include "odeum/isolated/child_process.hpp"
#include "odeum/isolated/handed_request.hpp"
#include "odeum/isolated/waiting.hpp"

namespace odeum::isolated {
namespace {

thread_local bool problem_is_unchanging = false;

constexpr char ready = 'r', solve_word = 's', end_word = 'e';

/// At the start of the memory that a process shares; the report follows, then the request.
struct Asked {
  std::size_t solver = 0, room = 0;
};
constexpr std::size_t report_at = 64;
static_assert(sizeof(Asked) <= report_at);

std::size_t request_at(std::size_t room) {
  return report_at + sizeof(Report) + (room + event_room) * sizeof(double);
}

bool readable(int socket, int milliseconds) {
  pollfd wait{.fd = socket, .events = POLLIN, .revents = 0};
  return poll(&wait, 1, milliseconds) == 1;
}

bool one_thread() {
  std::error_code failed;
  const std::filesystem::directory_iterator threads("/proc/self/task", failed);
  return !failed && std::distance(begin(threads), end(threads)) == 1;
}

/// Waits for the copy, and ends it where the other side says so or has ended; its state.
int state_of_copy(pid_t process, int socket) {
  const OwnWorker copy(process);
  int state = 0;
  for (;;) {
    pollfd both[] = {{.fd = socket, .events = POLLIN, .revents = 0},
                     {.fd = copy.descriptor(), .events = POLLIN, .revents = 0}};
    poll(both, 2, copy.descriptor() >= 0 ? -1 : 1);
    if (waitpid(process, &state, WNOHANG) == process) return state;
    if (both[0].revents == 0) continue;
    char word = 0;
    if (read(socket, &word, 1) != 1 || word == end_word) return end_child(process);
  }
}

}  // namespace

Unchanging::Unchanging() : before_(std::exchange(problem_is_unchanging, true)) {}
Unchanging::~Unchanging() { problem_is_unchanging = before_; }

/// One of the processes, and the worker that a thread waits for while a copy of it solves.
class LoadedProcesses::Process : public Worker {
 public:
  Process(const LoadedWork& work, std::size_t bytes)
      : problem_(work.problem), bytes_(bytes), memory_(bytes) {
    int pair[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, pair) != 0) return;
    process_ = start_child(Lifetime::open, [&] { serve(work, pair[1]); });
    close(pair[1]);
    socket_ = pair[0];
  }
  ~Process() override { stop(); }

  /// Whether copies can be made of it. The patience is that of a machine with much else to do.
  bool loaded() const {
    char word = 0;
    const int patience = static_cast<int>(10'000 * longest_silence());
    return process_ > 0 && readable(socket_, patience) && read(socket_, &word, 1) == 1 &&
           word == ready;
  }
  bool fits(const std::shared_ptr<const void>& problem, std::size_t bytes) const {
    return problem_ == problem && bytes <= bytes_;
  }
  bool alive() const { return process_ > 0; }

  Report& report() { return *std::launder(reinterpret_cast<Report*>(at(report_at))); }
  void ask(std::size_t solver, std::size_t room, const std::string& request) {
    new (at(0)) Asked{solver, room};
    new (at(report_at)) Report;
    std::memcpy(at(request_at(room)), request.data(), request.size());
    send(socket_, &solve_word, 1, MSG_NOSIGNAL);
  }

  bool ended(int& state) override {
    if (!readable(socket_, 100)) return false;
    if (read(socket_, &state, sizeof state) != sizeof state) state = stop();
    return true;
  }
  void end() override {
    send(socket_, &end_word, 1, MSG_NOSIGNAL);
    int state = 0;
    constexpr int patience = 5000;  // end_child() waits for three seconds
    if (!readable(socket_, patience) || read(socket_, &state, sizeof state) != sizeof state) stop();
  }

 private:
  char* at(std::size_t offset) const { return static_cast<char*>(memory_.get()) + offset; }

  int stop() {
    if (socket_ >= 0) close(std::exchange(socket_, -1));
    return process_ > 0 ? end_child(std::exchange(process_, -1)) : 0;
  }

  /// In the process itself: loads, and solves in copies until the other side is closed.
  void serve(const LoadedWork& work, int socket) {
    // Ends of sockets that belong to others would hide that the parent has ended.
    const auto own = static_cast<unsigned>(socket);
    if (own > STDERR_FILENO + 1) close_range(STDERR_FILENO + 1, own - 1, 0);
    close_range(own + 1, ~0U, 0);
    try {
      work.load();
    } catch (const std::exception&) {
      return;  // each solve says why
    }
    char word = one_thread() ? ready : end_word;
    if (write(socket, &word, 1) != 1 || word != ready) return;
    while (read(socket, &word, 1) == 1) {
      if (word != solve_word) continue;  // an end that came late
      const int state = solved(work, socket);
      if (write(socket, &state, sizeof state) != sizeof state) return;
    }
  }

  int solved(const LoadedWork& work, int socket) {
    const Asked asked = *std::launder(reinterpret_cast<Asked*>(at(0)));
    const pid_t process = start_child(Lifetime::thread, [&] {
      work_isolated(report(), [&] {
        const Request request = request_of(at(request_at(asked.room)));
        solve_for(
            report(), [&](const Request& inner) { return work.solve(asked.solver, inner); },
            request, asked.room);
      });
    });
    if (process > 0) return state_of_copy(process, socket);
    report().status = static_cast<int>(Status::refused);
    report().say("no process could be made");
    report().done = true;
    return 0;
  }

  std::shared_ptr<const void> problem_;
  std::size_t bytes_;
  SharedMemory memory_;
  pid_t process_ = -1;
  int socket_ = -1;
};

LoadedProcesses::LoadedProcesses() = default;
LoadedProcesses::~LoadedProcesses() = default;

std::unique_ptr<LoadedProcesses::Process> LoadedProcesses::take(const LoadedWork& work,
                                                                std::size_t bytes) {
  constexpr std::size_t most_idle = 4;  // each has the memory of the library that it loaded
  std::unique_ptr<Process> too_many;    // ended outside of the lock
  {
    const std::lock_guard lock(mutex_);
    if (!copied_) return nullptr;
    const auto found = std::ranges::find_if(
        idle_, [&](const auto& each) { return each->fits(work.problem, bytes); });
    if (found != idle_.end()) {
      auto process = std::move(*found);
      idle_.erase(found);
      return process;
    }
    if (idle_.size() >= most_idle) {
      too_many = std::move(idle_.front());
      idle_.erase(idle_.begin());
    }
  }
  auto process = std::make_unique<Process>(work, 2 * bytes);
  if (process->loaded()) return process;
  const std::lock_guard lock(mutex_);
  copied_ = false;
  return nullptr;
}

void LoadedProcesses::give_back(std::unique_ptr<Process> process) {
  if (!process->alive()) return;
  const std::lock_guard lock(mutex_);
  idle_.push_back(std::move(process));
}

Outcome LoadedProcesses::solve(const LoadedWork& work, std::size_t solver, const Request& request,
                               Ended& ended) {
  const auto alone = [&](const Request& inner) { return work.solve(solver, inner); };
  if (in_isolated_process()) return alone(request);
  if (!problem_is_unchanging) return solve_isolated(alone, request, work.dimension, ended);
  if (ended >= most_ended) return not_run();
  const Waited waited;
  const std::size_t room = request.stops.size() * work.dimension;
  const std::string bytes = bytes_of(request);
  std::unique_ptr<Process> process = take(work, request_at(room) + bytes.size());
  if (!process) return solve_isolated(alone, request, work.dimension, ended);
  process->ask(solver, room, bytes);
  bool over_budget = false;
  const std::string why =
      wait_for(*process, process->report(), request.budget.seconds, over_budget);
  Outcome outcome =
      waited.outcome(process->report(), request, work.dimension, why, over_budget, ended);
  give_back(std::move(process));
  return outcome;
}

}  // namespace odeum::isolated
