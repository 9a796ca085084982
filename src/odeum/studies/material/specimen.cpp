// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "odeum/studies/material/material.hpp"

namespace odeum::study {
namespace {

double angle_of(const Specimen& specimen) {
  return std::numbers::pi / static_cast<double>(2 * specimen.masses + 1);
}

}  // namespace

double Specimen::frequency() const {
  return 2 * std::sqrt(stiffness / mass) * std::sin(angle_of(*this) / 2);
}

double Specimen::damping_ratio() const { return damping * frequency() / (2 * stiffness); }

std::vector<double> Specimen::shape() const {
  std::vector<double> shape;
  for (std::size_t i = 1; i <= masses; ++i)
    shape.push_back(std::sin(static_cast<double>(i) * angle_of(*this)));
  const double lowest = shape.back();
  for (double& x : shape) x /= lowest;
  return shape;
}

double Specimen::sag() const {
  const auto n = static_cast<double>(masses);
  return mass * gravity / stiffness * n * (n + 1) / 2;
}

scene::Scene Specimen::scene() const {
  scene::Scene scene;
  scene.gravity = {0, -gravity, 0};
  double sum = 0;
  for (std::size_t i = 0; i <= masses; ++i) {
    // Spring i bears the weight of the masses below it.
    if (i > 0) sum += mass * gravity / stiffness * static_cast<double>(masses - i + 1);
    scene.particles.push_back({.position = {0, -static_cast<double>(i) * length - sum, 0},
                               .mass = mass,
                               .fixed = i == 0});
    if (i > 0)
      scene.springs.push_back(
          {.a = i - 1, .b = i, .stiffness = stiffness, .damping = damping, .rest_length = length});
  }
  return scene;
}

Specimen one_mass() { return {.name = "one_mass", .masses = 1}; }
Specimen hanging_chain() { return {.name = "hanging_chain", .masses = 10}; }

}  // namespace odeum::study
