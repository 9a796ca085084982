// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <arb.h>

#include <cstddef>
#include <utility>

#include "odeum/formula/operations.hpp"

/// Real numbers as balls: a midpoint and a radius that holds every rounding (F. Johansson, Arb:
/// efficient arbitrary-precision midpoint-radius interval arithmetic, IEEE Trans. Comput. 66,
/// 2017).
namespace odeum::truth {

/// A number of which Odeum knows that it lies within. Whole numbers and double are exact; a long
/// double stands for a constant that was read or folded: with more digits than float has it may
/// be off by four roundings.
class Ball {
 public:
  static constexpr slong bits = 120;  ///< of midpoints: the most that need no memory of their own

  Ball() { arb_init(x_); }
  Ball(int whole) : Ball() { arb_set_si(x_, whole); }  // as numbers do, without a cast
  explicit Ball(std::size_t whole) : Ball() { arb_set_ui(x_, whole); }
  explicit Ball(double exact) : Ball() { arb_set_d(x_, exact); }
  explicit Ball(long double constant) : Ball(static_cast<double>(constant)) {
    const auto high = static_cast<double>(constant);
    *this = *this + Ball(static_cast<double>(constant - high));
    if (static_cast<long double>(static_cast<float>(constant)) != constant)
      *this = *this * (1 + Ball::around(0x1p-62));
  }
  Ball(const Ball& other) : Ball() { arb_set(x_, other.x_); }
  Ball(Ball&& other) noexcept : Ball() { arb_swap(x_, other.x_); }
  Ball& operator=(const Ball& other) {
    arb_set(x_, other.x_);
    return *this;
  }
  Ball& operator=(Ball&& other) noexcept {
    arb_swap(x_, other.x_);
    return *this;
  }
  ~Ball() { arb_clear(x_); }

  /// [-radius, radius]
  static Ball around(double radius) {
    Ball result;
    arb_add_error_2exp_si(result.x_, 0);
    return result * Ball(radius);
  }

  arb_ptr get() { return x_; }
  arb_srcptr get() const { return x_; }
  double middle() const { return arf_get_d(arb_midref(x_), ARF_RND_NEAR); }
  double radius() const { return mag_get_d(arb_radref(x_)); }
  bool finite() const { return arb_is_finite(x_) != 0; }
  bool holds(const Ball& other) const { return arb_contains(x_, other.x_) != 0; }
  Ball midpoint() const {
    Ball result;
    arb_get_mid_arb(result.x_, x_);
    return result;
  }
  /// An upper bound of the numbers' size, and a lower one.
  double largest() const { return size_by(arb_get_mag); }
  double least() const { return size_by(arb_get_mag_lower); }

  friend Ball operator+(const Ball& a, const Ball& b) { return of(arb_add, a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return of(arb_sub, a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return of(arb_mul, a, b); }
  friend Ball operator/(const Ball& a, const Ball& b) { return of(arb_div, a, b); }
  friend Ball operator-(const Ball& a) {
    Ball result;
    arb_neg(result.x_, a.x_);
    return result;
  }
  Ball& operator+=(const Ball& other) {
    arb_add(x_, x_, other.x_, bits);
    return *this;
  }

  /// The value of a function of one or two arguments.
  static Ball of(void (*function)(arb_t, const arb_struct*, const arb_struct*, slong),
                 const Ball& a, const Ball& b) {
    Ball result;
    function(result.x_, a.x_, b.x_, bits);
    return result;
  }
  static Ball of(void (*function)(arb_t, const arb_struct*, slong), const Ball& a) {
    Ball result;
    function(result.x_, a.x_, bits);
    return result;
  }

 private:
  double size_by(void (*bound)(mag_t, const arb_struct*)) const {
    mag_t size;
    mag_init(size);
    bound(size, x_);
    const double result = mag_get_d(size);
    mag_clear(size);
    return result;
  }

  arb_t x_;
};

/// sum_{j = from}^{k} a_j b_{k - j}, in place of that of formula/series_rules.hpp.
inline Ball convolution(const Ball* a, const Ball* b, std::size_t from, std::size_t k) {
  static_assert(sizeof(Ball) == sizeof(arb_struct));
  Ball sum;
  if (from <= k)
    arb_dot(sum.get(), nullptr, 0, a[from].get(), 1, b[k - from].get(), -1,
            static_cast<slong>(k - from + 1), Ball::bits);
  return sum;
}

/// The value of an operation without kinks, as formula::apply(); not finite outside of its domain.
inline Ball apply(formula::Op op, const Ball& a, const Ball& b, int /*none*/) {
  using formula::Op;
  static constexpr std::pair<Op, void (*)(arb_t, const arb_struct*, slong)> functions[] = {
      {Op::sin, arb_sin},   {Op::cos, arb_cos},   {Op::tan, arb_tan},   {Op::asin, arb_asin},
      {Op::acos, arb_acos}, {Op::atan, arb_atan}, {Op::sinh, arb_sinh}, {Op::cosh, arb_cosh},
      {Op::tanh, arb_tanh}, {Op::exp, arb_exp},   {Op::log, arb_log},   {Op::sqrt, arb_sqrt}};
  switch (op) {
    case Op::negate:
      return -a;
    case Op::log10:
      return Ball::of(arb_log, a) / Ball::of(arb_log, 10);
    case Op::add:
      return a + b;
    case Op::subtract:
      return a - b;
    case Op::multiply:
      return a * b;
    case Op::divide:
      return a / b;
    case Op::power:
      return Ball::of(arb_pow, a, b);
    case Op::atan2:  // not across its jump
      if (arb_is_positive(b.get()) || !arb_contains_zero(a.get())) return Ball::of(arb_atan2, a, b);
      return Ball::of(arb_log, -1);
    case Op::hypot:
      return Ball::of(arb_sqrt, a * a + b * b);
    default:
      for (const auto& [each, function] : functions)
        if (each == op) return Ball::of(function, a);
      return Ball::of(arb_log, -1);  // no number
  }
}

}  // namespace odeum::truth
