// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>

namespace odeum::formula {

/// Leaves, then the operations in the order of the table in operations.cpp.
enum class Op : std::uint8_t {
  constant,
  time,
  state,
  negate,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sinh,
  cosh,
  tanh,
  exp,
  log,
  log10,
  sqrt,
  floor,
  abs,
  side,  ///< 1 of a number from 0 on, -1 of one below: the derivative of abs, at 0 that to the
         ///< right
  sign,
  add,
  subtract,
  multiply,
  divide,
  less,
  less_equal,
  equal,
  power,
  atan2,
  hypot,
  min,
  max,
  choose  ///< of[0] != 0 ? of[1] : of[2]
};

/// What an operation on numbers a, b, c with the value w means.
struct Operation {
  const char* name;  ///< of a function in expressions; null: the operation has signs
  /// In C: {0}, {1} and {2} are the arguments; null: a call of the function of that name.
  const char* c;
  /// The derivatives by a and by b as expressions of a, b and w; null: zero, or there is none.
  std::array<const char*, 2> partials;
  bool has_kinks;  ///< the result has kinks or jumps where the arguments are smooth
  std::size_t arguments;
  double (*value)(double, double, double);
  long double (*extended)(long double, long double, long double);
};

inline constexpr std::size_t leaves = 3;  ///< operations without arguments, of no such meaning
inline bool is_leaf(Op op) { return static_cast<std::size_t>(op) < leaves; }

/// The meaning of an operation that is not a leaf.
const Operation& meaning_of(Op op);

inline std::size_t arity(Op op) { return is_leaf(op) ? 0 : meaning_of(op).arguments; }
inline bool has_kinks(Op op) { return !is_leaf(op) && meaning_of(op).has_kinks; }

/// The value of an operation; comparisons give 1 or 0. Real is double or long double.
inline double apply(Op op, double a, double b, double c) { return meaning_of(op).value(a, b, c); }
inline long double apply(Op op, long double a, long double b, long double c) {
  return meaning_of(op).extended(a, b, c);
}

}  // namespace odeum::formula
