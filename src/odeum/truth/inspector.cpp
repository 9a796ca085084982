// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/inspector.hpp"

#include <algorithm>
#include <cmath>

namespace odeum::truth {
namespace {

using formula::Interval;
using formula::Intervals;
using formula::lanes;
using formula::Op;

/// The interval is at least as wide as the rounding to double.
Interval box_of(Real low, Real high) {
  const Real rounding = 0x1p-51L * std::max(std::abs(low), std::abs(high));
  return {static_cast<double>(low - rounding), static_cast<double>(high + rounding)};
}

/// Whether positive or negative numbers vary by a factor of no more than that.
bool within_factor(const Interval& x, double factor) {
  if (x.low > 0) return x.high <= factor * x.low;
  return x.high < 0 && x.low >= factor * x.high;
}

/// Whether a function `v` of a (and b) varies over a cell by no more than a part of its own scale,
/// a step having eight cells.
bool is_resolved(Op op, const Interval& a, const Interval& b, const Interval& v) {
  constexpr double part = 0.25, factor = 1.5;
  // A function that has reached its limit, like tanh, is constant to this. Intervals widen by
  // 2^-49.
  constexpr double constant = 0x1p-47;
  constexpr double zero = 1e-300;
  if (v.width() <= constant * std::max(std::abs(v.low), std::abs(v.high)) + zero) return true;
  switch (op) {
    case Op::divide:
      return within_factor(b, factor);
    case Op::log:
    case Op::log10:
    case Op::sqrt:
      return within_factor(a, factor);
    case Op::power:
      return within_factor(a, factor) && b.width() <= part &&
             std::log(std::abs(a.high / a.low)) * std::abs(b.middle()) <= 2 * part;
    case Op::hypot:
      return within_factor(v, factor);
    case Op::asin:
    case Op::acos:
      return within_factor({1 - a.high, 1 - a.low}, factor) &&
             within_factor({1 + a.low, 1 + a.high}, factor);
    case Op::atan:
      return a.width() <= part * std::max({1.0, a.low, -a.high});
    case Op::atan2:
      return v.width() <= part;
    case Op::exp:
      return a.width() <= 4 * part;  // has no scale but its growth
    default:
      return a.width() <= part;
  }
}

}  // namespace

Inspector::Inspector(const formula::Graph& graph, const std::vector<formula::Id>& equations,
                     const std::vector<formula::Id>& conditions, Real t0, Real span)
    : enclosure_(graph,
                 [&] {
                   std::vector<formula::Id> roots = equations;
                   roots.insert(roots.end(), conditions.begin(), conditions.end());
                   return roots;
                 }()),
      t0_(t0),
      span_(span),
      path_(equations.size()),
      tube_(equations.size()),
      states_(equations.size()) {
  for (std::uint32_t k = 0; k < enclosure_.steps().size(); ++k)
    if (enclosure_.steps()[k].is_function) functions_.push_back(k);
  for (std::size_t k = 0; k < conditions.size(); ++k)
    conditions_.push_back(enclosure_.place(equations.size() + k));
}

Real Inspector::at(Real part, std::size_t i) const {
  const auto& c = path_[i];
  return c[0] + part * (c[1] + part * (c[2] + part * c[3]));
}

const std::vector<Intervals>& Inspector::over_cells(Real from, Real to) {
  const Real width = (to - from) / lanes, third = width / 3;
  // The cubic's error has double zeros at both ends of the step.
  const Real farthest = std::clamp(0.5L, from, to), inward = farthest * (1 - farthest);
  for (std::size_t s = 0; s < lanes; ++s)
    time_[s] = box_of(t_ + h_ * (from + width * s), t_ + h_ * (from + width * (s + 1)));
  for (std::size_t i = 0; i < path_.size(); ++i) {
    const Real tube = tube_[i] * 16 * inward * inward;
    const auto& c = path_[i];
    const auto slope = [&](Real part) { return c[1] + part * (2 * c[2] + part * 3 * c[3]); };
    Real y = at(from, i), d = slope(from);
    for (std::size_t s = 0; s < lanes; ++s) {
      // The hull of its control points encloses a cubic.
      const Real right = from + width * (s + 1), z = at(right, i), e = slope(right);
      const Real second = y + third * d, third_point = z - third * e;
      states_[i][s] = box_of(std::min({y, z, second, third_point}) - tube,
                             std::max({y, z, second, third_point}) + tube);
      y = z;
      d = e;
    }
  }
  return enclosure_(time_, states_);
}

std::array<bool, lanes> Inspector::undecided(const std::vector<Intervals>& values) const {
  std::array<bool, lanes> cells{};
  for (const std::uint32_t k : conditions_)
    for (std::size_t s = 0; s < lanes; ++s) cells[s] = cells[s] || !(values[k][s].low > 0);
  return cells;
}

std::size_t Inspector::first_changed(Real from, Real to) {
  const Real width = (to - from) / lanes;
  const auto end_of = [&](std::size_t s) { return from + width * (s + 1); };
  for (std::size_t s = 0; s < lanes; ++s) {
    const Real part = end_of(s);
    time_[s] = box_of(t_ + h_ * part, t_ + h_ * part);
    for (std::size_t i = 0; i < path_.size(); ++i) states_[i][s] = box_of(at(part, i), at(part, i));
  }
  const auto& values = enclosure_(time_, states_);
  std::size_t first = lanes;
  for (const std::uint32_t k : conditions_)
    for (std::size_t s = 0; s < first; ++s)
      // It has just become positive where the solution begins at a change.
      if (values[k][s].middle() <= 0 && t_ + h_ * end_of(s) > t0_ + 2 * shortest_inspected * span_)
        first = s;
  return first;
}

Inside Inspector::find_change(Real from, Real to, int& cells) {
  constexpr int most_cells = 2000;
  constexpr Real finest = 0x1p-24L;
  const Real width = (to - from) / lanes;
  const std::array<bool, lanes> open = undecided(over_cells(from, to));
  const std::size_t changed = first_changed(from, to);
  for (std::size_t s = 0; s < lanes; ++s) {
    if (!open[s]) continue;
    const Real left = from + width * s, right = from + width * (s + 1);
    if (s == changed) return {Inside::Kind::change, left, right};
    cells += lanes;
    if (width > finest && cells < most_cells) {
      const Inside inside = find_change(left, right, cells);
      if (inside.kind != Inside::Kind::nothing) return inside;
    } else if (!(t_ == t0_ && left == 0)) {  // there a condition has just changed
      return {Inside::Kind::hidden, left, right};
    }
  }
  return {};
}

void Inspector::rounding(Real t, const State& y, State& bound) {
  const auto fill = [](Intervals& boxes, Real value) {
    boxes.fill({static_cast<double>(value), static_cast<double>(value)});
  };
  fill(time_, t);
  for (std::size_t i = 0; i < y.size(); ++i) fill(states_[i], y[i]);
  const auto& values = enclosure_(time_, states_);
  // An operation widens by 2^-49 of its value, where extended precision rounds to 2^-64 of it.
  for (std::size_t i = 0; i < y.size(); ++i)
    bound[i] = static_cast<Real>(values[enclosure_.place(i)][0].width()) * 0x1p-15L;
}

State Inspector::spread(Real t, Real h, const State& y, const State& next) {
  State low(y.size(), std::numeric_limits<Real>::infinity()), high(y.size(), -low.front());
  const auto extend = [&](bool whole) {
    for (std::size_t s = 0; s < lanes; ++s) {
      const Real part = static_cast<Real>(s) / (lanes - 1), at = t + part * h;
      time_[s] = whole ? box_of(t, t + h) : box_of(at, at);
      for (std::size_t i = 0; i < y.size(); ++i) {
        const Real z = y[i] + part * (next[i] - y[i]), aside = (next[i] - y[i]) / 4;
        states_[i][s] = whole ? box_of(std::min({y[i], next[i]}) - std::abs(aside),
                                       std::max({y[i], next[i]}) + std::abs(aside))
                              : box_of(z, z);
      }
    }
    const auto& values = enclosure_(time_, states_);
    for (std::size_t i = 0; i < y.size(); ++i)
      for (const Interval& v : values[enclosure_.place(i)]) {
        low[i] = std::min<Real>(low[i], whole ? v.low : v.middle());
        high[i] = std::max<Real>(high[i], whole ? v.high : v.middle());
      }
  };
  extend(true);
  State width(y.size());
  bool bounded = true;
  for (std::size_t i = 0; i < y.size(); ++i) {
    width[i] = high[i] - low[i];
    bounded = bounded && std::isfinite(width[i]);
  }
  if (bounded) return width;
  std::ranges::fill(low, std::numeric_limits<Real>::infinity());
  std::ranges::fill(high, -std::numeric_limits<Real>::infinity());
  extend(false);
  for (std::size_t i = 0; i < y.size(); ++i)
    if (!std::isfinite(width[i])) width[i] = high[i] - low[i];
  return width;
}

Inside Inspector::look(Real t, Real h, const State& y, const State& slope, const State& next,
                       const State& next_slope) {
  t_ = t;
  h_ = h;
  for (std::size_t i = 0; i < y.size(); ++i) {
    const Real change = next[i] - y[i], a = h * slope[i], b = h * next_slope[i];
    path_[i] = {y[i], a, 3 * change - 2 * a - b, a + b - 2 * change};
    // The cubic's error is the next term, some fraction of the term before.
    tube_[i] = 0.1L * std::abs((a + b) / 2 - change);
  }
  const auto& values = over_cells(0, 1);
  std::size_t unresolved = lanes;
  for (const std::uint32_t k : functions_) {
    const auto& step = enclosure_.steps()[k];
    for (std::size_t s = 0; s < unresolved; ++s)
      if (!is_resolved(step.op, values[step.a][s], values[step.b][s], values[k][s])) unresolved = s;
  }
  int cells = 0;
  const std::array<bool, lanes> open = undecided(values);
  if (std::find(open.begin(), open.begin() + unresolved, true) != open.begin() + unresolved) {
    const Inside inside = find_change(0, static_cast<Real>(unresolved) / lanes, cells);
    if (inside.kind != Inside::Kind::nothing) return inside;
  }
  if (unresolved < lanes) return {Inside::Kind::hidden, static_cast<Real>(unresolved) / lanes, 1};
  return {};
}

}  // namespace odeum::truth
