// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/brought/comparison.hpp"

#include <algorithm>
#include <cmath>

#include "odeum/core/numbers.hpp"

namespace odeum::brought {

std::size_t most_moved(const std::vector<double>& at, const std::vector<double>& next) {
  std::size_t i = 0;
  for (std::size_t j = 1; j < at.size(); ++j)
    if (std::abs(next[j] - at[j]) > std::abs(next[i] - at[i])) i = j;
  return i;
}

Comparison::Comparison(const Case& c, const Trajectory& run) : problem_(c), run_(run) {
  const std::size_t last = run.rows() - 1;
  constexpr std::size_t most_rows = 40;
  for (std::size_t k = 0; k < std::min(last, most_rows / 4); ++k) firsts_.push_back(k);
  for (std::size_t k = 1; k < most_rows; ++k)
    if (const std::size_t row = k * last / most_rows; row > firsts_.back() && row < last)
      firsts_.push_back(row);
}

bool Comparison::fits(const Candidate& candidate, double factor, double unsure) const {
  std::size_t compared = 0;
  for (const std::size_t first : firsts_) {
    if (first + candidate.history >= run_.rows()) continue;
    if (!is_finite_to(first + candidate.history)) break;
    if (!fits_at(candidate, first, factor, unsure)) return false;
    ++compared;
  }
  return compared > 1;
}

std::vector<double> Comparison::defect(const Candidate& candidate) const {
  std::vector<double> found;
  if (candidate.history >= run_.rows() || !defect_at(candidate, rows_at(candidate, 0, 1), found))
    return {};
  return found;
}

std::optional<double> Comparison::other_step(const Candidate& candidate) const {
  constexpr double one_size = 0.02;
  std::vector<double> factors;
  for (const std::size_t first : firsts_)
    if (first + candidate.history < run_.rows())
      if (const double factor = factor_at(candidate, first); std::isfinite(factor))
        factors.push_back(factor);
  if (factors.size() < 3) return {};
  std::ranges::sort(factors);
  const double middle = factors[factors.size() / 2];
  const double spread = factors[factors.size() * 3 / 4] - factors[factors.size() / 4];
  if (!(middle > 0) || spread > one_size * middle || std::abs(middle - 1) <= 2 * spread) return {};
  if (!fits(candidate, middle, spread)) return {};
  return middle;
}

bool Comparison::is_finite_to(std::size_t row) const {
  for (std::size_t i = 0; i < n(); ++i)
    if (!std::isfinite(run_.state(row)[i])) return false;
  return true;
}

Rows Comparison::rows_at(const Candidate& candidate, std::size_t first, double factor) const {
  const double apart = run_.apart > 0 ? run_.apart : run_.times[first + 1] - run_.times[first];
  Rows rows{run_.times[first],
            factor * apart / static_cast<double>(run_.steps_a_row),
            run_.steps_a_row,
            {}};
  for (std::size_t k = 0; k <= candidate.history; ++k) rows.y.push_back(run_.state(first + k));
  return rows;
}

bool Comparison::defect_at(const Candidate& candidate, const Rows& rows,
                           std::vector<double>& defect) const {
  defect.resize(n());
  return candidate.defect(problem_, rows, defect.data()) &&
         std::ranges::all_of(defect, [](double d) { return std::isfinite(d); });
}

bool Comparison::fits_at(const Candidate& candidate, std::size_t first, double factor,
                         double unsure) const {
  std::vector<double> defect, moved;
  const Rows rows = rows_at(candidate, first, factor);
  if (!defect_at(candidate, rows, defect)) return false;
  std::vector<double> allowed(n(), 0.0);
  // What half a unit in the last place of each number comes to; and eight roundings of doubles,
  // since sums have an order.
  for (std::size_t k = 0; k < rows.y.size(); ++k)
    for (std::size_t i = 0; i < n(); ++i) {
      const double value = rows.y[k][i];
      const double width =
          1.05 * run_.half_place(first + k)[i] + 8 * 0x1p-53 * std::abs(value) + 1e-300;
      std::vector<double> state(rows.y[k], rows.y[k] + n());
      state[i] += width;
      Rows other = rows;
      other.y[k] = state.data();
      if (!defect_at(candidate, other, moved)) return false;
      for (std::size_t j = 0; j < n(); ++j) allowed[j] += std::abs(moved[j] - defect[j]);
      allowed[i] += width;
    }
  Rows longer = rows;
  const double part = std::max(unsure, 1e-13);
  longer.h *= 1 + part;
  if (!defect_at(candidate, longer, moved)) return false;
  for (std::size_t j = 0; j < n(); ++j) {
    allowed[j] += std::abs(moved[j] - defect[j]);
    if (std::abs(defect[j]) > allowed[j]) return false;
  }
  return true;
}

/// The secant method, on the component that a step moves most; NaN: it does not converge.
double Comparison::factor_at(const Candidate& candidate, std::size_t first) const {
  constexpr int most_tries = 12;
  std::vector<double> at, next;
  double x = 1, other = 1.01;
  if (!defect_at(candidate, rows_at(candidate, first, x), at) ||
      !defect_at(candidate, rows_at(candidate, first, other), next))
    return nan;
  const std::size_t i = most_moved(at, next);
  for (int k = 0; k < most_tries; ++k) {
    const double slope = (next[i] - at[i]) / (other - x);
    if (slope == 0 || !std::isfinite(slope)) return next[i] == 0 ? other : nan;
    const double better = other - next[i] / slope;
    if (std::abs(better - other) <= 1e-12 * std::abs(other)) return better;
    if (!(better > 0.01 && better < 100)) return nan;
    x = other, at = next, other = better;
    if (!defect_at(candidate, rows_at(candidate, first, other), next)) return nan;
  }
  return other;
}

}  // namespace odeum::brought
