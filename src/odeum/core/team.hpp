// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <atomic>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <thread>
#include <vector>

namespace odeum {

/// Threads that wait for work on rows, the caller's among them. The result of a row must not depend
/// on the thread that computes it: then they are the same bits whatever the number of threads.
class Team {
 public:
  /// Throws std::invalid_argument for no thread.
  explicit Team(std::size_t threads) : size_(threads) {
    if (threads == 0) throw std::invalid_argument("a team needs a thread");
    for (std::size_t k = 1; k < size_; ++k) others_.emplace_back([this, k] { serve(k); });
  }
  Team(const Team&) = delete;
  Team& operator=(const Team&) = delete;
  ~Team() {
    ended_ = true;
    announce();
  }

  std::size_t size() const { return size_; }
  /// Calls work(first row, end) once for each share of the rows; returns when all are done. `work`
  /// must not throw where there are several threads. One caller at a time.
  template <class Work>
  void run(std::size_t rows, Work&& work) {
    if (size_ == 1) return work(0, rows);
    rows_ = rows;
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

  std::size_t size_, rows_ = 0;
  std::function<void(std::size_t, std::size_t)> work_;
  std::atomic<unsigned> round_ = 0;
  std::atomic<std::size_t> left_ = 0;
  std::atomic<bool> ended_ = false;
  std::vector<std::jthread> others_;  // last: they use the rest
};

}  // namespace odeum
