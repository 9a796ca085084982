// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

#include "odeum/formula/graph.hpp"

/// Residuals R(t, y, y') = 0 as an ordinary problem.
namespace odeum::formula {

/// In residuals the rate of state k is the state of this number plus k.
inline constexpr std::uint32_t first_rate = 1'000'000;

/// A residual that has no rate in it, or a sum of multiples of residuals from which the rates
/// vanish.
struct Constraint {
  Id value = no_node;
  std::set<std::size_t> of;  ///< the residuals, by their place in the list
  std::size_t own = 0;       ///< the one among them that it may stand in place of
  int level = 0;             ///< how often that was differentiated for it; 0: it is not hidden
};

/// How often a constraint is differentiated at most, until the rates of all states follow.
inline constexpr int highest_index = 3;

/// What follows from residuals.
struct Reduction {
  std::vector<Id> rates;                ///< by state, of t and y
  std::vector<Constraint> constraints;  ///< by their level
  std::vector<std::size_t> by;  ///< by state: the residual that gives its rate, or whose derivative
                                ///< does
  int index = 0;                ///< 0: there are no constraints
};

/// Why there is none: `residual` is the place in the list of the one that is to blame.
class ReductionError : public std::runtime_error {
 public:
  ReductionError(std::size_t residual, const std::string& what)
      : std::runtime_error(what), residual_(residual) {}
  std::size_t residual() const { return residual_; }

 private:
  std::size_t residual_;
};

/// The rates that occur in a residual other than linearly: no symbols solve for them.
std::set<std::uint32_t> nonlinear_rates(Graph& graph, const std::vector<Id>& residuals);

/// The same expressions with other nodes in place of states, of which a map has the number.
std::vector<Id> with_states_replaced(Graph& graph, const std::vector<Id>& roots,
                                     const std::map<std::uint32_t, Id>& by);

/// Solves residuals that are linear in the rates of the states `names` for these: those with rates
/// by elimination, constraints by differentiation along the solution. A derivative without rates is
/// a hidden constraint, which is differentiated again (Hairer, Wanner, Solving ODEs II, VII.1).
/// Whether a factor is zero is decided by values in extended precision at (t, y) and nearby. Throws
/// ReductionError where the index is above highest_index, a residual follows from others or
/// contradicts them, or a rate is multiplied by zero at (t, y); without `is_start`, nearby, too.
Reduction reduce(Graph& graph, const std::vector<Id>& residuals,
                 const std::vector<std::string>& names, long double t,
                 const std::vector<long double>& y, bool is_start = true);

/// The index of each state, see ImplicitForm. Of one with a rate of its own by the first constraint
/// which it is in, of those that hidden ones follow from, of others by the last; these have the
/// same in one constraint.
std::vector<int> indices_of(const Reduction& reduction, const Graph& graph);

}  // namespace odeum::formula
