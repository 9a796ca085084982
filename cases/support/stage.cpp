// SPDX-License-Identifier: BSD-3-Clause
#include "support/stage.hpp"

#include "odeum/contest/own_on_shared.hpp"
#include "odeum_adapters.hpp"  // generated: odeum::enroll_adapters, every library that is built in

namespace odeum::cases {
namespace {

template <Shared P>
std::vector<Entrant> enroll_as(const ErasedContest& erased) {
  Contest<P> contest;
  contest.problem = std::make_shared<const P>(erased.view, erased.keep_alive);
  contest.t0 = erased.t0;
  contest.y0 = erased.y0;
  contest.scene = erased.scene;
  std::vector<Entrant> entrants;
  enroll_own(contest, entrants);
  enroll_adapters(contest, entrants);
  return entrants;
}

}  // namespace

std::vector<Entrant> enroll(const ErasedContest& contest) {
  std::vector<Entrant> entrants = !contest.view.second_order() ? enroll_as<SharedOde>(contest)
                                  : contest.view.velocity_dependent
                                      ? enroll_as<SharedSecondOrder>(contest)
                                      : enroll_as<SharedSeparable>(contest);
  for (Entrant& entrant : entrants) {
    if (!entrant.solve) continue;
    entrant.solve = [t0 = contest.t0, solve = std::move(entrant.solve)](const Request& request) {
      require_sound(request, t0);
      return solve(request);
    };
  }
  return entrants;
}

}  // namespace odeum::cases
