// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/reduction.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "odeum/formula/evaluator.hpp"

namespace odeum::formula {
namespace {

using Real = long double;

/// The first is at (t, y), the others are nearby: a factor that is zero at all of them is zero.
constexpr std::size_t samples = 4;

/// An expression with its values at the samples.
struct Term {
  Id node = no_node;
  std::array<Real, samples> at{};
};

/// sum_k of[k] y_k' + rest = 0
struct Row {
  std::map<std::uint32_t, Term> of;
  Term rest;
  std::set<std::size_t> residuals;  ///< that it is made of
  std::size_t own = 0;              ///< the one that it was
};

class Elimination {
 public:
  Elimination(Graph& graph, const std::vector<std::string>& names, Real t,
              const std::vector<Real>& y)
      : graph_(graph), names_(names) {
    times_[0] = t;
    states_[0] = y;
    std::uint32_t seed = 1;
    for (std::size_t s = 1; s < samples; ++s) {
      const auto random = [&] {
        seed = seed * 1664525U + 1013904223U;
        return static_cast<Real>(seed) / 4294967296.0L;
      };
      times_[s] = t + random() / 16;
      for (const Real value : y) states_[s].push_back(value * (1 + random() / 64) + random() / 64);
    }
  }

  /// Takes what has rates; what is left are constraints.
  std::vector<Constraint> take_all(const std::vector<Id>& residuals) {
    std::vector<Row> rows = rows_of(residuals);
    std::ranges::stable_sort(rows,
                             [](const Row& a, const Row& b) { return a.of.size() < b.of.size(); });
    std::vector<Constraint> constraints;
    for (Row& row : rows) {
      eliminate(row);
      if (row.of.empty())
        constraints.push_back({row.rest.node, row.residuals, row.own});
      else
        take(std::move(row));
    }
    return constraints;
  }

  Reduction solve(const std::vector<Id>& residuals) {
    Reduction result{.rates = std::vector<Id>(names_.size(), no_node),
                     .constraints = take_all(residuals),
                     .by = std::vector<std::size_t>(names_.size())};
    for (const Constraint& constraint : result.constraints) differentiate(constraint);
    for (std::size_t k = done_.size(); k-- > 0;) substitute(done_[k], pivots_[k], result);
    return result;
  }

 private:
  std::vector<Term> terms_of(const std::vector<Id>& nodes) const {
    const Evaluator<Real> evaluate(graph_, nodes);
    std::vector<Real> values(nodes.size());
    std::vector<Term> terms(nodes.size());
    for (std::size_t s = 0; s < samples; ++s) {
      evaluate(times_[s], states_[s].data(), values.data());
      for (std::size_t k = 0; k < nodes.size(); ++k) terms[k].at[s] = values[k];
    }
    for (std::size_t k = 0; k < nodes.size(); ++k) terms[k].node = nodes[k];
    return terms;
  }

  std::vector<Row> rows_of(const std::vector<Id>& residuals) {
    std::map<std::uint32_t, Id> no_rates;
    for (std::uint32_t k = 0; k < names_.size(); ++k) no_rates[first_rate + k] = graph_.constant(0);
    const std::vector<Term> rests = terms_of(with_states_replaced(graph_, residuals, no_rates));
    const auto by_rate = gradients(graph_, residuals, 2 * first_rate);
    std::vector<Row> rows(residuals.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      rows[i] = {.of = {}, .rest = rests[i], .residuals = {i}, .own = i};
      add_entries(rows[i], by_rate[i], first_rate);
    }
    return rows;
  }

  /// Adds the entries of a gradient for states `first`, ... as factors of rates.
  void add_entries(Row& row, const std::vector<Entry>& gradient, std::uint32_t first) const {
    std::vector<Id> nodes;
    std::vector<std::uint32_t> columns;
    for (const Entry& entry : gradient)
      if (entry.by >= first && entry.by < first + names_.size()) {
        nodes.push_back(entry.value);
        columns.push_back(entry.by - first);
      }
    const std::vector<Term> terms = terms_of(nodes);
    for (std::size_t k = 0; k < terms.size(); ++k)
      if (!is_zero(terms[k], terms[k].at)) row.of[columns[k]] = terms[k];
  }

  /// Whether a term is rounding of numbers of these sizes.
  static bool is_zero(const Term& term, const std::array<Real, samples>& sizes) {
    constexpr Real rounding = 1e-16L;
    for (std::size_t s = 0; s < samples; ++s)
      if (!(std::abs(term.at[s]) <= rounding * std::abs(sizes[s]))) return false;
    return true;
  }

  /// x <- x - factor * y; false where zero is left.
  bool subtract(Term& x, const Term& factor, const Term& y) {
    const Id product = graph_.make(Op::multiply, factor.node, y.node);
    std::array<Real, samples> sizes{};
    for (std::size_t s = 0; s < samples; ++s) {
      const Real by = factor.at[s] * y.at[s];
      sizes[s] = std::abs(x.at[s]) + std::abs(by);
      x.at[s] -= by;
    }
    if (x.node == no_node)
      x.node = graph_.make(Op::negate, product);
    else
      x.node = graph_.make(Op::subtract, x.node, product);
    return !is_zero(x, sizes);
  }

  /// Takes from a row the rates that earlier rows give.
  void eliminate(Row& row) {
    for (std::size_t k = 0; k < done_.size(); ++k) {
      const auto found = row.of.find(pivots_[k]);
      if (found == row.of.end()) continue;
      const Row& by = done_[k];
      const Term& pivot = by.of.at(pivots_[k]);
      Term factor{.node = graph_.make(Op::divide, found->second.node, pivot.node), .at = {}};
      for (std::size_t s = 0; s < samples; ++s) factor.at[s] = found->second.at[s] / pivot.at[s];
      row.of.erase(found);
      for (const auto& [column, term] : by.of)
        if (column != pivots_[k] && !subtract(row.of[column], factor, term)) row.of.erase(column);
      if (!graph_.is(by.rest.node, 0) && !subtract(row.rest, factor, by.rest))
        row.rest.node = graph_.constant(0);
      row.residuals.insert(by.residuals.begin(), by.residuals.end());
    }
  }

  /// Adds a row, which gives one of its rates: one with a constant factor, else with the largest.
  void take(Row row) {
    const auto better = [&](const auto& a, const auto& b) {
      const bool constant_a = graph_.is_constant(a.second.node),
                 constant_b = graph_.is_constant(b.second.node);
      if (constant_a != constant_b) return constant_b;
      return std::abs(a.second.at[0]) < std::abs(b.second.at[0]);
    };
    const auto pivot = std::ranges::max_element(row.of, better);
    if (!(std::abs(pivot->second.at[0]) > 0) || !std::isfinite(pivot->second.at[0]))
      throw ReductionError(
          row.own, fmt::format("the factor of {}' is {} at the start, so that no rate "
                               "follows; expected another start, or another residual",
                               names_[pivot->first], static_cast<double>(pivot->second.at[0])));
    pivots_.push_back(pivot->first);
    done_.push_back(std::move(row));
  }

  /// Adds the derivative of a constraint along the solution.
  void differentiate(const Constraint& constraint) {
    const std::size_t own = constraint.own;
    const auto gradient = gradients(graph_, {constraint.value}, 2 * first_rate).front();
    Row row{.of = {}, .rest = {}, .residuals = constraint.of, .own = own};
    add_entries(row, gradient, 0);
    const bool by_time = !gradient.empty() && gradient.back().by == 2 * first_rate;
    row.rest = terms_of({by_time ? gradient.back().value : graph_.constant(0)}).front();
    if (row.of.empty())
      throw ReductionError(own,
                           "it has neither a rate nor a state once the others are used: it follows "
                           "from them, or contradicts them; expected an independent one for each "
                           "state");
    eliminate(row);
    if (!row.of.empty()) return take(std::move(row));
    std::vector<std::string> undetermined;
    for (std::uint32_t k = 0; k < names_.size(); ++k)
      if (std::ranges::find(pivots_, k) == pivots_.end()) undetermined.push_back(names_[k]);
    throw ReductionError(
        own, fmt::format("a constraint of an index above 1: it and its derivative say nothing of "
                         "{}; expected index 1: differentiate this residual, put the rates of the "
                         "others in, and state that in its place",
                         fmt::join(undetermined, ", ")));
  }

  /// The rate that a row gives, where those of later rows are known.
  void substitute(const Row& row, std::uint32_t pivot, Reduction& result) {
    Id sum = row.rest.node;
    for (const auto& [column, term] : row.of)
      if (column != pivot)
        sum = graph_.make(Op::add, sum, graph_.make(Op::multiply, term.node, result.rates[column]));
    const Id factor = row.of.at(pivot).node;
    result.rates[pivot] =
        graph_.make(Op::negate, graph_.is(factor, 1) ? sum : graph_.make(Op::divide, sum, factor));
    result.by[pivot] = row.own;
  }

  Graph& graph_;
  const std::vector<std::string>& names_;
  std::array<Real, samples> times_{};
  std::array<std::vector<Real>, samples> states_;
  std::vector<Row> done_;
  std::vector<std::uint32_t> pivots_;  ///< the rate that each gives
};

}  // namespace

std::set<std::uint32_t> nonlinear_rates(Graph& graph, const std::vector<Id>& residuals) {
  std::set<std::uint32_t> found;
  for (const auto& row : gradients(graph, residuals, 2 * first_rate))
    for (const Entry& entry : row) {
      if (entry.by < first_rate || entry.by == 2 * first_rate) continue;
      for (const Id id : graph.needed({entry.value}))
        if (graph[id].op == Op::state && graph[id].index >= first_rate)
          found.insert(entry.by - first_rate);
    }
  return found;
}

std::vector<Id> with_states_replaced(Graph& graph, const std::vector<Id>& roots,
                                     const std::map<std::uint32_t, Id>& by) {
  std::map<Id, Id> made;
  for (const Id id : graph.needed(roots)) {
    const Node node = graph[id];
    Id now = id;
    if (node.op == Op::state) {
      if (const auto found = by.find(node.index); found != by.end()) now = found->second;
    } else if (!is_leaf(node.op)) {
      std::array<Id, 3> of = node.of;
      for (Id& each : of)
        if (each != no_node) each = made.at(each);
      if (of != node.of) now = graph.make(node.op, of[0], of[1], of[2]);
    }
    made[id] = now;
  }
  std::vector<Id> replaced;
  for (const Id root : roots) replaced.push_back(made.at(root));
  return replaced;
}

std::vector<Constraint> constraints_of(Graph& graph, const std::vector<Id>& residuals,
                                       const std::vector<std::string>& names, long double t,
                                       const std::vector<long double>& y) {
  return Elimination(graph, names, t, y).take_all(residuals);
}

Reduction reduce(Graph& graph, const std::vector<Id>& residuals,
                 const std::vector<std::string>& names, long double t,
                 const std::vector<long double>& y) {
  return Elimination(graph, names, t, y).solve(residuals);
}

}  // namespace odeum::formula
