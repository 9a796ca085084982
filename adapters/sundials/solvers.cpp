// SPDX-License-Identifier: BSD-3-Clause
#include "sundials/solvers.hpp"

#include <iterator>
#include <utility>

#include "sundials/ida.hpp"
#include "sundials/session.hpp"

namespace odeum::adapters::sundials {
namespace {

const std::vector<Method>& all_methods() {
  static const std::vector<Method> all = [] {
    std::vector<Method> list;
    for (const auto part : {cvode_methods, cvode_held_methods, arkode_explicit_methods,
                            arkode_implicit_methods, arkode_imex_methods}) {
      std::vector<Method> more = part();
      std::move(more.begin(), more.end(), std::back_inserter(list));
    }
    return list;
  }();
  return all;
}

/// The implicit part in place of the right-hand side, with its Jacobian, or with differences of it.
void take_implicit_part(OdeView& view) {
  view.rhs = view.implicit_part;
  view.jacobian = view.implicit_jacobian;
  view.jacobian_entries = nullptr;
  view.jacobian_times = nullptr;
  view.shifted_solver = nullptr;
}

void enroll(const Method& method, ErasedContest contest, Entrant& entrant) {
  if (method.split) {
    entrant.unfit = "needs " + method.info.needs;
    if (!contest.view.explicit_part || !contest.view.implicit_part) return;
    entrant.unfit.clear();
    take_implicit_part(contest.view);
  }
  entrant.solve = [&method, contest = std::move(contest)](const Request& request) {
    return solve(method, contest, request);
  };
}

}  // namespace

void add_solvers(std::vector<Solver>& all) {
  for (const Method& method : all_methods())  // they live as long as the program
    all.push_back({method.info, [&method](const ErasedContest& contest, Entrant& entrant) {
                     enroll(method, contest, entrant);
                   }});
  add_ida(all);
}

}  // namespace odeum::adapters::sundials
