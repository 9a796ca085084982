// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <limits>
#include <string>
#include <vector>

#include "odeum/judge/order_fit.hpp"
#include "odeum/proof/embedded_check.hpp"
#include "odeum/proof/mutant.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/tableau/character.hpp"

namespace odeum::study {

/// An order measured on a ground of the proofs.
struct ProvenOrder {
  std::string ground;
  judge::OrderFit fit;
  bool passes_as_next = false;  ///< would be confirmed as order p + 1
};

/// All that is proven of an own method: a line of proofs.csv. Numbers are NaN, texts empty where a
/// proof does not apply.
struct ProofRow {
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::string method, family;
  int order = 0, order_embedded = 0;  ///< claimed
  std::string needs;  ///< not empty: does not fit the grounds, proven by the cases alone

  /// By the rooted-tree conditions at run time: the order of the row, and the first condition that
  /// fails beyond it. -1: no tableau.
  int conditions = -1, conditions_embedded = -1;
  std::string failing_tree;
  double code_difference = nan;  ///< code against interpreted tableau

  std::vector<ProvenOrder> orders;

  double stability_difference = nan;  ///< code against stability function, relative
  int stability_points = 0;
  bool has_stability_class = false;
  StabilityClass stability;

  double symplectic_defect = nan, return_defect = nan;
  double energy_periods = 0, energy_first = nan, energy_last = nan;  ///< of symplectic methods

  std::vector<proof::EstimateQuality> estimates;

  int mutants = 0, caught = 0, equivalent = 0;  ///< those that count
  double smallest_caught = nan;  ///< size of change down to which every coefficient is caught

  bool symplectic() const;
  bool reversible() const;
  int survived() const { return mutants - caught - equivalent; }
  /// Whether the estimate is within its band on every ground.
  bool estimates_well() const;
};

struct ProofResult {
  std::vector<ProofRow> rows;
  std::vector<proof::Mutant> mutants;

  int made() const, caught() const, equivalent() const;  ///< of those that count
};

struct ProofOptions {
  std::vector<std::string> solvers = {};  ///< globs on odeum/method; empty: all
  bool quick = false;                     ///< a hundredth of the periods for the energy
  unsigned jobs = 1;
};

/// Proves every own method and mutates it. Results do not depend on `jobs`. Throws Interrupted.
ProofResult prove(const ProofOptions& options);

/// Writes proofs.csv (a row a method), proof_orders.csv (a row a method and ground),
/// proof_estimates.csv (a row an embedded pair and ground) and mutants.csv (a row a mutant).
void write_csv(const ProofResult& result, const record::OutputFolder& folder);

}  // namespace odeum::study
