// SPDX-License-Identifier: BSD-3-Clause
// What surfaces that meet add to the cost of a step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "goals.hpp"
#include "odeum/cases/scene_case.hpp"
#include "odeum/scene/read/reader.hpp"

namespace odeum::bench {
namespace {

/// A sheet of 64 x 64 particles.
scene::Scene sheet(bool contact) {
  return scene::read_scene(
             "sheet.yaml",
             fmt::format(
                 "duration: 0.05\nsolver: {{type: rk4, timestep: 0.0005}}\ncloth: [{{rows: 64, "
                 "columns: 64, row_edge: [1, 0, 0], column_edge: [0, 1, 0], mass: 0.4, "
                 "structural: {{stiffness: 100}}, shear: {{stiffness: 60}}, "
                 "bend: {{stiffness: 1}}{}}}]\n",
                 contact ? ", self_contact: {thickness: 0.01, stiffness: 40}" : ""))
      .scene;
}

/// One half lies on the other, 8 mm above it and sinking: all particles are in contact, each with a
/// dozen triangles and pairs of edges.
scene::Scene folded(bool contact) {
  scene::Scene scene = sheet(contact);
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

/// The last fifth is turned over, and its end meets what is below it: one particle in seven is in
/// contact.
scene::Scene turned_over(bool contact) {
  scene::Scene scene = sheet(contact);
  constexpr double bend = 0.8, radius = 0.02, arc = std::numbers::pi * radius, low = 0.008;
  for (scene::Particle& particle : scene.particles) {
    const double beyond = particle.position[0] - bend;
    if (beyond <= 0) continue;
    particle.position[1] += 0.003;
    if (beyond < arc) {
      particle.position[0] = bend + radius * std::sin(beyond / radius);
      particle.position[2] = radius * (1 - std::cos(beyond / radius));
      continue;
    }
    const double along = std::min(1.0, (beyond - arc) / 0.11);
    particle.position[0] = bend - 0.96 * (beyond - arc);
    particle.position[2] = 2 * radius - (2 * radius - low) * along * along * (3 - 2 * along);
    particle.velocity[2] = -0.3 * along;
  }
  return scene;
}

}  // namespace

std::vector<Row> contact_rows() {
  std::vector<Row> rows;
  for (const auto& [state, make] :
       {std::pair{"a seventh of it", &turned_over}, {"all of it", &folded}})
    for (const auto& [method, steps] :
         {std::pair{"rk4", 100}, {"velocity_verlet", 100}, {"implicit_euler_linearised", 5}}) {
      const auto runner = [&, make = make, steps = steps, method = method](bool contact) {
        const auto problem = std::make_shared<const scene::SceneProblem>(make(contact));
        return [problem, steps, method] {
          Request request{.steps = static_cast<std::uint64_t>(steps), .stops = {0.0005 * steps}};
          cases::enroll_scene(problem).find(std::string("odeum/") + method)->solve(request);
        };
      };
      const auto t = interleave({runner(false), runner(true)}, 3);
      Row row = compare(
          fmt::format("64 x 64, {} in contact: {}", state, method), 3, t[0], t[1],
          fmt::format("{:.3g} / {:.3g} ms a step", 1e3 * t[1].min / steps, 1e3 * t[0].min / steps));
      row.at_most = true;
      rows.push_back(row);
    }
  return rows;
}

}  // namespace odeum::bench
