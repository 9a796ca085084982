// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

/// Solvers with a deliberate fault, and six problems with closed solutions to run them on.
namespace odeum::tests {

using Vector = std::vector<double>;

/// One step from (t, y), the i-th of its run (from 0).
using Step = std::function<void(std::uint64_t i, double t, double h, Vector& y)>;
/// A fresh run's step on a problem, which outlives it.
using MakeStep = std::function<Step(const OdeView& problem)>;

struct WrongSolver {
  std::string name;
  double claimed = 0;
  MakeStep wrong, right;      ///< with the fault, and without
  bool second_order = false;  ///< for y = [q, q'] alone
};

/// RK4 with one coefficient off, with and without its row sum, and other faults of explicit steps.
std::vector<WrongSolver> wrong_coefficients();
std::vector<WrongSolver> wrong_explicit_steps();
/// Implicit Euler and implicit midpoint whose equations are not solved.
std::vector<WrongSolver> wrong_implicit_steps();

/// An Entrant that takes such steps at a fixed step; `c` must outlive it.
Entrant entrant_of(const std::string& name, double claimed, const MakeStep& make, const Case& c);

/// linear, nonlinear, non_autonomous, second_order, stiff, larger (20 unknowns).
const std::vector<Case>& campaign_cases();

}  // namespace odeum::tests
