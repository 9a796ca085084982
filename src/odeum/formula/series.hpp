// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/formula/graph.hpp"

namespace odeum::formula {

/// How the Taylor coefficients of the nodes of y' = f(t, y) follow from one another. For sums,
/// products and quotients there are rules; a function w of a, b has w' = w_a a' + w_b b' with its
/// partial derivatives, which are nodes too (Griewank, Walther, Evaluating Derivatives, chapter
/// 13).
struct SeriesPlan {
  struct Part {
    std::uint32_t argument, partial;  ///< positions in `steps`
  };
  struct Step {
    Op op;
    Id id;
    std::uint32_t a = 0, b = 0;  ///< positions of the arguments; a: the index of a state
    std::vector<Part> parts;     ///< of a function
  };
  std::vector<Step> steps;
  std::vector<std::uint32_t> roots;

  /// A power with a constant exponent has a rule of its own, which knows the base 0.
  static bool has_power_rule(const Step& step) {
    return step.op == Op::power && step.parts.empty();
  }
};

/// The plan for some equations without kinks.
SeriesPlan make_series_plan(Graph& graph, const std::vector<Id>& equations);

/// Fills c[k * states + i] with coefficient k = 0, ..., order of state i through y at t. Real is
/// double or long double. For one thread.
template <class Real>
class Series {
 public:
  Series(const Graph& graph, SeriesPlan plan, std::size_t states);
  void operator()(Real t, const Real* y, int order, Real* c);

 private:
  void advance(std::size_t k, std::size_t width);

  SeriesPlan plan_;
  std::size_t states_;
  std::vector<Real> constants_, v_;
};
extern template class Series<double>;
extern template class Series<long double>;

}  // namespace odeum::formula
