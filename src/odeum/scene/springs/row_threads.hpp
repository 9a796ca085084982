// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <barrier>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace odeum::scene {

/// Runs body(first row, last row, wait) on each thread's share of the rows; `wait()` waits for all
/// others. Each row's results must not depend on whose share it is: then they are the same bits
/// whatever the number of threads.
using RowWork = std::function<void(std::size_t, std::size_t, const std::function<void()>&)>;

inline void on_rows(std::size_t rows, std::size_t most_threads, const RowWork& body) {
  const std::size_t threads = std::min(most_threads, rows);
  std::barrier<> meeting(static_cast<std::ptrdiff_t>(threads));
  const std::function<void()> wait = [&] {
    if (threads > 1) meeting.arrive_and_wait();
  };
  std::vector<std::jthread> others;
  for (std::size_t k = 1; k < threads; ++k)
    others.emplace_back([&, k] { body(rows * k / threads, rows * (k + 1) / threads, wait); });
  body(0, rows / threads, wait);
}

}  // namespace odeum::scene
