// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.

namespace odeum {

/// How a solve ended. A numerical failure is an outcome; exceptions are for misuse and bad input.
enum class Status { ok, step_too_small, newton_failed, non_finite, over_budget, refused };

inline const char* to_string(Status status) {
  switch (status) {
    case Status::ok:
      return "ok";
    case Status::step_too_small:
      return "step_too_small";
    case Status::newton_failed:
      return "newton_failed";
    case Status::non_finite:
      return "non_finite";
    case Status::over_budget:
      return "over_budget";
    case Status::refused:
      return "refused";
  }
  return "refused";
}

}  // namespace odeum
