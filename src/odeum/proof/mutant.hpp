// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/proof/facts.hpp"

/// Mutation: a method is altered in one place, which the checks must detect. A mutant that they
/// miss is either equivalent (no result of the method changes) or shows a gap in the proofs.
namespace odeum::proof {

/// A mutant and the result of its checks.
struct Mutant {
  std::string method;
  /// coefficient, sign, stage, node, time, evaluation, derivative, update, start
  std::string kind;
  std::string change;          ///< "a[3][2] by 1e-06", "the velocity first"
  double size = 0;             ///< relative, of a changed coefficient; 0 otherwise
  std::string caught_by = {};  ///< the first check that detected it; empty: none
  /// Why no check can detect it; empty where it was caught, or survived.
  std::string equivalent = {};
  bool caught() const { return !caught_by.empty(); }
  bool survived() const { return !caught() && equivalent.empty(); }
};

/// Relative changes of a coefficient. The smallest corresponds to coefficients of twelve digits;
/// rounding of the conditions may hide it, so that it is reported but does not count (see
/// `counts`).
inline constexpr double mutation_sizes[] = {1e-3, 1e-6, 1e-9, 1e-12};
inline constexpr double smallest_size_that_counts = 1e-9;
inline bool counts(const Mutant& mutant) {
  return mutant.size == 0 || mutant.size >= smallest_size_that_counts;
}

/// The checks of a tableau mutant.
enum class Checks {
  quickest_first,  ///< conditions, structure, stability, then runs of the remaining ones
  running_only     ///< the order fit alone, as `odeum converge` does it
};

/// Every mutant of a tableau: every nonzero coefficient by each size and with its sign swapped,
/// every stage dropped, every node shifted by a hundredth and set to 0 (t where t + c h is due).
/// Empty for methods without a tableau. `running_only` leaves out changes below 1e-3, which a fit
/// of errors does not resolve.
std::vector<Mutant> mutate_tableau(const MethodFacts& method, Checks checks);

/// Mutants of the running code, by altering the problem's answers: time constant within a step or
/// late, one evaluation of the step scaled, negated or replaced by the one before, a wrong Jacobian
/// or df/dt, a first step by explicit Euler. Works for every method.
std::vector<Mutant> mutate_answers(const MethodFacts& method);

/// Mutants written by hand of methods without a tableau: Verlet with its update in another order,
/// leapfrog without the half kick, and so on.
std::vector<Mutant> mutate_updates(const std::vector<MethodFacts>& methods);

}  // namespace odeum::proof
