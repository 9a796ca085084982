// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/exact.hpp"

#include <algorithm>
#include <cmath>
#include <random>

namespace odeum::formula {
namespace {

/// The formula of each state, its derivative by the time, and the start.
std::vector<Id> roots_of(Problem& problem) {
  const auto by_time =
      gradients(problem.graph, problem.exact, static_cast<std::uint32_t>(problem.states.size()));
  std::vector<Id> roots = problem.exact;
  for (const auto& entries : by_time)
    roots.push_back(entries.empty() ? problem.graph.constant(0) : entries.front().value);
  roots.insert(roots.end(), problem.start.begin(), problem.start.end());
  return roots;
}

}  // namespace

std::vector<long double> definitions_of(const Graph& graph,
                                        const std::map<std::string, long double>& parameters) {
  std::vector<long double> known;
  const auto value = [&](Id id) {
    if (id == no_node) return 0.0L;
    return graph.is_number(id) ? graph[id].value : known[graph[id].index - 1];
  };
  for (const Definition& each : graph.definitions())
    known.push_back(each.op == Op::constant
                        ? parameters.at(each.name)
                        : apply(each.op, value(each.of[0]), value(each.of[1]), value(each.of[2])));
  return known;
}

Exact::Exact(Problem& problem)
    : n_(problem.states.size()),
      solution_(problem.graph, roots_of(problem)),
      equations_(problem.graph, problem.equations),
      y_(3 * n_),
      f_(n_) {}

void Exact::define(const std::vector<long double>& definitions) {
  solution_.define(definitions);
  equations_.define(definitions);
}

/// The equations may amplify the rounding of y, as differences of neighbours on a fine mesh do,
/// which are 0 where all states are moved alike. A state that is nearly 0 has the rounding of
/// larger numbers, as the sine of pi has.
std::vector<long double> Exact::rounding_at(long double t) const {
  constexpr int draws = 4;
  constexpr long double by = 1e-14L, of_largest = 0.01L, of_rounding = 0.01L;
  std::mt19937 random(1);
  std::vector<long double> moved(n_), f(n_), rounding(n_);
  long double largest = 0;
  for (std::size_t k = 0; k < n_; ++k) largest = std::max(largest, std::abs(y_[k]));
  for (int draw = 0; draw < draws; ++draw) {
    for (std::size_t k = 0; k < n_; ++k)
      moved[k] = y_[k] + by * (std::abs(y_[k]) + of_largest * largest) *
                             (2 * (static_cast<long double>(random()) * 0x1p-32L) - 1);
    equations_(t, moved.data(), f.data());
    for (std::size_t k = 0; k < n_; ++k) rounding[k] += of_rounding * std::abs(f[k] - f_[k]);
  }
  return rounding;
}

std::optional<Exact::Flaw> Exact::flaw_at(long double t, long double t0, long double end) {
  solution_(t, nullptr, y_.data());
  equations_(t, y_.data(), f_.data());
  std::vector<long double> rounding;  // made where it is asked for
  for (std::size_t k = 0; k < n_; ++k) {
    const long double slope = y_[n_ + k], start = y_[2 * n_ + k];
    if (t == t0 &&
        !(std::abs(y_[k] - start) <= agreement * std::max(std::abs(start), std::abs(y_[k]))))
      return Flaw{k, true, y_[k], start};
    const long double apart = std::abs(slope - f_[k]);
    const long double allowed =
        agreement * (std::abs(slope) + std::abs(f_[k]) + std::abs(y_[k]) / (end - t0));
    if (apart <= allowed) continue;
    if (rounding.empty()) rounding = rounding_at(t);
    if (!(apart <= allowed + rounding[k])) return Flaw{k, false, slope, f_[k]};
  }
  return std::nullopt;
}

}  // namespace odeum::formula
