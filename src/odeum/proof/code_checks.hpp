// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/proof/embedded_check.hpp"
#include "odeum/proof/facts.hpp"
#include "odeum/proof/order_check.hpp"

namespace odeum::proof {

/// Whether a mutant has the order of the unaltered method: the same verdict and, where it is not
/// `confirmed` (on a problem with few order conditions a method may have a higher order), the same
/// order to 0.15.
bool same_order(const judge::OrderFit& fit, const judge::OrderFit& sound);

/// Relative tolerance of running code against its stability function: rounding of some hundred
/// operations in up to seventeen stages, whose terms may exceed the result a hundred times. For an
/// iteration its own tolerance.
double stability_tolerance(const MethodFacts& method);

/// The deviation of a step from y = t, the solution of y' = lambda (y - t) + 1 (q = t on q'' = -w^2
/// (q - t)). A method of any order that evaluates every quantity at its own time is exact on it, by
/// invariance under y -> y - t: 0 up to `stability_tolerance`.
double moving_frame_defect(const Code& code);

/// The checks of the code of a method: order on every test problem, agreement with the stability
/// function, with the map of the oscillator and with the tableau, moving frame, symplecticity,
/// reversibility and error estimate. For a mutant only those that the unaltered method passes.
class CodeChecks {
 public:
  explicit CodeChecks(const MethodFacts& sound);
  /// The first check that the code fails ("order on nonlinear: lower"), or an empty text.
  std::string first_failure(const Code& code) const;

 private:
  struct Check {
    const char* name;
    std::function<bool(const Code&)> passes;
  };

  const MethodFacts& sound_;
  std::vector<judge::OrderFit> orders_;  ///< of the unaltered method, by test problem
  std::vector<EstimateQuality> estimates_;
  std::vector<Check> checks_;  ///< those that it passes
};

/// The largest difference between the results of two codes on the non-autonomous test problems in
/// eight steps; infinite where only one of them fails.
double difference_between(const Code& one, const Code& other);

}  // namespace odeum::proof
