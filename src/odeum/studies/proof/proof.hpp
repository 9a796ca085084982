// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/judge/order_fit.hpp"
#include "odeum/proof/embedded_check.hpp"
#include "odeum/proof/mutant.hpp"
#include "odeum/studies/study.hpp"
#include "odeum/tableau/character.hpp"

namespace odeum::study {

/// An order measured on a test problem of the proofs: a line of proof_orders.csv.
struct ProvenOrder {
  std::string method, test_problem;
  int claimed_order = 0;
  judge::OrderFit fit;
  bool passes_as_next = false;  ///< would be confirmed as order p + 1

  static constexpr const char* file = "proof_orders.csv";
  static constexpr int schema = 2;  ///< 2: `test_problem`, which was `ground`
  ODEUM_COLUMNS(column("solver", method), test_problem, claimed_order,
                column("measured_order", fit.order), column("order_low", fit.low),
                column("order_high", fit.high), fit.points, fit.verdict, fit.reason,
                column("passes_as_next", PhraseColumn{passes_as_next, "no", "yes"}))
};

/// The error estimate of an embedded pair on a test problem: a line of proof_estimates.csv.
struct ProvenEstimate {
  std::string method;
  proof::EstimateQuality quality;

  static constexpr const char* file = "proof_estimates.csv";
  static constexpr int schema = 2;  ///< 2: `test_problem`, which was `ground`
  ODEUM_COLUMNS(column("solver", method), quality.test_problem, quality.expected_exponent,
                column("measured_exponent", quality.exponent),
                column("ratio_to_true_error", quality.ratio), quality.margin,
                column("verdict", ComputedColumn{quality.good() ? "good" : "bad"}))
};

/// A mutant and its result: a line of mutants.csv.
struct MutantRow {
  proof::Mutant mutant;

  static constexpr const char* file = "mutants.csv";
  ODEUM_COLUMNS(column("solver", mutant.method), mutant.kind, mutant.change, mutant.size,
                column("counts", ComputedColumn{counts(mutant) ? "yes" : "no"}),
                column("verdict", ComputedColumn{mutant.caught()     ? "caught"
                                                 : mutant.survived() ? "survived"
                                                                     : "equivalent"}),
                mutant.caught_by, column("reason", mutant.equivalent))
};

/// The proofs of an own method: a line of proofs.csv. Numbers are NaN, texts empty where a proof
/// does not apply.
struct ProofRow {
  std::string method, family;
  int order = 0, order_embedded = 0;  ///< claimed
  std::string needs;  ///< not empty: does not fit the test problems, tested on cases only

  /// The order of the row by the rooted-tree conditions at run time, and the first condition that
  /// fails beyond it.
  std::optional<int> conditions, conditions_embedded;
  std::string failing_tree;
  double code_difference = nan;  ///< code against interpreted tableau

  double stability_difference = nan;  ///< code against stability function, relative
  int stability_points = 0;
  StabilityClass stability{nan, nan};

  double symplectic_defect = nan, return_defect = nan;
  double energy_periods = 0;  ///< of symplectic methods
  double energy_first = nan, energy_last = nan;

  /// Whether the estimate is within its band on every test problem: yes, no, or empty without one.
  std::string estimates_well;

  int mutants = 0, caught = 0, equivalent = 0;  ///< those that count
  double smallest_caught = nan;  ///< size of change down to which every coefficient is caught

  bool symplectic() const;
  bool reversible() const;
  bool has_stability_class() const { return !std::isnan(stability.angle); }
  int survived() const { return mutants - caught - equivalent; }

  static constexpr const char* file = "proofs.csv";
  static constexpr const char* shown =
      "solver claimed_order conditions stability_difference:.0e stability caught survived mutants";
  ODEUM_COLUMNS(column("solver", method), family, column("claimed_order", order),
                column("claimed_embedded", order_embedded), conditions, conditions_embedded,
                failing_tree, code_difference,
                column("stability",
                       ComputedColumn{has_stability_class() ? describe(stability) : std::string()}),
                column("stability_angle", stability.angle), stability.at_infinity,
                stability_difference, stability_points, symplectic_defect, return_defect,
                energy_periods, energy_first, energy_last, estimates_well, mutants, caught,
                equivalent, column("survived", ComputedColumn{survived()}), smallest_caught, needs)
};

struct ProofResult {
  std::vector<ProofRow> rows;
  std::vector<ProvenOrder> orders;
  std::vector<ProvenEstimate> estimates;
  std::vector<MutantRow> mutants;
  static auto lists(auto& result) {
    return std::tie(result.rows, result.orders, result.estimates, result.mutants);
  }
};

/// Proves every own method and mutates it; `quick`: with a hundredth of the periods for the energy.
/// Throws Interrupted.
ProofResult prove(const Options& options, const Runner& runner = Runner());

}  // namespace odeum::study
