// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/stage.hpp"

#include "odeum/solvers/own_methods.hpp"
#include "odeum/solvers/runtime_library.hpp"
#include "odeum/solvers/shared_contest.hpp"
#include "odeum_adapters_enroll.hpp"  // generated: enroll.hpp of every library that is built in

namespace odeum::cases {

std::vector<Entrant> enroll(const ErasedContest& contest) {
  std::vector<Entrant> entrants = enroll_own(contest);
  with_shared_type(contest.view, [&]<Shared P>() {
    [[maybe_unused]] const Contest<P> shared = shared_contest<P>(contest);
#define ODEUM_ITEM(library) adapters::library::enroll(shared, entrants);
#include "lists/adapters_enroll.inc"  // generated: those libraries
#undef ODEUM_ITEM
  });
  for (const RuntimeLibrary& library : runtime_libraries())
    if (library.enroll) library.enroll(contest, entrants);
  for (Entrant& entrant : entrants) {
    if (!entrant.solve) continue;
    entrant.solve = [t0 = contest.t0, n = contest.view.dimension,
                     solve = std::move(entrant.solve)](const Request& request) {
      require_sound(request, t0, n);
      return solve(request);
    };
  }
  return entrants;
}

}  // namespace odeum::cases
