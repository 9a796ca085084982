// SPDX-License-Identifier: BSD-3-Clause
// What surfaces that meet add to the cost of a step.
#include <fmt/format.h>

#include "goals.hpp"
#include "odeum/cases/scene_case.hpp"
#include "odeum/scene/read/reader.hpp"

namespace odeum::bench {
namespace {

/// 64 x 64 particles of which one half lies on the other, 8 mm above it and sinking.
scene::Scene folded(bool contact) {
  scene::Scene scene =
      scene::read_scene(
          "folded.yaml",
          fmt::format(
              "duration: 0.05\nsolver: {{type: rk4, timestep: 0.0005}}\ncloth: [{{rows: 64, "
              "columns: 64, row_edge: [1, 0, 0], column_edge: [0, 1, 0], mass: 0.4, "
              "structural: {{stiffness: 100}}, shear: {{stiffness: 60}}, "
              "bend: {{stiffness: 1}}{}}}]\n",
              contact ? ", self_contact: {thickness: 0.01, stiffness: 40}" : ""))
          .scene;
  for (scene::Particle& particle : scene.particles) {
    double& x = particle.position[0];
    if (x <= 0.5) continue;
    x = 1.001 - x;
    particle.position[1] += 0.003;
    particle.position[2] = 0.008;
    particle.velocity[2] = -0.3;
  }
  return scene;
}

}  // namespace

std::vector<Row> contact_rows() {
  std::vector<Row> rows;
  for (const auto& [method, steps, goal] : {std::tuple{"rk4", std::uint64_t{100}, 3.0},
                                            {"velocity_verlet", std::uint64_t{100}, 3.0},
                                            {"implicit_euler_linearised", std::uint64_t{5}, 3.0}}) {
    const auto runner = [&, method = method, steps = steps](bool contact) {
      const auto problem = std::make_shared<const scene::SceneProblem>(folded(contact));
      return [problem, steps, method] {
        Request request{.steps = steps, .stops = {0.0005 * static_cast<double>(steps)}};
        cases::enroll_scene(problem).find(std::string("odeum/") + method)->solve(request);
      };
    };
    const auto t = interleave({runner(false), runner(true)}, 3);
    Row row = compare(fmt::format("64 x 64, half of it in contact: {}", method), goal, t[0], t[1],
                      fmt::format("{:.3g} / {:.3g} ms a step", 1e3 * t[1].min / double(steps),
                                  1e3 * t[0].min / double(steps)));
    row.at_most = true;
    rows.push_back(row);
  }
  return rows;
}

}  // namespace odeum::bench
