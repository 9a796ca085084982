// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace odeum {

/// What the states of the exact solution fulfil: each value is zero. Thread-safe.
struct Constraints {
  std::vector<std::string> names;  ///< as people know them: those that are given, then hidden ones
  std::size_t given = 0;           ///< the others follow from derivatives of these
  /// Why states jump with a condition on states, in a sentence; empty: they do not.
  std::string jumps;
  /// Fills `values`, one for each name.
  std::function<void(double t, const double* y, double* values)> values;
  /// Fills `slopes` with their derivatives by y, dense, by rows.
  std::function<void(double t, const double* y, double* slopes)> slopes;
};

/// R(t, y, y') = 0, where not every rate can be solved for: constraints among the
/// residuals, or rates that cannot be isolated. Its ordinary problem, of the derivatives of the
/// constraints, has the same solution and gives the rates of a consistent start. Thread-safe.
struct ImplicitForm {
  std::size_t dimension = 0;
  /// Fills r, of `dimension`.
  std::function<void(double t, const double* y, const double* rates, double* r)> residual;
  /// Fills j with dR/dy + alpha dR/dy', dense, by rows.
  std::function<void(double t, const double* y, const double* rates, double alpha, double* j)>
      matrix;
  Constraints constraints;
  int index = 1;  ///< how often a constraint has to be differentiated for rates of all states
  /// The same for each state, of which steps know those of a higher index less; empty: 1.
  std::vector<int> indices;
};

}  // namespace odeum
