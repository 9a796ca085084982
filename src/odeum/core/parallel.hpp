// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <vector>

#include "odeum/core/interrupt.hpp"

namespace odeum {

/// Thrown by interrupted work once its threads have ended.
class Interrupted : public std::runtime_error {
 public:
  Interrupted() : std::runtime_error("interrupted") {}
};

/// Calls work(i) for every i below `count`, `jobs` at a time, in no particular order; work stores
/// its result by i, so that results do not depend on the number of jobs. Rethrows the first
/// exception; throws Interrupted where `interrupted` was set before all were done.
template <class Work>
void parallel_for(std::size_t count, unsigned jobs, Work&& work) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> stop{false};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto worker = [&] {
    for (std::size_t i = 0; !stop && !interrupted && (i = next++) < count;) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(failure_mutex);
        if (!failure) failure = std::current_exception();
        stop = true;
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    const auto helpers =
        std::min<std::size_t>(std::max(jobs, 1U), std::max<std::size_t>(count, 1)) - 1;
    for (std::size_t i = 0; i < helpers; ++i) threads.emplace_back(worker);
    worker();
  }
  if (failure) std::rethrow_exception(failure);
  if (interrupted) throw Interrupted();
}

}  // namespace odeum
