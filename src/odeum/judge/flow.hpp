// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::judge {

/// The flow of a case by an own explicit method to a tolerance, or by radau_iia5 where the explicit
/// one takes more than 20,000 evaluations to the end, and radau_iia5 no more than those. States
/// have as many numbers as c.y0, times are those of the case, which has to outlive it. For one
/// thread.
class Flow {
 public:
  /// Throws std::runtime_error, with a clause that says why, where neither method gets to `end`.
  Flow(const Case& c, double end, const char* explicit_method, const Tolerance& tolerance);

  bool is_explicit() const { return method_ == explicit_method_; }
  /// The states at the stops, one after the other, from y at `start`. Throws like the constructor.
  std::vector<double> solve(double start, const std::vector<double>& y,
                            const std::vector<double>& stops);
  /// The states from the case's start, to another relative tolerance; nothing where that run fails.
  std::vector<double> states(const std::vector<double>& stops, double relative) const;

  /// The case's start, the stops, and `count` times between that part the evaluations of the run to
  /// the end evenly, each between two events that are near and not at one; ascending.
  std::vector<double> checkpoints(const std::vector<double>& stops, std::size_t count) const;

 private:
  const Case& case_;
  const char *explicit_method_, *method_;
  Tolerance tolerance_;
  std::vector<double> evaluated_;  ///< the times of evaluations, ascending
  std::vector<double> happened_;   ///< those of events
};

}  // namespace odeum::judge
