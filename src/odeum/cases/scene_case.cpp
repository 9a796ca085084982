// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/scene_case.hpp"

#include <stdexcept>

#include "odeum/cases/stage.hpp"
#include "odeum/solvers/own_methods.hpp"

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

std::vector<Entrant> enroll_scene(const std::shared_ptr<const scene::SceneProblem>& problem) {
  std::vector<Entrant> entrants = enroll(stage_of(problem));
  entrants.push_back(closed_form(problem));
  return entrants;
}

Entrant enroll_scene(const std::shared_ptr<const scene::SceneProblem>& problem,
                     const std::string& id) {
  if (id == "odeum/closed_form") return closed_form(problem);
  const ErasedContest contest = stage_of(problem);
  for (const OwnMethod& method : own_methods())
    if (method.info.id() == id) {
      Entrant entrant{.info = method.info, .unfit = {}, .solve = {}};
      method.enroll(contest, entrant);
      return entrant;
    }
  for (Entrant& entrant : enroll(contest))
    if (entrant.info.id() == id) return std::move(entrant);
  throw std::out_of_range("no solver " + id);
}

}  // namespace odeum::cases
