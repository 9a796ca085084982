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
  static void each(auto& row, auto&& visit) {
    visit("solver", row.method), visit("test_problem", row.test_problem);
    visit("claimed_order", row.claimed_order), visit("measured_order", row.fit.order);
    visit("order_low", row.fit.low), visit("order_high", row.fit.high);
    visit("points", row.fit.points), visit("verdict", row.fit.verdict);
    visit("reason", row.fit.reason);
    visit("passes_as_next", record::PhraseColumn{row.passes_as_next, "no", "yes"});
  }
};

/// The error estimate of an embedded pair on a test problem: a line of proof_estimates.csv.
struct ProvenEstimate {
  std::string method;
  proof::EstimateQuality quality;

  static constexpr const char* file = "proof_estimates.csv";
  static constexpr int schema = 2;  ///< 2: `test_problem`, which was `ground`
  static void each(auto& row, auto&& visit) {
    visit("solver", row.method), visit("test_problem", row.quality.test_problem);
    visit("expected_exponent", row.quality.expected_exponent);
    visit("measured_exponent", row.quality.exponent);
    visit("ratio_to_true_error", row.quality.ratio), visit("margin", row.quality.margin);
    visit("verdict", record::ComputedColumn{row.quality.good() ? "good" : "bad"});
  }
};

/// A mutant and its result: a line of mutants.csv.
struct MutantRow {
  proof::Mutant mutant;

  static constexpr const char* file = "mutants.csv";
  static void each(auto& row, auto&& visit) {
    auto& m = row.mutant;
    visit("solver", m.method), visit("kind", m.kind), visit("change", m.change);
    visit("size", m.size), visit("counts", record::ComputedColumn{counts(m) ? "yes" : "no"});
    visit("verdict", record::ComputedColumn{m.caught()     ? "caught"
                                            : m.survived() ? "survived"
                                                           : "equivalent"});
    visit("caught_by", m.caught_by), visit("reason", m.equivalent);
  }
};

/// The proofs of an own method: a line of proofs.csv. Numbers are NaN, texts empty where a proof
/// does not apply.
struct ProofRow {
  std::string method, family;
  int order = 0, order_embedded = 0;  ///< claimed
  std::string needs;  ///< not empty: does not fit the test problems, tested on cases only

  /// By the rooted-tree conditions at run time: the order of the row, and the first condition that
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
  static void each(auto& row, auto&& visit) {
    visit("solver", row.method), visit("family", row.family), visit("claimed_order", row.order);
    visit("claimed_embedded", row.order_embedded), visit("conditions", row.conditions);
    visit("conditions_embedded", row.conditions_embedded);
    visit("failing_tree", row.failing_tree), visit("code_difference", row.code_difference);
    visit("stability", record::ComputedColumn{row.has_stability_class() ? describe(row.stability)
                                                                        : std::string()});
    visit("stability_angle", row.stability.angle);
    visit("at_infinity", row.stability.at_infinity);
    visit("stability_difference", row.stability_difference);
    visit("stability_points", row.stability_points);
    visit("symplectic_defect", row.symplectic_defect), visit("return_defect", row.return_defect);
    visit("energy_periods", row.energy_periods), visit("energy_first", row.energy_first);
    visit("energy_last", row.energy_last), visit("estimates_well", row.estimates_well);
    visit("mutants", row.mutants), visit("caught", row.caught), visit("equivalent", row.equivalent);
    visit("survived", record::ComputedColumn{row.survived()});
    visit("smallest_caught", row.smallest_caught), visit("needs", row.needs);
  }
};

struct ProofResult {
  std::vector<ProofRow> rows;
  std::vector<ProvenOrder> orders;
  std::vector<ProvenEstimate> estimates;
  std::vector<MutantRow> mutants;
  static auto lists(auto& result) {
    return std::tie(result.rows, result.orders, result.estimates, result.mutants);
  }

  /// Of one method.
  std::vector<ProvenOrder> orders_of(const std::string& method) const;
  std::vector<proof::EstimateQuality> estimates_of(const std::string& method) const;
};

/// Proves every own method and mutates it; `quick`: with a hundredth of the periods for the energy.
/// Throws Interrupted.
ProofResult prove(const Options& options, const Runner& runner = Runner());

}  // namespace odeum::study
