// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ctime>

namespace odeum {

/// Processor time of the calling thread.
inline double processor_seconds() {
  timespec used{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &used);
  return static_cast<double>(used.tv_sec) + 1e-9 * static_cast<double>(used.tv_nsec);
}

}  // namespace odeum
