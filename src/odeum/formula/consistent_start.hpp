// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

#include "odeum/formula/graph.hpp"

/// Start values that fulfil constraints, in extended precision.
namespace odeum::formula {

/// The values of some expressions and their gradients by some states, at a time and a state.
struct Linearised {
  std::vector<long double> values;
  std::vector<std::vector<long double>> slopes;  ///< by expression
  std::vector<long double> sizes;  ///< sum of |slope by a state times that state|, over all states
};
Linearised linearise(Graph& graph, const std::vector<Id>& roots, long double t,
                     const std::vector<long double>& y, const std::vector<std::size_t>& by);

/// Newton's method for the zeros of as many expressions as there are states `unknown`, from their
/// values in y on; of more expressions the method of Gauss and Newton, whose result need not be a
/// zero of all. False where it does not converge.
bool find_roots(Graph& graph, const std::vector<Id>& roots, long double t,
                std::vector<long double>& y, const std::vector<std::size_t>& unknown);

}  // namespace odeum::formula
