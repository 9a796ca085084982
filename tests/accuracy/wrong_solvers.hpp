// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

/// Solvers with a deliberate fault, and eight problems with closed solutions to run them on.
namespace odeum::tests {

using Vector = std::vector<double>;

/// One step from (t, y), the i-th of its run (from 0).
using Step = std::function<void(std::uint64_t i, double t, double h, Vector& y)>;
/// A fresh run's step on a problem, which outlives it.
using MakeStep = std::function<Step(const OdeView& problem)>;

/// A run of one's own, for solvers to a tolerance.
using Run = std::function<Outcome(const Case& c, const Request& request)>;

struct WrongSolver {
  std::string name;
  double claimed = 0;
  MakeStep wrong, right;               ///< with the fault, and without; at fixed steps
  bool second_order = false;           ///< for y = [q, q'] alone
  Run wrong_run = {}, right_run = {};  ///< instead, to a tolerance

  bool adaptive() const { return static_cast<bool>(wrong_run); }
  bool fits(const Case& c) const {
    return !second_order || std::ranges::count(c.tags, "second_order") > 0;
  }
};

/// RK4 with one coefficient off, with and without its row sum, and other faults of explicit steps.
std::vector<WrongSolver> wrong_coefficients();
std::vector<WrongSolver> wrong_explicit_steps();
/// Implicit Euler and implicit midpoint whose equations are not solved.
std::vector<WrongSolver> wrong_implicit_steps();
/// Methods of orders 2 to 5 with changed tableaus, lower orders mixed in, and other faults.
std::vector<WrongSolver> wrong_tableaus();
/// Dormand and Prince's pair to a tolerance.
std::vector<WrongSolver> wrong_adaptive();
/// Solvers without a fault, of which `wrong` is right, too.
std::vector<WrongSolver> right_tableaus();
std::vector<WrongSolver> right_adaptive();

/// An Entrant of it with the fault, or without; `c` must outlive it.
Entrant entrant_of(const WrongSolver& solver, bool with_fault, const Case& c);

/// linear, nonlinear, non_autonomous, second_order, stiff, larger (20 unknowns), kepler,
/// relaxation.
const std::vector<Case>& campaign_cases();

}  // namespace odeum::tests
