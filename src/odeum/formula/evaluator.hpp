// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "odeum/formula/graph.hpp"

namespace odeum::formula {

/// The values of some nodes at a time and a state, one operation after the other: what runs where
/// there is no compiler. Real is double or long double.
template <class Real>
class Evaluator {
 public:
  Evaluator(const Graph& graph, const std::vector<Id>& roots);
  /// Fills out[k] with the value of root k.
  void operator()(Real t, const Real* y, Real* out) const;
  /// Replaces each constant c by moved(c).
  void perturb(const std::function<Real(Real)>& moved);
  /// Gives constants with a name these values, by the number of their definition.
  void define(const std::vector<Real>& values);

 private:
  struct Step {
    Op op;
    std::uint32_t a, b, c;  ///< positions of the arguments; a: the index of a state or constant
    Real value;             ///< of a constant
  };
  std::vector<Step> steps_;
  std::vector<std::uint32_t> roots_;
};
extern template class Evaluator<double>;
extern template class Evaluator<long double>;

}  // namespace odeum::formula
