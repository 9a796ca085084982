// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/proof/embedded_check.hpp"
#include "odeum/proof/facts.hpp"
#include "odeum/proof/order_check.hpp"

namespace odeum::proof {

/// The code of a method, or of a mutant of it, on the problems that it fits.
struct Code {
  MakeStepper<FunctionProblem> on_problem;
  MakeStepper<FunctionMechanics<false>> on_separable;
  MakeStepper<FunctionMechanics<true>> on_second_order;

  bool empty() const { return !on_problem && !on_separable; }
};

inline Code code_of(const MethodFacts& method) {
  return {method.on_problem, method.on_separable, method.on_second_order};
}

/// Whether a mutant's order passes for that of the sound method: the same verdict and, where it is
/// not `confirmed` (a method may be of higher order on a problem that asks for few conditions), the
/// same order to 0.15.
bool same_order(const judge::OrderFit& fit, const judge::OrderFit& sound);

/// Where running code must agree with its stability function, relative: some hundred operations of
/// up to seventeen stages, whose terms may exceed the result a hundred times. An iteration that
/// stops at a tolerance of its own is held to that.
double stability_tolerance(const MethodFacts& method);

/// How far a step strays from y = t on y' = lambda (y - t) + 1 (q = t on q'' = -w^2 (q - t)), of
/// which y = t is the solution: one that takes every quantity at its own time stays on it, whatever
/// its order, as follows from invariance under y -> y - t. 0 but for what `stability_tolerance`
/// allows too.
double moving_frame_defect(const Code& code);

/// Puts code through what the report shows of a method: order on every ground, agreement with the
/// stability function, with the map of the oscillator and with the tableau, the moving frame,
/// symplecticity, return and the error estimate. A mutant is held to those that the sound method
/// passes.
class CodeChecks {
 public:
  explicit CodeChecks(const MethodFacts& sound);
  /// The first check that the code fails ("order on nonlinear: lower"), or an empty text.
  std::string first_failure(const Code& code) const;

 private:
  bool agrees_with_stability_function(const Code& code) const;
  bool agrees_with_oscillator_map(const Code& code) const;
  bool agrees_with_tableau(const Code& code) const;
  std::vector<EstimateQuality> estimates(const Code& code) const;

  const MethodFacts& sound_;
  std::vector<judge::OrderFit> orders_;  ///< of the sound method, ground by ground
  std::vector<EstimateQuality> estimates_;
  bool stability_ = false, map_ = false, tableau_ = false, frame_ = false, symplectic_ = false,
       returns_ = false;
};

/// The largest difference between what two codes compute on the non-autonomous grounds in eight
/// steps; infinite where one of them fails and the other does not.
double difference_between(const Code& one, const Code& other);

}  // namespace odeum::proof
