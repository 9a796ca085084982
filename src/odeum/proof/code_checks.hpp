// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/proof/facts.hpp"
#include "odeum/proof/order_check.hpp"

namespace odeum::proof {

/// The code of a method, or of a mutant of it, on the problems that it fits.
struct Code {
  MakeStepper<FunctionProblem> on_problem;
  MakeStepper<FunctionMechanics<false>> on_separable;
  MakeStepper<FunctionMechanics<true>> on_second_order;
};

inline Code code_of(const MethodFacts& method) {
  return {method.on_problem, method.on_separable, method.on_second_order};
}

/// Where running code must agree with its stability function, relative: some hundred operations of
/// up to nine stages, whose terms may exceed the result a hundred times.
inline constexpr double stability_rounding = 1e-12;

/// Puts code through what the report shows of a method: order on every ground, agreement with the
/// stability function, with the map of the oscillator and with the tableau, symplecticity and
/// return where the method has them. `original` is the sound method. Returns the first check that
/// the code fails ("order on nonlinear: 1.02 lower"), or an empty text.
std::string first_failure(const Code& code, const MethodFacts& original);

/// The largest difference between what two codes compute on the non-autonomous grounds in eight
/// steps; infinite where one of them fails and the other does not.
double difference_between(const Code& one, const Code& other);

}  // namespace odeum::proof
