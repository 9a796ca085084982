// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "odeum/core/outcome.hpp"
#include "odeum/isolated/isolated_process.hpp"

namespace odeum::isolated {

/// While one lives, what this thread solves are problems that do not change between solves. Without
/// it LoadedProcesses copies no process, since its problem is the one of its start.
class Unchanging {
 public:
  Unchanging();
  ~Unchanging();
  Unchanging(const Unchanging&) = delete;
  Unchanging& operator=(const Unchanging&) = delete;

 private:
  bool before_;
};

/// What a process is made ready for: to solve one problem by any solver of a library.
struct LoadedWork {
  std::shared_ptr<const void> problem;  ///< which one, by its address
  std::size_t dimension = 0;
  std::function<void()> load;  ///< what all solves need
  std::function<Outcome(std::size_t solver, const Request&)> solve;
};

/// Processes in which a library is loaded, so that a start of half a second, as that of an
/// interpreter with its packages, is paid once for a problem and not in every solve. Each solve is
/// made in a copy (fork) of one, and what it does is lost with the copy. A library that has begun
/// threads when it is loaded, which no copy has, is loaded in each solve. Thread-safe.
class LoadedProcesses {
 public:
  LoadedProcesses();
  ~LoadedProcesses();
  LoadedProcesses(const LoadedProcesses&) = delete;
  LoadedProcesses& operator=(const LoadedProcesses&) = delete;

  /// As solve_isolated does, and nothing else where the problem may change (Unchanging).
  Outcome solve(const LoadedWork& work, std::size_t solver, const Request& request, Ended& ended);

 private:
  class Process;
  std::unique_ptr<Process> take(const LoadedWork& work, std::size_t bytes);
  void give_back(std::unique_ptr<Process> process);

  std::mutex mutex_;
  std::vector<std::unique_ptr<Process>> idle_;  ///< the latest used is the last
  bool copied_ = true;  ///< a copy of a process that has loaded the library can be made
};

}  // namespace odeum::isolated
