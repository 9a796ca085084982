// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/solvers/solver.hpp"

namespace odeum::report {

/// Solvers that one column of a table stands for: a family of own methods, or a library.
struct SolverGroup {
  std::string title;
  bool own = false;
  std::vector<const SolverInfo*> solvers = {};
};

/// Every solver in one group: own ones by family, families of one or two methods together as
/// "other"; then the peers, a group a library. Points into `solvers`.
std::vector<SolverGroup> make_groups(const std::vector<SolverInfo>& solvers);

}  // namespace odeum::report
