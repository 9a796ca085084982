// SPDX-License-Identifier: BSD-3-Clause
#include "support/scene_stage.hpp"

#include "support/stage.hpp"

namespace odeum::cases {
namespace {

/// A scene with what only the compiler can be told.
template <bool Damped>
struct StagedScene {
  static constexpr std::size_t dimension = dynamic;
  static constexpr bool velocity_dependent = Damped;
  std::shared_ptr<const scene::SceneProblem> scene;

  std::size_t size() const { return scene->size(); }
  void acceleration(double, const double* q, const double* v, double* a) const {
    scene->acceleration(q, v, a);
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, size() / 2, t, y, dydt);
  }
  void jacobian_times(double, const double* y, const double* x, double* product) const {
    scene->jacobian_times(y, x, product);
  }
  std::unique_ptr<ShiftedSolver> shifted_solver() const { return scene->shifted_solver(); }
};

template <bool Damped>
std::vector<Entrant> enroll_staged(const std::shared_ptr<const scene::SceneProblem>& problem) {
  Contest<StagedScene<Damped>> contest;
  contest.problem = std::make_shared<const StagedScene<Damped>>(StagedScene<Damped>{problem});
  contest.y0 = {problem, &problem->start()};
  contest.scene = problem->plain_scene();
  return enroll(erase(contest));
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
    require_sound(request, 0);
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
  std::vector<Entrant> entrants =
      problem->structure().separable ? enroll_staged<false>(problem) : enroll_staged<true>(problem);
  entrants.push_back(closed_form(problem));
  return entrants;
}

}  // namespace odeum::cases
