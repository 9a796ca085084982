// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/span.hpp"
#include "odeum/cases/text_truth.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/read/reader.hpp"
#include "odeum/solvers/entrants.hpp"

namespace odeum::cases {

/// Every solver, own and of each library, enrolled on a scene from its start at time 0; with
/// `odeum/closed_form` for free particles under a constant force.
Entrants enroll_scene(const std::shared_ptr<const scene::SceneProblem>& problem);

/// The problem of a scene whose number of particles stays the same until then: emitted ones are in
/// it from the start (scene/model/emission.hpp). Throws InputError where there are too many, and
/// where they could touch others.
std::shared_ptr<const scene::SceneProblem> whole_problem(const scene::Scene& scene, double until,
                                                         const std::string& file);

/// The exact states of a scene at the times (ascending, after 0): in closed form for free
/// particles, else a reference that two methods agree on (truth/scene_system.hpp), as far as they
/// do. `content` identifies the scene, since references are kept in the cache folder; `what` names
/// it.
TextTruth scene_truth(const std::shared_ptr<const scene::SceneProblem>& problem,
                      const std::vector<double>& times, const std::string& content,
                      const std::string& what, const TruthBounds& bounds = {});

/// A scene as a case, with its duration as the horizon and errors at four times of it, where `span`
/// does not say otherwise; in metres, the positions of free particles measured. `text` is that of
/// its file, by which its truth is kept. Making the case throws InputError, see whole_problem.
Statement scene_statement(std::string id, std::string file, std::string text, scene::Scene scene,
                          const Span& span = {});

/// The largest extent of the free and fixed particles' positions in a state, in m.
double extent_of(const double* y, std::size_t particles);

/// A scene of the project: a file of cases/scenes, built in.
struct SceneText {
  std::string_view name;  ///< the file's stem
  std::string_view text;
};
const std::vector<SceneText>& all_scenes();

}  // namespace odeum::cases
