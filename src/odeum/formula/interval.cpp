// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/interval.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <unordered_map>

namespace odeum::formula {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;
constexpr Interval whole{-infinite, infinite};

/// Outward by four units of the last place, which is more than an operation is off by (glibc's
/// functions: two), so that the rounding mode need not be changed.
Interval outward(double low, double high) {
  constexpr double part = 0x1p-50, least = std::numeric_limits<double>::denorm_min();
  const Interval r{low - (std::abs(low) * part + least), high + (std::abs(high) * part + least)};
  return r.low <= r.high ? r : whole;  // NaN: no bound is known
}
Interval hull(const Interval& a, const Interval& b) {
  return {std::min(a.low, b.low), std::max(a.high, b.high)};
}
bool has_zero(const Interval& a) { return a.low <= 0 && a.high >= 0; }
Interval magnitude(const Interval& a) {
  const double low = std::abs(a.low), high = std::abs(a.high);
  return {has_zero(a) ? 0 : std::min(low, high), std::max(low, high)};
}

bool is_zero(const Interval& a) { return a.low == 0 && a.high == 0; }

Interval product(const Interval& a, const Interval& b) {
  // Zero stands for a branch that is not taken, or a factor that is absent.
  if (is_zero(a) || is_zero(b)) return {0, 0};
  const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
  // 0 * infinity is NaN, which min and max would drop.
  if (!std::isfinite(p + q + r + s)) return whole;
  return outward(std::min(std::min(p, q), std::min(r, s)),
                 std::max(std::max(p, q), std::max(r, s)));
}
Interval quotient(const Interval& a, const Interval& b) {
  if (has_zero(b)) return whole;
  return product(a, outward(1 / b.high, 1 / b.low));
}

template <class F>
Interval rising(const Interval& a, F f, double from = -infinite, double to = infinite) {
  return outward(f(std::clamp(a.low, from, to)), f(std::clamp(a.high, from, to)));
}

/// The range of a sine or cosine with its maxima at shift + 2 pi k; `low` and `high` are its values
/// at the ends of a.
Interval wave(const Interval& a, double shift, double low, double high) {
  const double off = 4e-16 * (std::abs(a.low) + std::abs(a.high) + 1);
  const double from = (a.low - shift - off) / (2 * pi), to = (a.high - shift + off) / (2 * pi);
  if (!(to - from < 1)) return {-1, 1};
  const bool top = std::floor(to) >= from, bottom = std::floor(to - 0.5) >= from - 0.5;
  const Interval ends = outward(std::min(low, high), std::max(low, high));
  return {bottom ? -1 : ends.low, top ? 1 : ends.high};
}

Interval tangent(const Interval& a) {
  const double from = a.low / pi - 0.5, to = a.high / pi - 0.5;
  constexpr double off = 1e-15;
  if (!(std::floor(to + off * std::abs(to)) < from - off * std::abs(from))) return whole;
  return rising(a, [](double x) { return std::tan(x); });
}

Interval power(const Interval& a, const Interval& b) {
  const double exponent = b.middle();
  if (a.low < 0 && exponent == std::round(exponent) && b.width() < 1e-9 * std::abs(exponent)) {
    const Interval size = power(magnitude(a), {exponent, exponent});
    if (std::fmod(exponent, 2) == 0) return size;
    return a.high <= 0 ? Interval{-size.high, -size.low} : Interval{-size.high, size.high};
  }
  const double low = std::max(a.low, 0.0), high = std::max(a.high, 0.0);
  const Interval first = outward(std::min(std::pow(low, b.low), std::pow(low, b.high)),
                                 std::max(std::pow(low, b.low), std::pow(low, b.high)));
  const Interval second = outward(std::min(std::pow(high, b.low), std::pow(high, b.high)),
                                  std::max(std::pow(high, b.low), std::pow(high, b.high)));
  return hull(first, second);
}

Interval angle(const Interval& y, const Interval& x) {
  if (x.low <= 0 && has_zero(y)) return {-pi * (1 + 1e-15), pi * (1 + 1e-15)};
  Interval r{infinite, -infinite};
  for (const double v : {y.low, y.high})
    for (const double w : {x.low, x.high}) {
      const double corner = std::atan2(v, w);
      r = hull(r, {corner, corner});
    }
  return outward(r.low, r.high);
}

Interval truth(bool always, bool never) { return {always ? 1.0 : 0.0, never ? 0.0 : 1.0}; }

Interval of_two(Op op, const Interval& a, const Interval& b) {
  switch (op) {
    case Op::less:
      return truth(a.high < b.low, a.low >= b.high);
    case Op::less_equal:
      return truth(a.high <= b.low, a.low > b.high);
    case Op::equal:
      return truth(a.width() == 0 && b.width() == 0 && a.low == b.low,
                   a.high < b.low || b.high < a.low);
    case Op::power:
      return power(a, b);
    case Op::atan2:
      return angle(a, b);
    case Op::hypot: {
      const Interval x = magnitude(a), y = magnitude(b);
      return outward(std::hypot(x.low, y.low), std::hypot(x.high, y.high));
    }
    case Op::min:
      return {std::min(a.low, b.low), std::min(a.high, b.high)};
    case Op::max:
      return {std::max(a.low, b.low), std::max(a.high, b.high)};
    default:
      return whole;
  }
}

}  // namespace

Interval enclose(Op op, const Interval& a, const Interval& b, const Interval& c) {
  const auto f = [op](double x) { return apply(op, x, 0.0, 0.0); };
  switch (op) {
    case Op::negate:
      return {-a.high, -a.low};
    case Op::add:
      return outward(a.low + b.low, a.high + b.high);
    case Op::subtract:
      return outward(a.low - b.high, a.high - b.low);
    case Op::multiply:
      return product(a, b);
    case Op::divide:
      return quotient(a, b);
    case Op::sin:
      return wave(a, pi / 2, std::sin(a.low), std::sin(a.high));
    case Op::cos:
      return wave(a, 0, std::cos(a.low), std::cos(a.high));
    case Op::tan:
      return tangent(a);
    case Op::acos:
      return rising(
          {-a.high, -a.low}, [&](double x) { return f(-x); }, -1, 1);
    case Op::cosh:
      return rising(magnitude(a), f);
    case Op::asin:
      return rising(a, f, -1, 1);
    case Op::log:
    case Op::log10:
    case Op::sqrt:
      return rising(a, f, 0);
    case Op::atan:
    case Op::sinh:
    case Op::tanh:
    case Op::exp:
    case Op::sign:
      return rising(a, f);
    case Op::floor:
      return {std::floor(a.low), std::floor(a.high)};
    case Op::side:
      return {a.low < 0 ? -1.0 : 1.0, a.high < 0 ? -1.0 : 1.0};
    case Op::abs:
      return magnitude(a);
    case Op::choose:  // a condition is 0 or 1
      if (!has_zero(a)) return b;
      return a.high < 0.5 ? c : hull(b, c);
    default:
      return of_two(op, a, b);
  }
}

Enclosure::Enclosure(const Graph& graph, const std::vector<Id>& roots) {
  std::unordered_map<Id, std::uint32_t> place;
  const auto at = [&](Id id) { return id == no_node ? 0 : place.at(id); };
  for (const Id id : graph.needed(roots)) {
    const Node& node = graph[id];
    place.emplace(id, static_cast<std::uint32_t>(steps_.size()));
    const auto value = static_cast<double>(node.value);
    const bool is_function = !is_leaf(node.op) && node.op != Op::add && node.op != Op::subtract &&
                             node.op != Op::negate && node.op != Op::multiply &&
                             !(node.op == Op::divide && graph.is_constant(node.of[1]));
    steps_.push_back({node.op, node.op == Op::state ? node.index : at(node.of[0]), at(node.of[1]),
                      at(node.of[2]), outward(value, value), is_function});
  }
  for (const Id root : roots) roots_.push_back(place.at(root));
  values_.resize(steps_.size());
}

const std::vector<Intervals>& Enclosure::operator()(const Intervals& t,
                                                    const std::vector<Intervals>& y) {
  for (std::size_t k = 0; k < steps_.size(); ++k) {
    const Step& step = steps_[k];
    Intervals& v = values_[k];
    if (step.op == Op::constant) {
      v.fill(step.value);
    } else if (step.op == Op::time) {
      v = t;
    } else if (step.op == Op::state) {
      v = y[step.a];
    } else if (step.op == Op::multiply && step.a == step.b) {
      for (std::size_t i = 0; i < lanes; ++i) {
        const Interval size = magnitude(values_[step.a][i]);
        v[i] = outward(size.low * size.low, size.high * size.high);
      }
    } else {
      for (std::size_t i = 0; i < lanes; ++i)
        v[i] = enclose(step.op, values_[step.a][i], values_[step.b][i], values_[step.c][i]);
    }
  }
  return values_;
}

}  // namespace odeum::formula
