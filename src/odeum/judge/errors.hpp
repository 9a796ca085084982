// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::judge {

/// The error of a solve at one stop.
struct StopError {
  double time = 0;
  double error_max = 0;     ///< see error_of
  double error_rms = 0;     ///< root mean square over the measured components
  double energy = 0;        ///< NaN where the case has none
  double energy_error = 0;  ///< |E - E_truth| / largest |E_truth| over the stops
};

/// The error of a run by those at its stops: the largest, the root mean square over all of them,
/// and the largest of the energy. Stops at which the truth is not known have no part in the
/// largest. Its time is the last stop's. `errors` is not empty.
StopError over_stops(const std::vector<StopError>& errors);

/// The components whose error is measured: those that the case names, or all.
std::vector<std::size_t> measured_components(const Case& c);

/// An error, as every study, command and file of Odeum has it: |y_i - exact_i| over the unit of the
/// component i (ErrorUnits), which is 1, the scale of the component, or, of one that falls and
/// rises again, its exact value at that time. Of a state it is the largest of the measured
/// components, and of a scene the largest distance of a particle from its exact place, in m. `y`
/// and `exact` have as many numbers as c.y0.
double error_of(const Case& c, const double* y, const double* exact);
/// The component that has this error, or the first of several.
std::size_t worst_component(const Case& c, const double* y, const double* exact);
/// The units of errors in words, as `absolute`.
std::string unit_text(const Case& c);
/// The error of the state at a time; NaN where the truth is not known, infinite past its end.
double error_at(const Case& c, double time, const double* state);

/// Compares solves of one case with its truth, which is evaluated once. The case has to outlive it;
/// several threads may use it at once.
class Judge {
 public:
  /// `stops`: as given to the solver. Stops at which the truth is not known give NaN errors; those
  /// past the end of the solution (its truth is infinite) infinite ones, whatever the state.
  Judge(const Case& c, std::vector<double> stops);

  /// One entry a stop; the outcome must have reached all of them.
  std::vector<StopError> errors(const Outcome& outcome) const;

  /// Root mean square of the components measured, in their units, where that is largest: at the
  /// start, at a stop, or by the largest of each along the solution.
  double scale() const { return scale_; }
  /// Whether the solution ends before the last stop, so that no state there is right.
  bool solution_ends() const { return ends_; }
  /// How many components are measured.
  std::size_t components() const { return measured_.size(); }

 private:
  const Case& case_;
  std::vector<double> stops_;
  std::vector<std::vector<double>> truth_;  ///< by stop; empty where nothing is known
  std::vector<std::size_t> measured_;
  double scale_ = 0;
  double energy_scale_ = 0;
  bool ends_ = false;
};

}  // namespace odeum::judge
