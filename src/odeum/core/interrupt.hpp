// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <atomic>

namespace odeum {

/// Set by the signal handler of the command line; running work checks it and ends.
inline std::atomic<bool> interrupted{false};

}  // namespace odeum
