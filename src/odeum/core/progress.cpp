// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>

#include "odeum/core/standard_streams.hpp"

namespace odeum {

Progress::Progress(std::string what, double total)
    : what_(std::move(what)), total_(total), visible_(::isatty(STDERR_FILENO) != 0) {}

Progress::~Progress() {
  if (visible_) tell_in_place("");
}

void Progress::advance(double amount) {
  const std::lock_guard lock(mutex_);
  done_ += amount;
  const auto now = Clock::now();
  if (!visible_ || now - drawn_ < std::chrono::milliseconds(200)) return;
  drawn_ = now;
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double share = total_ > 0 ? std::min(done_ / total_, 1.0) : 1;
  const double left = share > 0 ? elapsed * (1 - share) / share : 0;
  tell_in_place(fmt::format("{} {:3.0f}%, {:.0f} s left", what_, 100 * share, left));
}

}  // namespace odeum
