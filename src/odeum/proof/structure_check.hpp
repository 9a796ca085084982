// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/proof/any_stepper.hpp"

namespace odeum::proof {

/// The step of the structure checks: a fifteenth of a period, where errors are large.
inline constexpr double structure_step = 0.4;

using MechanicsMaker = MakeStepper<FunctionMechanics<false>>;

/// The largest entry of J^T Omega J - Omega, where J is the Jacobian of one step of size h on the
/// potential of Henon and Heiles (two degrees of freedom, nonlinear and coupled), the worst of
/// three states. J comes from differences of order 8 over a spacing of 0.05, with a truncation
/// error of 1e-14; rounding and the tolerance of implicit solvers contribute 1e-11.
double symplectic_defect(const MechanicsMaker& make, double h);
inline constexpr double symplectic_rounding = 2e-11;

/// |y'' - y| where y'' is the result of a step of h and one of -h from y; the worst of three
/// states, on the same potential and on a driven pendulum. Rounding and implicit solvers contribute
/// 1e-12.
double return_defect(const MechanicsMaker& make, double h);
inline constexpr double return_rounding = 2e-12;

/// The energy on the same potential over many periods (of the linear part, 2 pi) of
/// `steps_per_period` steps: the largest error, relative to the energy, in the first tenth and in
/// the last tenth of the run. A bounded energy error does not grow between them.
struct EnergyWatch {
  double first = 0, last = 0;
  bool bounded() const { return last <= 1.5 * first + 1e-10; }
};
EnergyWatch watch_energy(const MechanicsMaker& make, int steps_per_period, double periods);

}  // namespace odeum::proof
