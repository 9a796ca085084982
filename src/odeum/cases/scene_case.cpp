// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/scene_case.hpp"

#include "odeum/cases/stage.hpp"

namespace odeum::cases {
namespace {

ErasedContest stage_of(const std::shared_ptr<const scene::SceneProblem>& problem) {
  Contest<scene::SceneProblem> contest;
  contest.problem = problem;
  contest.y0 = {problem, &problem->start()};
  contest.scene = problem->plain_scene();
  return erase(contest);
}

// The exact motion in closed form, as a solver without steps.
Entrant closed_form(const std::shared_ptr<const scene::SceneProblem>& problem) {
  Entrant entrant{.info = {}, .unfit = {}, .solve = {}};
  entrant.info.library = "odeum";
  entrant.info.method = "closed_form";
  entrant.info.family = "exact";
  entrant.info.adaptive = true;
  entrant.info.controller = "none: exact at any time";
  entrant.info.needs = "free particles under a constant force";
  entrant.info.source = "q = q0 + v0 t + g t^2 / 2";
  if (!problem->structure().closed_form) {
    entrant.unfit = "needs " + entrant.info.needs;
    return entrant;
  }
  entrant.solve = [problem](const Request& request) {
    require_sound(request, 0, problem->size());
    Outcome outcome;
    std::vector<double> y(problem->size());
    for (const double t : request.stops) {
      problem->closed_form(t, problem->start().data(), y.data());
      outcome.record(t, y.data(), y.size());
    }
    return outcome;
  };
  return entrant;
}

}  // namespace

Entrants enroll_scene(const std::shared_ptr<const scene::SceneProblem>& problem) {
  Entrants entrants = enroll(stage_of(problem));
  entrants.add(closed_form(problem));
  return entrants;
}

}  // namespace odeum::cases
