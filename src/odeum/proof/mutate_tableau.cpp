// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "odeum/proof/code_checks.hpp"
#include "odeum/proof/embedded_check.hpp"
#include "odeum/proof/mutant.hpp"
#include "odeum/tableau/character.hpp"
#include "odeum/tableau/row_order.hpp"

namespace odeum::proof {
namespace {

using Coefficients = DynamicTableau<double>;
using Orders = std::vector<judge::OrderFit>;

/// The properties of the unaltered tableau, with which a mutant is compared.
struct Claims {
  Coefficients tableau;
  Structure structure;
  StabilityClass stability;
  Orders orders, orders_hat;  ///< measured, by test problem
};

bool has_order(const Coefficients& t, const std::vector<double>& row, int order) {
  const RowOrder<double> found =
      order_of_row(t, row, double_rounding, std::min(order + 1, highest_order_checked));
  return found.order == order;
}

// 0.01 degrees: ten times the accuracy of the angle.
bool same(const StabilityClass& x, const StabilityClass& y) {
  return x.a_stable() == y.a_stable() && std::abs(x.angle - y.angle) <= 0.01 &&
         x.vanishes_at_infinity() == y.vanishes_at_infinity();
}

bool nodes_are_row_sums(const Coefficients& t) {
  for (std::size_t i = 0; i < t.stages; ++i)
    if (std::abs(t.c[i] - t.row_sum(i)) > 1e-13) return false;
  return true;
}

Orders orders_by_running(const Coefficients& t, int order) {
  Orders fits;
  for (const TestProblem<FunctionProblem>& test : test_problems())
    fits.push_back(measure_order(interpreted(t), order, test));
  return fits;
}

Coefficients estimating(const Coefficients& t) {
  Coefficients other = t;
  other.b = t.b_hat;
  other.b_hat.clear();
  return other;
}

// First the checks of coefficients, which are cheap; then runs, and the stated nodes.
std::string caught_early(const Coefficients& mutant, const Claims& sound) {
  const Coefficients& t = sound.tableau;
  if (!has_order(mutant, mutant.b, t.order)) return "order conditions of b";
  if (t.embedded() && !has_order(mutant, mutant.b_hat, t.order_hat))
    return "order conditions of b_hat";
  if (structure_of(mutant) != sound.structure) return "structure";
  if (!same(stability_class(mutant), sound.stability)) return "stability class";
  return {};
}

std::string difference_in(const Orders& found, const Orders& expected, const char* of) {
  for (std::size_t i = 0; i < found.size(); ++i)
    if (!same_order(found[i], expected[i]))
      return fmt::format("order {}on {}: {}", of, test_problems()[i].id,
                         to_string(found[i].verdict));
  return {};
}

std::string caught_by_running(const Coefficients& mutant, const Claims& sound) {
  const Coefficients& t = sound.tableau;
  std::string by;
  if (mutant.a != t.a || mutant.b != t.b || mutant.c != t.c)
    by = difference_in(orders_by_running(mutant, t.order), sound.orders, "");
  if (by.empty() && t.embedded())
    by = difference_in(orders_by_running(estimating(mutant), t.order_hat), sound.orders_hat,
                       "of b_hat ");
  return by;
}

class Maker {
 public:
  Maker(const MethodFacts& method, Checks checks)
      : id_(method.id()),
        checks_(checks),
        sound_{*method.tableau,
               structure_of(*method.tableau),
               stability_class(*method.tableau),
               orders_by_running(*method.tableau, method.tableau->order),
               {}} {
    const Coefficients& t = sound_.tableau;
    if (t.embedded()) sound_.orders_hat = orders_by_running(estimating(t), t.order_hat);
  }

  std::vector<Mutant> all() {
    const Coefficients& t = sound_.tableau;
    for (std::size_t i = 0; i < t.stages; ++i) {
      for (std::size_t j = 0; j < t.stages; ++j)
        alter(fmt::format("a[{}][{}]", i + 1, j + 1),
              [&](Coefficients& m) -> double& { return m.at(i, j); });
      alter(fmt::format("b[{}]", i + 1), [&](Coefficients& m) -> double& { return m.b[i]; });
      if (t.embedded())
        alter(fmt::format("b_hat[{}]", i + 1),
              [&](Coefficients& m) -> double& { return m.b_hat[i]; });
    }
    for (std::size_t i = 0; i < t.stages; ++i) {
      drop(i);
      move_node(i, t.c[i] + 0.01, "a hundredth late");
      if (t.c[i] != 0) move_node(i, 0, "at the start of the step");
    }
    return std::move(mutants_);
  }

 private:
  template <class Entry>
  void alter(const std::string& name, Entry&& entry) {
    if (Coefficients probe = sound_.tableau; entry(probe) == 0) return;
    const auto with = [&](auto&& change, const char* kind, double size, const std::string& text) {
      Coefficients m = sound_.tableau;
      double& value = entry(m);
      value = change(value);
      m.set_nodes_to_row_sums();
      judge(m, {id_, kind, text, size});
    };
    for (const double size : mutation_sizes) {
      if (checks_ == Checks::running_only && size < 1e-3) break;
      with([&](double x) { return x * (1 + size); }, "coefficient", size,
           fmt::format("{} by {:g}", name, size));
    }
    with([](double x) { return -x; }, "sign", 0, fmt::format("{} negated", name));
  }

  void drop(std::size_t stage) {
    Coefficients m = sound_.tableau;
    m.b[stage] = 0;
    if (m.embedded()) m.b_hat[stage] = 0;
    for (std::size_t i = 0; i < m.stages; ++i) m.at(i, stage) = 0;
    m.set_nodes_to_row_sums();
    judge(m, {id_, "stage", fmt::format("stage {} dropped", stage + 1)});
  }

  void move_node(std::size_t i, double c, const char* how) {
    Coefficients m = sound_.tableau;
    m.c[i] = c;
    judge(m, {id_, "node", fmt::format("c[{}] {}", i + 1, how)});
  }

  void judge(const Coefficients& m, Mutant mutant) {
    if (checks_ == Checks::quickest_first) mutant.caught_by = caught_early(m, sound_);
    if (!mutant.caught()) {
      // Equivalent where no result changes. 1e-15: the sums are formed in the same order.
      if (difference_between({interpreted(m), {}, {}}, {interpreted(sound_.tableau), {}, {}}) <=
          1e-15)
        mutant.equivalent = "no result depends on it";
      else
        mutant.caught_by = caught_by_running(m, sound_);
      if (checks_ == Checks::quickest_first && mutant.survived() && !nodes_are_row_sums(m))
        mutant.caught_by = "nodes against row sums";
    }
    mutants_.push_back(std::move(mutant));
  }

  std::string id_;
  Checks checks_;
  Claims sound_;
  std::vector<Mutant> mutants_;
};

}  // namespace

std::vector<Mutant> mutate_tableau(const MethodFacts& method, Checks checks) {
  if (!method.tableau) return {};
  return Maker(method, checks).all();
}

}  // namespace odeum::proof
