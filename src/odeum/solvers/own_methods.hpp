// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>
#include <vector>

#include "odeum/solvers/solver.hpp"

namespace odeum {

/// A file of methods/ with its types erased. CMake generates a unit for each of them (see
/// odeum_generate_methods), in which it is compiled for the shared types: a method that is added or
/// changed is compiled there and nowhere else.
struct OwnMethod {
  SolverInfo info;
  /// Fills `unfit`, or `solve` and what else the method can do on this problem.
  void (*enroll)(const ErasedContest& contest, Entrant& entrant) = nullptr;
};

/// Every own method, by id.
const std::vector<OwnMethod>& own_methods();

/// What the file of one of them says.
const SolverInfo& own_info(std::string_view method);

/// An entrant for each own method: those that fit can solve, the others say what they need.
inline std::vector<Entrant> enroll_own(const ErasedContest& contest) {
  std::vector<Entrant> entrants;
  for (const OwnMethod& method : own_methods()) {
    entrants.push_back({.info = method.info, .unfit = {}, .solve = {}});
    method.enroll(contest, entrants.back());
  }
  return entrants;
}

}  // namespace odeum
