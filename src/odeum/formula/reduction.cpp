// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/reduction.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "odeum/formula/evaluator.hpp"

namespace odeum::formula {
namespace {

using Real = long double;

/// The first is at (t, y), those after it are nearby: a factor that is zero at all of these is
/// zero. The others are farther off, and tell which factors a solution may carry through zero.
constexpr std::size_t near = 4, samples = 12;

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
  /// `is_start`: (t, y) is where the solution starts, and not a guess of that.
  Elimination(Graph& graph, const std::vector<std::string>& names, Real t,
              const std::vector<Real>& y, bool is_start)
      : graph_(graph), names_(names), is_start_(is_start) {
    times_[0] = t;
    states_[0] = y;
    std::uint32_t seed = 1;
    for (std::size_t s = 1; s < samples; ++s) {
      const auto random = [&] {
        seed = seed * 1664525U + 1013904223U;
        return static_cast<Real>(seed) / 4294967296.0L;
      };
      times_[s] = t + random() / 16;
      for (const Real value : y)
        states_[s].push_back(s < near ? value * (1 + random() / 64) + random() / 64
                                      : value * (0.5L + random()) + 4 * random() - 2);
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
    // One level comes before the next, since a constraint may need the rates of others.
    for (std::size_t k = 0; k < result.constraints.size(); ++k) {
      if (std::optional<Constraint> hidden = differentiate(result.constraints[k]))
        result.constraints.push_back(std::move(*hidden));
      result.index = std::max(result.index, result.constraints[k].level + 1);
    }
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
    bool found = false;  // beyond the domain of a function there is no value
    for (std::size_t s = 0; s < near; ++s) {
      if (!std::isfinite(term.at[s])) continue;
      if (std::abs(term.at[s]) > rounding * std::abs(sizes[s])) return false;
      found = true;
    }
    return found;
  }

  /// x <- x - factor * y; false where zero is left.
  bool subtract(Term& x, const Term& factor, const Term& y) {
    const bool negated = graph_[y.node].op == Op::negate;
    const Id product =
        graph_.make(Op::multiply, factor.node, negated ? graph_[y.node].of[0] : y.node);
    std::array<Real, samples> sizes{};
    for (std::size_t s = 0; s < samples; ++s) {
      const Real by = factor.at[s] * y.at[s];
      sizes[s] = std::abs(x.at[s]) + std::abs(by);
      x.at[s] -= by;
    }
    if (x.node == no_node) x.node = graph_.constant(0);
    x.node = graph_.make(negated ? Op::add : Op::subtract, x.node, product);
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

  /// Least over largest magnitude at the samples; 0 where the sign changes. A pivot that a solution
  /// carries through zero ends a run there.
  static Real steadiness(const Term& term) {
    Real low = std::numeric_limits<Real>::infinity(), high = -low;
    for (const Real value : term.at) {
      if (!std::isfinite(value)) continue;
      low = std::min(low, value);
      high = std::max(high, value);
    }
    if (!(low > 0 || high < 0)) return 0;
    return low > 0 ? low / high : high / low;
  }
  /// At the start, nearby where that is not known yet.
  Real size_of_factor(const Term& term) const {
    Real size = std::abs(term.at[0]);
    for (std::size_t s = 1; s < near && !is_start_; ++s)
      if (!(size >= std::abs(term.at[s]))) size = std::abs(term.at[s]);
    return size;
  }

  /// Adds a row, which gives one of its rates: one with a constant factor, else with the steadiest
  /// one, else with the largest.
  void take(Row row) {
    Real largest = 0;
    for (const auto& [column, term] : row.of) largest = std::max(largest, size_of_factor(term));
    const auto rank = [&](const Term& term) {
      constexpr Real little = 1e-9L;
      const Real size = size_of_factor(term);
      const bool counts = size > little * largest;
      return std::tuple(counts && graph_.is_constant(term.node), counts ? steadiness(term) : 0,
                        size);
    };
    const auto pivot = std::ranges::max_element(
        row.of, [&](const auto& a, const auto& b) { return rank(a.second) < rank(b.second); });
    const Real size = size_of_factor(pivot->second);
    if (!(size > 0) || !std::isfinite(size))
      throw ReductionError(
          row.own, fmt::format("the factor of {}' is {} at the start, so that no rate "
                               "follows; expected another start, or another residual",
                               names_[pivot->first], static_cast<double>(pivot->second.at[0])));
    pivots_.push_back(pivot->first);
    done_.push_back(std::move(row));
  }

  /// Adds the derivative of a constraint along the solution; where that has no rate either, it is
  /// another constraint.
  std::optional<Constraint> differentiate(const Constraint& constraint) {
    const auto gradient = gradients(graph_, {constraint.value}, 2 * first_rate).front();
    Row row{.of = {}, .rest = {}, .residuals = constraint.of, .own = constraint.own};
    add_entries(row, gradient, 0);
    const bool by_time = !gradient.empty() && gradient.back().by == 2 * first_rate;
    row.rest = terms_of({by_time ? gradient.back().value : graph_.constant(0)}).front();
    if (row.of.empty()) throw ReductionError(constraint.own, why_without_states(constraint));
    eliminate(row);
    if (!row.of.empty()) {
      take(std::move(row));
      return std::nullopt;
    }
    if (graph_.is(row.rest.node, 0))
      throw ReductionError(
          constraint.own,
          fmt::format("after {} it says nothing new: it follows from the others, or is one of them "
                      "again; expected an independent one for each state",
                      derivatives(constraint.level + 1)));
    if (constraint.level + 1 == highest_index)
      throw ReductionError(
          constraint.own,
          fmt::format("a constraint of an index above {0}: it and {1} say nothing of {2}; expected "
                      "an index of {0} at most: another unknown, or another constraint",
                      highest_index, derivatives(highest_index), fmt::join(undetermined(), ", ")));
    return Constraint{.value = row.rest.node,
                      .of = std::move(row.residuals),
                      .own = constraint.own,
                      .level = constraint.level + 1};
  }
  std::string why_without_states(const Constraint& constraint) const {
    const std::string which = constraint.level == 0 ? "it" : derivatives(constraint.level);
    if (!graph_.is_constant(constraint.value) || graph_.is(constraint.value, 0))
      return "it has neither a rate nor a state once the others are used: it follows from them, or "
             "contradicts them; expected an independent one for each state";
    return fmt::format(
        "{} says that 0 = {:.9Lg}, whatever the states are; expected what they fulfil", which,
        graph_[constraint.value].value);
  }
  static std::string derivatives(int count) {
    return count == 1 ? "its derivative" : fmt::format("{} derivatives", count);
  }
  std::vector<std::string> undetermined() const {
    std::vector<std::string> all;
    for (std::uint32_t k = 0; k < names_.size(); ++k)
      if (std::ranges::find(pivots_, k) == pivots_.end()) all.push_back(names_[k]);
    return all;
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
  bool is_start_;
  std::array<Real, samples> times_{};
  std::array<std::vector<Real>, samples> states_;
  std::vector<Row> done_;
  std::vector<std::uint32_t> pivots_;  ///< the rate that each gives
};

}  // namespace

Reduction reduce(Graph& graph, const std::vector<Id>& residuals,
                 const std::vector<std::string>& names, long double t,
                 const std::vector<long double>& y, bool is_start) {
  return Elimination(graph, names, t, y, is_start).solve(residuals);
}

}  // namespace odeum::formula
