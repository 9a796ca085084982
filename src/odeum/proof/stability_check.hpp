// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>

#include "odeum/proof/facts.hpp"

namespace odeum::proof {

/// The running code against a stability function, at pseudo-random values of z (always the same):
/// half of them near zero, half over the part of the left half-plane where the method is used.
struct StabilityAgreement {
  int points = 0;         ///< 0: nothing to compare
  double difference = 0;  ///< the largest, relative to 1 + |R|
};

/// The code of a one-step method against R(z) of its tableau, or without one |R(z)| as stated in
/// its file.
StabilityAgreement compare_stability(const MakeStepper<FunctionProblem>& make,
                                     const MethodFacts& theory);

/// The code of a linear multistep method against its recurrence: the state after a step, against
/// the recurrence applied to the last states of the code.
StabilityAgreement compare_recurrence(const MakeStepper<FunctionProblem>& make,
                                      const MethodFacts& theory);

/// The modulus of the largest root of a recurrence.
double largest_root(const std::vector<std::complex<double>>& recurrence);

/// The code of a second-order method against the map of the oscillator in its file, at random omega
/// h.
StabilityAgreement compare_oscillator_map(const MakeStepper<FunctionMechanics<false>>& make,
                                          const MethodFacts& theory);

/// The code against the interpreted tableau, two steps on a nonlinear non-autonomous problem: the
/// largest difference, of the error estimate too where `with_estimate` (a method may have an
/// estimate of its own). Where it is rounding (for implicit methods the remaining error of Newton's
/// iteration), the proofs of the tableau hold for the code.
inline constexpr double tableau_rounding = 1e-12;
double compare_with_tableau(const MakeStepper<FunctionProblem>& make,
                            const DynamicTableau<double>& tableau, bool with_estimate);

}  // namespace odeum::proof
