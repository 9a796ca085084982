// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "odeum/kernel/method.hpp"
#include "odeum/proof/any_stepper.hpp"

namespace odeum::proof {

/// Fixed steps of running code, of a method or of a mutant of it; empty where the method does not
/// fit such problems.
struct Code {
  MakeStepper<FunctionProblem> on_problem;
  MakeStepper<FunctionMechanics<false>> on_separable;
  MakeStepper<FunctionMechanics<true>> on_second_order;

  /// Steps on a separable problem, as second-order system or, where the method takes any problem,
  /// as y' = [v, a].
  MakeStepper<FunctionMechanics<false>> on_mechanics() const {
    if (on_separable || !on_problem) return on_separable;
    return [make = on_problem](const FunctionMechanics<false>& problem) { return make(problem); };
  }
};

/// The contents of a method file with its types erased, so that the proofs are not compiled per
/// method.
struct MethodFacts : Code {
  MethodInfo info{};
  std::string needs;
  double rounding = 1;                            ///< of one step over that of the state
  std::optional<DynamicTableau<double>> tableau;  ///< of a Runge-Kutta method
  std::function<double(double re, double im)> amplification;  ///< |R(z)|; may be empty
  std::function<OscillatorMap(double)> oscillator_map;        ///< may be empty

  /// The recurrence of a linear multistep method on y' = z y at h = 1, from its coefficients: c_i
  /// such that y_{n+1} = sum_i c_i y_{n-i}. Its largest root corresponds to |R(z)| of a one-step
  /// method. May be empty.
  std::function<std::vector<std::complex<double>>(std::complex<double> z)> recurrence;

  std::string id() const { return std::string(info.id); }
};

/// Every own method, in the order of own_methods().
const std::vector<MethodFacts>& all_method_facts();

}  // namespace odeum::proof
