// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/proof/proof.hpp"

#include <algorithm>

#include "odeum/core/glob.hpp"
#include "odeum/proof/code_checks.hpp"
#include "odeum/proof/stability_check.hpp"
#include "odeum/proof/structure_check.hpp"
#include "odeum/tableau/row_order.hpp"

namespace odeum::study {
namespace {

using proof::MethodFacts;
using proof::Mutant;

void prove_conditions(const MethodFacts& method, ProofRow& row) {
  if (!method.tableau) return;
  const DynamicTableau<double>& t = *method.tableau;
  const RowOrder<double> found = order_of_row(t, t.b, double_rounding);
  row.conditions = found.order;
  if (found.fails) row.failing_tree = bracket_notation(found.tree);
  if (t.embedded()) row.conditions_embedded = order_of_row(t, t.b_hat, double_rounding).order;
  if (method.on_problem)
    row.code_difference = proof::compare_with_tableau(method.on_problem, t,
                                                      t.order_hat == method.info.order_embedded);
}

template <class P>
void measure(const proof::MakeStepper<P>& make, const MethodFacts& method, const char* prefix,
             const std::vector<proof::TestProblem<P>>& where, std::vector<ProvenOrder>& orders) {
  const int order = method.info.order;
  if (!make || order == 0) return;
  for (const proof::TestProblem<P>& test : where)
    orders.push_back({method.id(), prefix + test.id, order,
                      proof::measure_order(make, order, test, method.rounding),
                      proof::measure_order(make, order + 1, test, method.rounding).verdict ==
                          judge::Verdict::confirmed});
}

void prove_stability(const MethodFacts& method, ProofRow& row) {
  proof::StabilityAgreement found;
  if (method.on_problem && method.info.one_step)
    found = proof::compare_stability(method.on_problem, method);
  else if (method.recurrence)
    found = proof::compare_recurrence(method.on_problem, method);
  else if (method.on_separable)
    found = proof::compare_oscillator_map(method.on_separable, method);
  row.stability_points = found.points;
  if (found.points > 0) row.stability_difference = found.difference;
  if (method.tableau)
    row.stability = stability_class(*method.tableau);
  else if (method.recurrence)
    row.stability = stability_class(
        [&](std::complex<double> z) { return proof::largest_root(method.recurrence(z)); });
  else if (method.amplification)
    row.stability = stability_class(
        [&](std::complex<double> z) { return method.amplification(z.real(), z.imag()); });
}

void prove_structure(const MethodFacts& method, bool quick, ProofRow& row) {
  const proof::MechanicsMaker mechanics = method.on_mechanics();
  if (!mechanics) return;
  row.symplectic_defect = proof::symplectic_defect(mechanics, proof::structure_step);
  row.return_defect = proof::return_defect(mechanics, proof::structure_step);
  if (!row.symplectic()) return;
  // Implicit steps cost a hundred explicit ones: the test suite runs them as long, the report does
  // not.
  row.energy_periods = (method.on_separable ? 1e5 : 1e3) / (quick ? 100 : 1);
  const proof::EnergyWatch watch = proof::watch_energy(mechanics, 16, row.energy_periods);
  row.energy_first = watch.first;
  row.energy_last = watch.last;
}

std::vector<proof::EstimateQuality> prove_estimate(const MethodFacts& method) {
  const MethodInfo& info = method.info;
  if (info.order_embedded == 0) return {};
  if (method.on_problem)
    return proof::estimate_quality(method.on_problem, info.order, info.order_embedded);
  if (method.on_separable)
    return proof::estimate_quality(method.on_separable, info.order, info.order_embedded);
  return {};
}

void count_mutants(const std::vector<Mutant>& mutants, ProofRow& row) {
  bool all = true;
  for (const double size : proof::mutation_sizes) {
    for (const Mutant& mutant : mutants)
      if (mutant.size == size && mutant.survived()) all = false;
    const bool any = std::ranges::any_of(mutants, [&](const Mutant& m) { return m.size == size; });
    if (all && any) row.smallest_caught = size;
  }
  for (const Mutant& mutant : mutants) {
    if (!counts(mutant)) continue;
    ++row.mutants;
    row.caught += mutant.caught();
    row.equivalent += !mutant.equivalent.empty();
  }
}

ProofResult prove_method(const MethodFacts& method, bool quick) {
  ProofResult result;
  ProofRow& row = result.rows.emplace_back();
  row.method = method.id();
  row.family = method.info.family;
  row.order = method.info.order;
  row.order_embedded = method.info.order_embedded;
  if (!method.on_problem && !method.on_separable)
    row.needs = method.needs.empty() ? "a run of its own steps" : method.needs;
  prove_conditions(method, row);
  measure(method.on_problem, method, "", proof::test_problems(), result.orders);
  measure(method.on_separable, method, "separable_", proof::separable_test_problems(),
          result.orders);
  measure(method.on_second_order, method, "damped_", proof::second_order_test_problems(),
          result.orders);
  prove_stability(method, row);
  prove_structure(method, quick, row);
  for (const proof::EstimateQuality& quality : prove_estimate(method)) {
    result.estimates.push_back({row.method, quality});
    row.estimates_well = row.estimates_well != "no" && quality.good() ? "yes" : "no";
  }
  std::vector<Mutant> mutants;
  for (const auto& more : {proof::mutate_tableau(method, proof::Checks::quickest_first),
                           proof::mutate_answers(method), proof::mutate_updates({method})})
    mutants.insert(mutants.end(), more.begin(), more.end());
  count_mutants(mutants, row);
  for (Mutant& mutant : mutants) result.mutants.push_back({std::move(mutant)});
  return result;
}

}  // namespace

bool ProofRow::symplectic() const { return symplectic_defect <= proof::symplectic_rounding; }
bool ProofRow::reversible() const { return return_defect <= proof::return_rounding; }

ProofResult prove(const Options& options, const Runner& runner) {
  std::vector<const MethodFacts*> methods;
  for (const MethodFacts& method : proof::all_method_facts())
    if (any_glob_matches(options.solvers, "odeum/" + method.id())) methods.push_back(&method);
  return runner.run(
      "proofs", methods, [](const MethodFacts* method) { return method->id(); },
      [&](const MethodFacts* method) { return prove_method(*method, options.quick); });
}

}  // namespace odeum::study
