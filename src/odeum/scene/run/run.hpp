// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "odeum/core/outcome.hpp"
#include "odeum/scene/model/emission.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/surface/passing.hpp"

/// Runs a scene from its start to an end: one solve, or with emitters one solve between any two
/// successive births or deaths.
namespace odeum::scene {

struct RunSetting {
  Mode mode = Mode::fixed;
  std::uint64_t steps = 0;    ///< fixed: of the whole run
  Tolerance tolerance = 0;    ///< adaptive: the absolute one is one for all
  double until = 0;           ///< s
  double frame_interval = 0;  ///< s; at a fixed step frames are kept at the nearest whole step
  Budget budget = {};         ///< of the whole run
};

/// The scene at one time.
struct Frame {
  double t = 0;
  std::vector<std::size_t> ids;  ///< of the particles that exist, in the order of the state
  std::vector<double> y;
  double kinetic = 0, potential = 0;  ///< J
  Vec3 momentum{}, angular_momentum{};
};

/// What the surfaces of a run did, between states that are `apart` from each other in time: the
/// ends of its steps where these are fixed and not too many to keep.
struct Contacts {
  double apart = 0;          ///< s; 0: the scene has no surfaces
  Touching deepest;          ///< of all states
  double deepest_at = 0;     ///< s
  std::size_t passed = 0;    ///< pairs that passed through each other
  double first_passed = 0;   ///< the end of the first step in which one did, s
  SurfacePair first_pair{};  ///< that one
};

struct RunResult {
  Status status = Status::ok;
  std::string detail;
  double t = 0;  ///< reached
  Counters counters;
  std::size_t solves = 0, births = 0, deaths = 0;
  Contacts contacts;
  std::vector<Frame> frames;  ///< the first at 0, the last at `t` where the status is ok
};

/// Solves a problem from its start at time 0.
using Solve = std::function<Outcome(const std::shared_ptr<const SceneProblem>&, const Request&)>;

/// At a fixed step, births and deaths take effect at the end of the step in which they fall. A
/// method that is not self-starting is restarted in each solve.
RunResult run_scene(const Scene& scene, const RunSetting& setting, const Solve& solve);

/// The scene's own frame interval, or the default: 60 a second, at least 100 and at most 1000 in
/// all. Throws std::length_error where a run until then emits a million particles from one emitter
/// or keeps more than 2e8 numbers.
double frame_interval(const Scene& scene, double until);

}  // namespace odeum::scene
