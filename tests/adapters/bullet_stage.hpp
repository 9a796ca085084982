// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <complex>
#include <stdexcept>

#include "bullet/solvers.hpp"
#include "odeum/scene/model/scene.hpp"
#include "support/enrolled.hpp"

namespace odeum::bullet_tests {

/// A case for engines, which use only the dimension of the problem.
template <std::size_t N>
struct Unseen {
  static constexpr std::size_t dimension = N;
  void rhs(double, const double*, double* dydt) const { dydt[0] = std::nan(""); }
};

/// The solvers of the adapter on a scene that a test may change afterwards.
struct Stage {
  std::shared_ptr<scene::Scene> scene;
  std::vector<Entrant> entrants;

  const Entrant& operator[](const std::string& method) const {
    for (const Entrant& entrant : entrants)
      if (entrant.info.method == method) return entrant;
    throw std::invalid_argument("no entry " + method);
  }
};

template <std::size_t N>
Stage stage(const scene::Scene& scene, const std::array<double, N>& y0) {
  Stage result{std::make_shared<scene::Scene>(scene), {}};
  Contest<Unseen<N>> contest;
  contest.problem = std::make_shared<const Unseen<N>>();
  contest.y0 = std::make_shared<const std::vector<double>>(y0.begin(), y0.end());
  contest.scene = result.scene;
  result.entrants = tests::enrolled_on(erase(contest), adapters::bullet::add_solvers);
  return result;
}

/// A spring of rest length 0 is linear at any stretch, for Bullet's links too.
inline Stage oscillator(double damping = 0, double rest_length = 0) {
  scene::Scene scene;
  scene.particles = {{.fixed = true}, {.position = {1, 0, 0}, .mass = 2}};
  scene.springs = {
      {.a = 0, .b = 1, .stiffness = 10, .damping = damping, .rest_length = rest_length}};
  scene.select = {3, 9};
  return stage<2>(scene, {1, 0});
}

inline Stage free_fall() {
  scene::Scene scene;
  scene.particles = {{.mass = 0.5}};
  scene.gravity = {-9.81, 0, 0};
  scene.select = {0, 3};
  return stage<2>(scene, {10, 3});
}

inline Stage medium(std::complex<double> lambda) {
  scene::Scene scene;
  scene.particles = {{.velocity = {1, 0, 0}, .mass = 3}};
  scene.velocity_matrix = {lambda.real(), -lambda.imag(), 0, lambda.imag(), lambda.real()};
  scene.select = {3, 4};
  return stage<2>(scene, {1, 0});
}

inline Request steps(std::uint64_t count, std::vector<double> stops) {
  Request request;
  request.steps = count;
  request.stops = std::move(stops);
  return request;
}

/// Unequal masses and lengths, damping between free particles, gravity, in three dimensions.
inline scene::Scene chain() {
  scene::Scene scene;
  scene.gravity = {0, -9.8, 0};
  scene.particles = {{.position = {0, 0, 0}, .mass = 1, .fixed = true},
                     {.position = {1, 0, 0.5}, .velocity = {0, 1, 2}, .mass = 2},
                     {.position = {2, 0.5, 0}, .velocity = {1, 0, 0}, .mass = 0.5}};
  scene.springs = {{.a = 0, .b = 1, .stiffness = 30, .damping = 0.4, .rest_length = 1},
                   {.a = 2, .b = 1, .stiffness = 30, .damping = 0.4, .rest_length = 0.8}};
  return scene;
}

inline std::array<double, 18> state_of(const scene::Scene& scene) {
  std::array<double, 18> y{};
  for (std::size_t i = 0; i < 9; ++i) {
    y[i] = scene.particles[i / 3].position[i % 3];
    y[9 + i] = scene.particles[i / 3].velocity[i % 3];
  }
  return y;
}

}  // namespace odeum::bullet_tests
