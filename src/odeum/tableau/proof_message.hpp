// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>

/// What the compiler's message says where a proof of coefficients fails: types that are
/// instantiated only then, and whose arguments are the facts.
namespace odeum {

/// A rooted tree as a type: the subtrees of its root; tree<> is the single node.
template <class... Subtrees>
struct tree {};

/// The tree with another subtree at its root.
template <class... Subtrees, class Subtree>
constexpr tree<Subtrees..., Subtree> graft(tree<Subtrees...>, Subtree) {
  return {};
}

/// A velocity at a node of a Nystroem tree.
struct velocity {};

/// The tree at place `Index` of a table of rooted trees, see RootedTrees; what a table of Nystroem
/// trees has after the last of them is the velocity.
template <const auto& Trees, std::size_t Index>
constexpr auto tree_at() {
  if constexpr (Index == 0)
    return tree<>{};
  else if constexpr (Index == Trees.count)
    return velocity{};
  else
    return graft(tree_at<Trees, Trees.left[Index]>(), tree_at<Trees, Trees.right[Index]>());
}

/// digits * 10^exponent.
struct Decimal {
  int digits = 0, exponent = 0;
};

/// A finite number to three digits.
constexpr Decimal three_digits(double x) {
  Decimal result;
  const auto size = [&] { return x < 0 ? -x : x; };
  if (x == 0) return result;
  for (; size() >= 999.5; ++result.exponent) x /= 10;
  for (; size() < 99.95; --result.exponent) x *= 10;
  result.digits = static_cast<int>(x < 0 ? x - 0.5 : x + 0.5);
  return result;
}

/// A row of weights: of a Runge-Kutta or Rosenbrock method (`further`: one beside its tableau,
/// `dense`: those of its interpolant), of a Nystroem method, of a splitting.
enum class WeightRow { b, b_hat, further, dense, b_q, b_v, b_q_hat, b_v_hat, drift };

template <WeightRow row, int order, class RootedTree, Decimal residual>
struct OrderConditionFails {
  static_assert(order == 0,
                "the row of weights does not meet the condition of this order on this rooted tree; "
                "the residual is its left-hand side less its right-hand side");
};

template <WeightRow row, int order>
struct HasHigherOrderThanStated {
  static_assert(order == 0, "the row of weights meets every condition of this order as well");
};

/// Whether there is no fault (order 0). Where there is one the compiler's message names it.
template <WeightRow row, int order, class RootedTree, Decimal residual>
consteval bool no_fault() {
  if constexpr (order != 0 && residual.digits == 0)
    (void)HasHigherOrderThanStated<row, order>{};
  else if constexpr (order != 0)
    (void)OrderConditionFails<row, order, RootedTree, residual>{};
  return order == 0;
}

}  // namespace odeum
