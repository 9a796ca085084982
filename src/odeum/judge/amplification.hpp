// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::judge {

/// What a method of order 5 or 8 misses a case's truth by.
struct Control {
  double tolerance = 0;
  std::vector<double> errors;  ///< by stop, the largest of a component
};

/// How a case carries errors made along its solution to its stops.
struct Amplification {
  /// The effect at each stop of an error of one tolerance, relative and absolute, in all components
  /// at one time, on a measured component; in the case's units, for that component and that time
  /// where it is largest. With Phi the fundamental matrix: sqrt(n) |row of Phi(stop, t)
  /// diag(threshold_i + |y_i(t)|)|, in the Euclidean norm, n components. A solver's local errors
  /// have this effect if its root mean square of scaled errors, or the largest of them, is the
  /// relative tolerance.
  std::vector<double> at_stops;
  /// The errors of the method by which this is measured, at tolerances from coarse to fine: what
  /// the case leaves possible where at_stops, which is linear in the errors, comes to the size of
  /// the solution.
  std::vector<Control> controls;
  std::size_t directions = 0;  ///< random directions instead of all columns of Phi; 0: all of them
  std::string unknown;         ///< why it could not be measured, in a sentence; empty: it was
};

/// Measures it over the intervals between the stops and 48 other times that part the evaluations of
/// a run evenly; Phi is the product over intervals. Each is integrated, or, of stiff problems,
/// above 16 components and where a run beside the solution denies that, taken from differences of
/// runs to a tolerance of 1e-10, each component moved by 1e-6 (smallest threshold_i + |y_i|):
/// errors of those multiply where each interval shears and none stretches, as along an orbit. Above
/// 64 components: 4 random directions at the start and at 4 other times, runs to 1e-7, moved by
/// 1e-4. Costs some (n + 1) solves, or a dozen. Unknown where the runs fail or do not end at the
/// truth. The thresholds are those of the tolerance (see core/tolerance.hpp) that a run is judged
/// by, or the case's; runs and perturbations are by the smaller of both. `stops` ascend after the
/// start of the case; `asked` is relative and absolute, the latter in the units of the components.
/// Throws nothing for a run that fails. Several threads may measure at once.
Amplification measure_amplification(const Case& c, const std::vector<double>& stops,
                                    const Tolerance& asked);
Amplification measure_amplification(const Case& c, const std::vector<double>& stops);

/// The amplification of perturbations by a case: the root mean square error over stops and measured
/// components due to a random relative perturbation of all components in each of N steps, divided
/// by the perturbation and sqrt(N); in the case's units. Rounding in N steps then comes to 2^-53
/// sqrt(N) times it. Measured by runs of the classical Runge-Kutta method with and without such
/// perturbations, of 1e-8. Where that method does not solve the case to 1 % (stiff problems, which
/// damp perturbations): the size of the measured components.
double perturbation_gain(const Case& c);

}  // namespace odeum::judge
