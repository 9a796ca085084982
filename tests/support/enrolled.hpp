// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/solvers/solver.hpp"

namespace odeum::tests {

/// Every one of these solvers on a problem.
inline std::vector<Entrant> enrolled_on(const ErasedContest& contest,
                                        const std::vector<Solver>& solvers) {
  std::vector<Entrant> entrants;
  for (const Solver& solver : solvers) {
    entrants.push_back({.info = solver.info, .unfit = {}, .solve = {}});
    solver.enroll(contest, entrants.back());
  }
  return entrants;
}

/// The entrants that a library adds.
inline std::vector<Entrant> enrolled_on(const ErasedContest& contest,
                                        void (*add_solvers)(std::vector<Solver>&)) {
  std::vector<Solver> solvers;
  add_solvers(solvers);
  return enrolled_on(contest, solvers);
}

}  // namespace odeum::tests
