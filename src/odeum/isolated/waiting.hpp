// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>

#include "odeum/core/outcome.hpp"
#include "odeum/isolated/isolated_process.hpp"
#include "odeum/isolated/report.hpp"

namespace odeum::isolated {

/// A process at work, as the thread sees it that waits for it.
class Worker {
 public:
  Worker() = default;
  virtual ~Worker() = default;
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  /// Waits for a tenth of a second at most: whether it has ended, and how, as waitpid() says it.
  virtual bool ended(int& state) = 0;
  virtual void end() = 0;
};

/// A process that this one has started (start_child).
class OwnWorker : public Worker {
 public:
  explicit OwnWorker(pid_t process);
  ~OwnWorker() override;
  bool ended(int& state) override;
  void end() override;
  /// A descriptor that can be read once it has ended; -1: there is none.
  int descriptor() const { return descriptor_; }

 private:
  pid_t process_;
  int descriptor_;
};

/// Waits until the process ends or has to be ended; how, in a sentence; empty: it is done.
std::string wait_for(Worker& worker, Report& report, double seconds, bool& over_budget,
                     double silence = longest_silence());

/// In the process of the work, which this call makes an isolated one: what it throws goes into the
/// report.
void work_isolated(Report& report, const std::function<void()>& work);

/// The outcome of a solver that is not run again, see solve_isolated.
Outcome not_run();

/// A solve that goes into a report, timed where nothing watches it.
void solve_for(Report& report, const std::function<Outcome(const Request&)>& solve,
               const Request& request, std::size_t room);

/// The outcome of such a solve, how its process ended, and what the waiting since `start` cost.
class Waited {
 public:
  Waited();
  /// `why` and `over_budget` are those of wait_for.
  Outcome outcome(Report& report, const Request& request, std::size_t dimension,
                  const std::string& why, bool over_budget, Ended& ended) const;

 private:
  std::chrono::steady_clock::time_point start_;
  double used_;
};

}  // namespace odeum::isolated
