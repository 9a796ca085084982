// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "odeum/solvers/settings.hpp"

/// What a solve will cost, by the costs of coarser settings.
namespace odeum::study {

/// The cost of a solve, in the units of a budget.
struct Cost {
  double setting;  ///< number of steps, or 1 / tolerance
  double work;
};

/// A lower bound of the next setting's cost, extrapolated from the last ones; 0 where unknown.
double foreseen_work(const std::vector<Cost>& coarser, const Request& next);

/// The costs of a solver's settings, from coarse to fine.
class Foreseen {
 public:
  /// A setting that was solved; `ns` where the time counts too.
  void add(const Request& request, std::uint64_t work, double ns = 0);
  /// See foreseen_work, in evaluations and products.
  double work(const Request& next) const { return foreseen_work(work_, next); }
  bool empty() const { return work_.empty(); }
  /// Why the next one is not run; empty: it may be within its budget.
  std::string excess(const Request& next) const;

 private:
  std::vector<Cost> work_, ns_;
};

}  // namespace odeum::study
