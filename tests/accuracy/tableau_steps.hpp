// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "accuracy/wrong_solvers.hpp"

/// Explicit steps by a tableau, which faults are made of.
namespace odeum::tests {

struct Tableau {
  std::vector<std::vector<double>> a;  ///< row i has i entries
  std::vector<double> b, c;
  std::vector<double> embedded = {};  ///< weights of the pair's other method
};

Tableau euler();
Tableau midpoint();
Tableau ralston2();
Tableau kutta3();
Tableau three_eighths();
/// Six stages; the last of the embedded weights is that of the slope at the step's end.
Tableau dormand_prince5();

/// Advances y; returns the stages' slopes.
std::vector<Vector> take_step(const OdeView& problem, const Tableau& tableau, double t, double h,
                              Vector& y);
MakeStep with_tableau(const Tableau& tableau);

}  // namespace odeum::tests
