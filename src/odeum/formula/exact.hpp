// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "odeum/formula/evaluator.hpp"
#include "odeum/formula/problem.hpp"

namespace odeum::formula {

/// The values of a graph's definitions where its parameters have these.
std::vector<long double> definitions_of(const Graph& graph,
                                        const std::map<std::string, long double>& parameters);

/// Far above the rounding of extended precision, also where terms cancel; far below what a wrong
/// digit of a formula leaves.
inline constexpr long double agreement = 1e-11L;

/// The closed form of a problem, held against its equations. Not for two threads at once.
class Exact {
 public:
  /// `exact` must not be empty; its derivatives are added to the graph.
  explicit Exact(Problem& problem);
  /// Sets the definitions of a problem whose parameters kept their names.
  void define(const std::vector<long double>& definitions);

  /// Where the formula is not the solution.
  struct Flaw {
    std::size_t state = 0;
    bool initial =
        false;  ///< not the initial value; else its derivative is not that of the equation
    long double got = 0, expected = 0;
  };
  /// The flaw at t of a solution from t0 to `end`; nothing where there is none.
  std::optional<Flaw> flaw_at(long double t, long double t0, long double end);
  /// The state at the time of the last flaw_at.
  const long double* state() const { return y_.data(); }

 private:
  /// The rounding of the equations at the state of the last flaw_at.
  std::vector<long double> rounding_at(long double t) const;

  std::size_t n_;
  Evaluator<long double> solution_, equations_;  ///< solution: state, its derivative, the start
  std::vector<long double> y_, f_;
};

}  // namespace odeum::formula
