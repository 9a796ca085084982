// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::judge {

/// How the powers R^n of a matrix behave.
struct Powers {
  std::vector<std::complex<double>> eigenvalues;
  double radius = 0;   ///< the largest modulus of an eigenvalue
  int polynomial = 0;  ///< radius 1, to rounding: they grow as n to that power
};
/// The powers of a dense n x n matrix, by rows.
Powers powers_of(const std::vector<double>& matrix, std::size_t n);

/// One step of a solver at a fixed step on u' = A u + b: u becomes R u + r.
struct StepMatrix {
  std::vector<double> matrix;  ///< R, by rows
  std::vector<double> vector;  ///< r, of the step from t0
  Powers powers;
  /// The difference of eight steps from R^8, over the size of the state: rounding, unless the
  /// solver keeps more than the last state, or solves its stages inexactly.
  double rest = 0;
};

/// Measured on the running solver, by steps from 0 and from each unit vector. The case has to be
/// linear and of few unknowns. h > 0 is in the case's unit of time. Throws std::runtime_error where
/// the solver does not fit or a run fails.
StepMatrix measure_step_matrix(const Case& c, const Solver& solver, double h);

/// A spectral radius for people; near 1 as `1 + 2.5e-09`.
std::string text_of_radius(double radius);
/// What follows for a run of `steps` steps: `diverges as 1.005^n, ...`.
std::string consequence(const Powers& powers, double steps);

}  // namespace odeum::judge
