// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <atomic>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace odeum::scene {

/// Threads that wait for work on the rows of a grid, the caller's among them. The result of a row
/// must not depend on the thread that computes it: then they are the same bits whatever the number
/// of threads.
class RowTeam {
 public:
  /// Throws std::invalid_argument for no thread.
  RowTeam(std::size_t rows, std::size_t threads) : rows_(rows), size_(std::min(rows, threads)) {
    if (threads == 0) throw std::invalid_argument("a grid of springs needs a thread");
    for (std::size_t k = 1; k < size_; ++k) others_.emplace_back([this, k] { serve(k); });
  }
  RowTeam(const RowTeam&) = delete;
  RowTeam& operator=(const RowTeam&) = delete;
  ~RowTeam() {
    ended_ = true;
    announce();
  }

  /// Calls work(first row, last row) once for each share; returns when all are done. One caller at
  /// a time.
  template <class Work>
  void run(Work&& work) {
    if (size_ == 1) return work(0, rows_);
    work_ = std::ref(work);
    left_ = size_ - 1;
    announce();
    share(0);
    while (left_.load(std::memory_order_acquire) != 0) std::this_thread::yield();
  }

 private:
  void share(std::size_t k) { work_(rows_ * k / size_, rows_ * (k + 1) / size_); }
  void announce() {
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
  }
  void serve(std::size_t k) {
    for (unsigned seen = 0;;) {
      // Rounds follow each other within microseconds: sleep only after some spinning.
      for (int i = 0; i < 2000 && round_.load(std::memory_order_acquire) == seen; ++i) {
      }
      round_.wait(seen, std::memory_order_acquire);
      seen = round_.load(std::memory_order_acquire);
      if (ended_) return;
      share(k);
      left_.fetch_sub(1, std::memory_order_release);
    }
  }

  std::size_t rows_, size_;
  std::function<void(std::size_t, std::size_t)> work_;
  std::atomic<unsigned> round_ = 0;
  std::atomic<std::size_t> left_ = 0;
  std::atomic<bool> ended_ = false;
  std::vector<std::jthread> others_;  // last: they use the rest
};

}  // namespace odeum::scene
