// SPDX-License-Identifier: BSD-3-Clause
#pragma once
// Plain C++17, see ode_view.hpp.
#include <cmath>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "odeum/core/tolerance.hpp"

namespace odeum {

/// Limits on the cost of a solve. The evaluations are meant to decide (the same on every machine,
/// so that results do not depend on speed); the seconds guard against solves that never end.
struct Budget {
  std::uint64_t evaluations = 200'000'000;
  double seconds = 60;
  /// False in timed runs alone: evaluations are neither counted nor checked, and nothing is
  /// bounded.
  bool watched = true;
};

/// Fixed step, or the step chosen by the solver to meet a tolerance.
enum class Mode { fixed, adaptive };

inline const char* to_string(Mode mode) { return mode == Mode::fixed ? "fixed" : "adaptive"; }

/// A request to a solver: integrate from t0 to the last stop and record the state at every stop.
struct Request {
  Mode mode = Mode::fixed;
  std::uint64_t steps = 0;    ///< fixed: the number of equal steps from t0 to the last stop
  Tolerance tolerance = 0;    ///< adaptive
  std::vector<double> stops;  ///< strictly increasing times, the last one is the horizon
  /// Adaptive: stops before the last do not limit the steps; states there come from inside them, at
  /// the order of the method (own solvers, control/adaptive.hpp) or by a library's interpolant
  /// where it has one. For output; where errors are measured, steps end on the stops.
  bool over_stops = false;
  /// Adaptive, own solvers: the ends of the accepted steps go to Outcome::step_ends.
  bool record_steps = false;
  Budget budget = {};
  /// Values for options that the solver has of its own, see SolverInfo::options. Without a value an
  /// option has the default of the solver's library; other names are ignored.
  std::map<std::string, double> options = {};
};

/// Throws std::invalid_argument where a request is malformed: no stops, or stops that are not
/// finite, after t0 and strictly increasing; no steps; a tolerance that is not positive and finite;
/// another number of absolute tolerances than one or that of the state, `dimension`.
void require_sound(const Request& request, double t0, std::size_t dimension);

/// The times of a fixed-step run: t(i) = t0 + i*h, ending exactly at the horizon, with every stop
/// on the grid (design rule: no step is ever shortened in a fixed-step run).
class FixedGrid {
 public:
  FixedGrid(double t0, const Request& request)
      : t0_(t0),
        request_(request),
        h_((request.stops.back() - t0) / static_cast<double>(request.steps)),
        unchecked_(request.budget.watched ? 0 : 15) {}

  double h() const { return h_; }
  std::uint64_t steps() const { return request_.steps; }
  double t(std::uint64_t i) const {
    return i == request_.steps ? request_.stops.back() : t0_ + static_cast<double>(i) * h_;
  }
  /// Whether to check that the state after step i is finite, which ends the run where it is not:
  /// after each step, in timed runs after every 16th.
  bool checks(std::uint64_t i) const { return (i & unchecked_) == unchecked_; }
  std::size_t stop_count() const { return request_.stops.size(); }
  /// The step index after which stop number `stop` is reached.
  std::uint64_t index_of(std::size_t stop) const {
    return static_cast<std::uint64_t>(std::llround((request_.stops[stop] - t0_) / h_));
  }
  /// Whether every stop falls on a step, to within rounding.
  bool fits() const {
    for (std::size_t k = 0; k < stop_count(); ++k) {
      const double exact = (request_.stops[k] - t0_) / h_;
      if (std::abs(exact - std::round(exact)) > 1e-6 || std::round(exact) < 1) return false;
    }
    return true;
  }

 private:
  double t0_;
  const Request& request_;
  double h_;
  std::uint64_t unchecked_;
};

}  // namespace odeum
