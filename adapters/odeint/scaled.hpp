// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/core/outcome.hpp"
#include "odeum/solvers/shared_contest.hpp"

/// odeint's explicit steppers take two numbers as tolerance. One for each component is a change of
/// units for them: z_i = y_i / threshold_i has the error |e_i| / threshold_i, which is held to
/// relative (1 + |z_i|), that is |e_i| to absolute_i + relative |y_i|.
namespace odeum::adapters::odeint {

/// The problem of `contest` in units of its thresholds; must outlive the run.
class ScaledProblem {
 public:
  static constexpr std::size_t dimension = dynamic;
  ScaledProblem(const Contest<SharedOde>& contest, const Request& request);
  Contest<SharedOde> contest() const;
  /// Puts the states of an outcome back into the problem's units.
  void unscale(Outcome& outcome) const;

  std::size_t size() const { return thresholds_.size(); }
  void rhs(double t, const double* z, double* dzdt) const;

 private:
  const Contest<SharedOde>& original_;
  std::vector<double> thresholds_;
  mutable std::vector<double> y_;
};

/// A run to a tolerance by component with a stepper that takes two numbers.
template <class Run>
Outcome run_scaled(const Contest<SharedOde>& contest, const Request& request, Run run) {
  const ScaledProblem scaled(contest, request);
  Request plain = request;
  plain.tolerance = request.tolerance.relative;
  Outcome outcome = run(scaled.contest(), plain);
  scaled.unscale(outcome);
  return outcome;
}

}  // namespace odeum::adapters::odeint
