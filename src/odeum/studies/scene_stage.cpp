// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/scene_stage.hpp"

#include <cmath>

#include "odeum/cases/set_problem.hpp"
#include "odeum/core/glob.hpp"
#include "odeum/scene/problem/scene_problem.hpp"

namespace odeum::study {

SceneStage::SceneStage(const scene::Scene& scene)
    : y0(std::make_shared<std::vector<double>>(scene::start_of(scene))) {
  Contest<scene::SceneProblem> contest;
  contest.problem = std::make_shared<const scene::SceneProblem>(scene);
  contest.y0 = y0;
  contest.scene = std::make_shared<const scene::Scene>(scene);
  entrants = cases::enroll(erase(contest));
}

bool is_compared(const SolverInfo& info, const Options& options) {
  return info.common_use == CommonUse::engine && any_glob_matches(options.solvers, info.id());
}

double rms_distance(const std::vector<double>& a, const std::vector<double>& b,
                    std::size_t particles) {
  double sum = 0;
  for (std::size_t i = 0; i < 3 * particles; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / static_cast<double>(particles));
}

}  // namespace odeum::study
