// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

/// Zeros of a function of the time within a step: all of them, in their order.
///
/// A sign at both ends of a step shows an odd number of zeros and hides an even one. Here the
/// function is looked at in 5 points of Chebyshev within the step, and through them goes a
/// polynomial, whose Bernstein coefficients bound it; its last Chebyshev coefficients tell how far
/// the function may be from it. Where this does not exclude a zero, 9 points are taken, and parts
/// of the step are halved until each has no zero, or is monotone and has one at most. A function
/// that oscillates between those points so that it looks smooth in them is not seen through.
namespace odeum {

/// Which zeros count: rising from below zero to above, falling, or any, touches among them.
enum class Crossing { any, rising, falling };

/// A zero at t: `sense` is 1 where the function rises through it, -1 where it falls, and 0 where it
/// touches zero to within rounding and keeps its sign.
struct Zero {
  double t;
  int sense;
  bool counts(Crossing crossing) const {
    return crossing == Crossing::any || sense == (crossing == Crossing::rising ? 1 : -1);
  }
};

namespace detail {

inline constexpr std::size_t zero_degree = 8;
using ZeroValues = std::array<double, zero_degree + 1>;
/// (1 - cos(k pi / 8)) / 2
inline constexpr ZeroValues zero_nodes{
    0,   0.03806023374435662582, 0.14644660940672623780, 0.30865828381745511414,
    0.5, 0.69134171618254488586, 0.85355339059327376220, 0.96193976625564337418,
    1};

/// From values at every `stride`-th node to the coefficients of Bernstein's form: the inverse of
/// the matrix of its polynomials there.
template <std::size_t stride>
constexpr auto bernstein_matrix() {
  constexpr std::size_t n = zero_degree / stride;
  std::array<std::array<double, n + 1>, n + 1> a{}, inverse{};
  for (std::size_t i = 0; i <= n; ++i) {
    const double x = zero_nodes[i * stride];
    for (std::size_t j = 0; j <= n; ++j) {
      double term = 1;
      for (std::size_t k = 1; k <= j; ++k)
        term *= x * static_cast<double>(n - k + 1) / static_cast<double>(k);
      for (std::size_t k = j; k < n; ++k) term *= 1 - x;
      a[i][j] = term;
      inverse[i][j] = i == j ? 1 : 0;
    }
  }
  // Gauss and Jordan without pivots: the matrix is totally positive.
  for (std::size_t k = 0; k <= n; ++k) {
    const double pivot = a[k][k];
    for (std::size_t j = 0; j <= n; ++j) a[k][j] /= pivot, inverse[k][j] /= pivot;
    for (std::size_t i = 0; i <= n; ++i) {
      if (i == k) continue;
      const double factor = a[i][k];
      for (std::size_t j = 0; j <= n; ++j) {
        a[i][j] -= factor * a[k][j];
        inverse[i][j] -= factor * inverse[k][j];
      }
    }
  }
  return inverse;
}

/// What every `stride`-th value of a function on a part of a step tells of it.
struct ZeroFit {
  double low = 0, high = 0;  ///< bounds of the polynomial
  double slope = 0;          ///< the least difference of two coefficients, 0: they go up and down
  double error = 0;          ///< how far the function may be from it
  double largest = 0;        ///< of the values
  bool noise = false;        ///< the values are not those of a smooth function
  bool excludes() const { return low > error || high < -error; }
  /// The bound of a derivative is Markov's, for a polynomial of degree 9.
  bool monotone() const { return slope > 20 * error; }
};

template <std::size_t stride>
ZeroFit zero_fit(const ZeroValues& values) {
  constexpr std::size_t n = zero_degree / stride;
  static constexpr auto matrix = bernstein_matrix<stride>();
  std::array<double, n + 1> b{};
  double tail = 0, last = 0, largest = 0;
  for (std::size_t j = 0; j <= n; ++j) {
    const double v = values[j * stride];
    for (std::size_t i = 0; i <= n; ++i) b[i] += matrix[i][j] * v;
    const double weight =
        (j == 0 || j == n ? 1.0 : 2.0) / static_cast<double>(n) * (j % 2 == 0 ? 1 : -1);
    // cos(j pi) / 2 and cos(j pi (n - 1) / n) of the last two Chebyshev coefficients
    last += weight * v / 2;
    tail += weight * v * (1 - 2 * zero_nodes[j * stride]);
    largest = std::max(largest, std::abs(v));
  }
  tail = std::abs(tail) + std::abs(last);
  ZeroFit fit{b[0], b[0], 0, 4 * tail + 1e-14 * largest, largest, largest <= 32 * tail};
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t i = 0; i < n; ++i) {
    fit.low = std::min(fit.low, b[i + 1]), fit.high = std::max(fit.high, b[i + 1]);
    least = std::min(least, b[i + 1] - b[i]), most = std::max(most, b[i + 1] - b[i]);
  }
  fit.slope = std::max({least, -most, 0.0});
  return fit;
}

/// Where g changes its sign between a, where it is g0, and b, where it is g1, by the Illinois
/// variant of the rule of false position, with a bisection where it shortens the bracket by less
/// than half in three evaluations (Dowell, Jarratt, BIT 11 (1971) 168-174). The result is the end
/// of the bracket on the far side, to the rounding of t.
template <class G>
double sign_change(G& g, double a, double g0, double b, double g1) {
  const double least =
      4 * std::numeric_limits<double>::epsilon() * std::max(std::abs(a), std::abs(b));
  double three_ago = b - a;
  int side = 0;
  for (int round = 1; g1 != 0 && b - a > least; ++round) {
    double t = b - g1 * (b - a) / (g1 - g0);
    if (round % 3 == 0) {
      if (b - a > three_ago / 2) t = a + (b - a) / 2;
      three_ago = b - a;
    }
    t = std::min(std::max(t, a + least / 2), b - least / 2);
    if (!(t > a && t < b)) break;
    const double value = g(t);
    if (!std::isfinite(value)) break;
    if (value == 0 || (value > 0) == (g1 > 0)) {
      b = t, g1 = value;
      if (side == 1) g0 /= 2;
      side = 1;
    } else {
      a = t, g0 = value;
      if (side == -1) g1 /= 2;
      side = -1;
    }
  }
  return b;
}

}  // namespace detail

/// Looks for the zeros of a function along a run, step by step. A zero where the run begins, to
/// within rounding of the time, is none of its zeros.
class ZeroSearch {
 public:
  /// `at_zero`: the run begins at a zero, whatever rounding left of it, and the function's sign is
  /// that to which it leaves; values up to `residue` are what a run that was made up to the zero
  /// left of it, and have none.
  void begin(bool at_zero = false, double residue = 0) {
    before_ = 0;
    fresh_ = true;
    flat_ = false;
    side_known_ = at_zero;
    rest_ = rounding_ = 0;
    residue_ = residue;
  }
  /// The run begins beside a zero on a known side, 1 or -1: to leave it for the other is a zero.
  void begin_beside(int side, double residue = 0) {
    begin(true, residue);
    before_ = side;
  }

  /// The function rests at its zero while it is no larger than this, which is what rounding makes
  /// of it: no zero of it is one.
  void rest_within(double size) { rest_ = size; }
  /// Values no larger than this are of rounding alone, as those of v - u just after v = u, and have
  /// no sign.
  void round_within(double size) { rounding_ = size; }

  /// The zeros of g in (a, b], where its values at the ends are ga and gb: found(Zero) of each in
  /// its order, until that returns true. g may return NaN where it has no value. Does not allocate.
  template <class G, class Found>
  bool operator()(G&& g, double a, double ga, double b, double gb, Found&& found) {
    if (rest_ > 0) {
      const double largest = std::max({std::abs(ga), std::abs(g(a + (b - a) / 2)), std::abs(gb)});
      if (largest <= rest_) return false;
      rest_ = 0;
    }
    const bool unknown = fresh_ && !side_known_;
    if (unknown) before_ = ga;
    const double none_until = unknown ? a + 64 * std::numeric_limits<double>::epsilon() *
                                                std::max(std::abs(a), std::abs(b))
                                      : a - 1;
    fresh_ = false;
    const auto later = [&](const Zero& zero) { return zero.t > none_until && found(zero); };
    std::array<Part, most_depth + 2> parts{};
    std::size_t count = 0;
    parts[count++] = {a, ga, b, gb};
    int unsure = 0, halved = 0;
    double scale = -1;
    while (count > 0) {
      const Part part = parts[--count];
      detail::ZeroValues v{};
      const detail::ZeroFit fit = look(g, part, v);
      if (scale < 0) scale = fit.largest;
      const bool sure = fit.excludes() || fit.monotone();
      const double middle = part.at(detail::zero_degree / 2);
      const bool short_part = !(part.a < middle && middle < part.b) || count >= most_depth;
      const bool flat = !sure && (short_part || std::max(-fit.low, fit.high) < rounding_ ||
                                  (fit.noise && fit.largest <= 1e-12 * scale));
      if (!sure && !flat && ++unsure <= most_unsure && ++halved <= most_halved) {
        parts[count++] = {middle, v[detail::zero_degree / 2], part.b, part.g1};
        parts[count++] = {part.a, part.g0, middle, v[detail::zero_degree / 2]};
        continue;
      }
      if (visit(g, part, flat, count == 0, later)) return true;
      if (sure) unsure = 0;
    }
    return false;
  }

 private:
  static constexpr std::size_t most_depth = 46;
  /// Parts that are halved one after the other, and in a step: there are more where noise alone
  /// is left of the function.
  static constexpr int most_unsure = 400, most_halved = 20'000;
  struct Part {
    double a = 0, g0 = 0, b = 0, g1 = 0;
    double at(std::size_t node) const { return a + detail::zero_nodes[node] * (b - a); }
  };

  /// Fills v with values on the part, of which the middle one is always taken.
  template <class G>
  static detail::ZeroFit look(G& g, const Part& part, detail::ZeroValues& v) {
    v = {};
    v.front() = part.g0, v.back() = part.g1;
    for (const std::size_t k : {4, 2, 6}) v[k] = g(part.at(k));
    const detail::ZeroFit fit = detail::zero_fit<2>(v);
    if (fit.excludes()) return fit;
    for (const std::size_t k : {1, 3, 5, 7}) v[k] = g(part.at(k));
    return detail::zero_fit<1>(v);
  }

  /// A part with one sign change at most, after those before it.
  template <class G, class Found>
  bool visit(G& g, const Part& part, bool flat, bool last, Found& found) {
    if (flat) {
      if (!flat_) flat_from_ = part.a, flat_value_ = part.g0;
      flat_to_ = part.b;
      flat_ = true;
      // A function that reaches zero at the end of a step has a zero there.
      if (!last || before_ == 0 || part.g1 != 0) return false;
    }
    const double now = part.g1;
    if ((now == 0 && !last) || (residue_ > 0 && std::abs(now) <= residue_)) return false;
    residue_ = 0;
    const bool was_flat = std::exchange(flat_, false);
    const double before = before_;
    before_ = now;
    if (!(before != 0) || !std::isfinite(now)) {
      if (!std::isfinite(now)) before_ = before;
      return false;
    }
    if (now == 0 || (now > 0) != (before > 0)) {
      const double from = was_flat ? flat_from_ : part.a, value = was_flat ? flat_value_ : part.g0;
      const bool inside = value != 0 && (value > 0) == (before > 0);
      const double t = inside ? detail::sign_change(g, from, value, part.b, now) : from;
      return found(Zero{t, before < 0 ? 1 : -1});
    }
    return was_flat && found(Zero{flat_from_ + (flat_to_ - flat_from_) / 2, 0});
  }

  double before_ = 0;  ///< the last value that is not zero to within rounding, or 0
  double flat_from_ = 0, flat_value_ = 0, flat_to_ = 0;
  bool side_known_ = false, fresh_ = true, flat_ = false;
  double rest_ = 0;      ///< see rest_within
  double rounding_ = 0;  ///< see round_within
  double residue_ = 0;   ///< until it has left the zero that it began at
};

}  // namespace odeum
