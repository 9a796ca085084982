// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <optional>
#include <string>
#include <vector>

#include "odeum/kernel/method.hpp"
#include "odeum/proof/any_stepper.hpp"

namespace odeum::proof {

/// The contents of a method file with its types erased, so that the proofs are not compiled per
/// method.
struct MethodFacts {
  MethodInfo info{};
  std::string needs;
  std::optional<DynamicTableau<double>> tableau;              ///< of a Runge-Kutta method
  std::function<double(double re, double im)> amplification;  ///< |R(z)|; may be empty
  std::function<OscillatorMap(double)> oscillator_map;        ///< may be empty

  /// Of a linear multistep method on y' = z y at h = 1, from its coefficients: c_i such that
  /// y_{n+1} = sum_i c_i y_{n-i}. Its largest root corresponds to |R(z)| of a one-step method. May
  /// be empty.
  std::function<std::vector<std::complex<double>>(std::complex<double> z)> recurrence;

  /// Fixed steps of the running code; empty where the method does not fit such problems.
  MakeStepper<FunctionProblem> on_problem;
  MakeStepper<FunctionMechanics<false>> on_separable;
  MakeStepper<FunctionMechanics<true>> on_second_order;

  std::string id() const { return std::string(info.id); }
  bool fits_mechanics_only() const { return !on_problem && on_separable; }
  /// Steps on a separable problem, as second-order system or, where the method takes any problem,
  /// as y' = [v, a].
  MakeStepper<FunctionMechanics<false>> on_mechanics() const;
};

/// Every own method, in the order of own_methods().
const std::vector<MethodFacts>& all_method_facts();

}  // namespace odeum::proof
