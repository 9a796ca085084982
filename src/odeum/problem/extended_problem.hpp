// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "odeum/problem/concepts.hpp"

namespace odeum {

/// A case's problem in extended precision (64 bits of mantissa on x86), for orders that are reached
/// only at steps whose errors are below the rounding of double.
struct ExtendedProblem {
  using real = long double;
  static constexpr std::size_t dimension = dynamic;

  std::function<void(real t, const real* y, real* dydt)> f;
  std::vector<real> y0;
  std::function<bool(double t, real* y)> truth;  ///< as Truth::at
  double floor = 0;                              ///< absolute error of the truth

  std::size_t size() const { return y0.size(); }
  void rhs(real t, const real* y, real* dydt) const { f(t, y, dydt); }
};

/// The states at the stops, one after the other, of a run in equal steps from t0 to the last stop.
/// Each stop is a whole number of them.
using ExtendedRun = std::function<std::vector<long double>(
    const ExtendedProblem&, double t0, const std::vector<double>& stops, std::uint64_t steps)>;

/// Such a run with a stepper for ExtendedProblem.
template <class Stepper>
std::vector<long double> run_extended(const ExtendedProblem& problem, double t0,
                                      const std::vector<double>& stops, std::uint64_t steps) {
  using real = ExtendedProblem::real;
  const real h = (static_cast<real>(stops.back()) - t0) / static_cast<real>(steps);
  Stepper stepper(problem);
  std::vector<real> y = problem.y0, states;
  std::uint64_t i = 0;
  for (const double stop : stops) {
    for (; static_cast<real>(i) + 0.5L < (stop - static_cast<real>(t0)) / h; ++i)
      stepper.step(t0 + static_cast<real>(i) * h, h, y);
    states.insert(states.end(), y.begin(), y.end());
  }
  return states;
}

}  // namespace odeum
