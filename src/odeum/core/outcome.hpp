// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "odeum/core/request.hpp"
#include "odeum/core/status.hpp"

namespace odeum {

struct Counters {
  std::uint64_t steps = 0;  ///< accepted steps
  std::uint64_t rejected_steps = 0;
  std::uint64_t rhs_evaluations = 0;  ///< counted by Odeum's guard, not by the library
  std::uint64_t jacobian_evaluations = 0;
  /// Products of the derivative with a vector in linear solvers; a factorisation counts as many as
  /// it costs.
  std::uint64_t products = 0;
  /// What a budget counts: evaluations and products, or the steps of a library that computes forces
  /// within itself.
  std::uint64_t work = 0;

  Counters& operator+=(const Counters& more) {
    steps += more.steps;
    rejected_steps += more.rejected_steps;
    rhs_evaluations += more.rhs_evaluations;
    jacobian_evaluations += more.jacobian_evaluations;
    products += more.products;
    work += more.work;
    return *this;
  }
};

/// Whether none of n components is infinite or NaN.
inline bool is_finite(const double* y, std::size_t n) {
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i) sum += y[i] * 0;
  return sum == 0;
}

/// An event of a run: which one of the problem's, and the states before and after.
struct EventMet {
  double t;
  std::size_t event;
  std::vector<double> before, after;
};

/// The result of a solve. `states` holds the state at each stop reached, one after the other.
struct Outcome {
  Status status = Status::ok;
  std::string detail;                                   ///< a sentence where not ok, or a remark
  double t = std::numeric_limits<double>::quiet_NaN();  ///< time reached
  std::vector<double> states;
  std::vector<double> step_ends;  ///< where Request::record_steps asks for them
  std::vector<EventMet> events;   ///< in their order
  Counters counters;

  /// Record the state at a stop; y has n doubles.
  void record(double time, const double* y, std::size_t n) {
    t = time;
    states.insert(states.end(), y, y + n);
  }
};

/// The outcome of a run that was not made.
inline Outcome refused(std::string why) {
  Outcome outcome;
  outcome.status = Status::refused;
  outcome.detail = std::move(why);
  return outcome;
}

}  // namespace odeum
