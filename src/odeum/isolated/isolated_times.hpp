// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace odeum {

/// What solves in processes of their own (isolated_process.hpp) cost the thread that waited for
/// them. A clock leaves out `isolation_ns` and a meter of processor time adds `processor_s`, so
/// that both see the solve as if the thread had made it.
struct IsolatedTimes {
  double isolation_ns = 0;  ///< wall time that was spent on anything but the timed solve
  /// Processor time of the solve, and of the isolation what the thread did not use itself.
  double processor_s = 0;
};
inline thread_local IsolatedTimes isolated_times;

}  // namespace odeum
