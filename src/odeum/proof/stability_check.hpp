// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>

#include "odeum/proof/facts.hpp"

namespace odeum::proof {

/// The running code against a stability function, at values of z drawn at random (the same every
/// time): half of them near zero, half over the left half-plane as far as the method is used there.
struct StabilityAgreement {
  int points = 0;              ///< 0: nothing to compare
  double difference = 0;       ///< the largest, relative to 1 + |R|
  std::complex<double> worst;  ///< z of the largest
};

/// One step at h = 1 of y' = z y from y = 1, as the code computes it; NaN where it fails.
std::complex<double> running_growth(const MakeStepper<FunctionProblem>& make,
                                    std::complex<double> z);

/// The code of a one-step method against R(z) of its tableau, or where it has none |R(z)| as its
/// file states it.
StabilityAgreement compare_stability(const MakeStepper<FunctionProblem>& make,
                                     const MethodFacts& theory);

/// The code of a linear multistep method against its recurrence: the state that a step leaves,
/// against the one that the recurrence makes of the last states that the code left.
StabilityAgreement compare_recurrence(const MakeStepper<FunctionProblem>& make,
                                      const MethodFacts& theory);

/// The modulus of the largest root of a recurrence.
double largest_root(const std::vector<std::complex<double>>& recurrence);

/// The code of a second-order method against the map of the oscillator that its file states, at
/// random omega h.
StabilityAgreement compare_oscillator_map(const MakeStepper<FunctionMechanics<false>>& make,
                                          const MethodFacts& theory);

/// The code against the interpreted tableau, two steps on a nonlinear problem in time: the largest
/// difference, of the error estimate too where `with_estimate` (a method may estimate in a way of
/// its own). Where it is rounding (and for implicit methods what Newton's tolerance leaves), what
/// is proven of the tableau holds of the code.
inline constexpr double tableau_rounding = 1e-12;
double compare_with_tableau(const MakeStepper<FunctionProblem>& make,
                            const DynamicTableau<double>& tableau, bool with_estimate);

}  // namespace odeum::proof
