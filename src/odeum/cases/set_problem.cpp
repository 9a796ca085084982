// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/set_problem.hpp"

#include "odeum/isolated/loaded_processes.hpp"
#include "odeum/solvers/own_methods.hpp"
#include "odeum/solvers/runtime_library.hpp"
#include "odeum_adapters_solvers.hpp"  // generated: solvers.hpp of every library that is built in

namespace odeum {

const std::vector<Solver>& all_solvers() {
  static const std::vector<Solver> all = [] {
    std::vector<Solver> list = own_methods();
#define ODEUM_ITEM(library) adapters::library::add_solvers(list);
#include "lists/adapters_solvers.inc"  // generated: those libraries
#undef ODEUM_ITEM
    for (const RuntimeLibrary& library : runtime_libraries())
      list.insert(list.end(), library.solvers.begin(), library.solvers.end());
    return list;
  }();
  return all;
}

namespace cases {

Entrants enroll(const ErasedContest& contest, const Entrants::Finish& also) {
  return {all_solvers(), contest, [t0 = contest.t0, n = contest.view.dimension, also](Entrant& e) {
            if (!e.solve) return;
            e.solve = [t0, n, solve = std::move(e.solve)](const Request& request) {
              require_sound(request, t0, n);
              return solve(request);
            };
            if (also) also(e);
          }};
}

Entrants enroll_unchanging(const ErasedContest& contest, const Entrants::Finish& also) {
  return enroll(contest, [also](Entrant& e) {
    e.solve = [solve = std::move(e.solve)](const Request& request) {
      const isolated::Unchanging unchanging;
      return solve(request);
    };
    if (also) also(e);
  });
}

}  // namespace cases
}  // namespace odeum
