// SPDX-License-Identifier: BSD-3-Clause
#include "cloth_stage.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "odeum/cases/set_problem.hpp"
#include "odeum/cases/square_cloth.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/studies/scene_stage.hpp"

namespace odeum::bench {

PlainCloth::PlainCloth(const scene::Scene& scene) : springs(scene.springs) {
  for (const auto& p : scene.particles)
    particles.push_back({{p.position[0], p.position[1], p.position[2]},
                         {p.velocity[0], p.velocity[1], p.velocity[2]},
                         {}});
}

void PlainCloth::forces() {
  for (Particle& p : particles) p.f[0] = p.f[1] = p.f[2] = 0;
  for (const scene::Spring& s : springs) {
    Particle &a = particles[s.a], &b = particles[s.b];
    const double u[3] = {b.x[0] - a.x[0], b.x[1] - a.x[1], b.x[2] - a.x[2]};
    const double length = std::sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    const double pull = s.stiffness * (1 - s.rest_length / length);
    for (int d = 0; d < 3; ++d) {
      const double f = pull * u[d] + s.damping * (b.v[d] - a.v[d]);
      a.f[d] += f;
      b.f[d] -= f;
    }
  }
}

namespace {

/// The plain loop as a problem, for libraries.
struct PlainProblem {
  static constexpr std::size_t dimension = dynamic;
  std::shared_ptr<PlainCloth> cloth;
  std::vector<double> inverse_mass;
  scene::Vec3 gravity;

  std::size_t size() const { return 6 * inverse_mass.size(); }
  void rhs(double, const double* y, double* dydt) const {
    const std::size_t n = inverse_mass.size();
    for (std::size_t i = 0; i < 3 * n; ++i) {
      cloth->particles[i / 3].x[i % 3] = y[i];
      cloth->particles[i / 3].v[i % 3] = dydt[i] = y[3 * n + i];
    }
    cloth->forces();
    for (std::size_t i = 0; i < 3 * n; ++i)
      dydt[3 * n + i] =
          inverse_mass[i / 3] != 0
              ? cloth->particles[i / 3].f[i % 3] * inverse_mass[i / 3] + gravity[i % 3]
              : 0;
  }
};

}  // namespace

ClothStage::ClothStage(std::size_t n, double stiffness, Forces forces)
    : scene_(std::make_shared<const scene::Scene>(cases::square_cloth(n, stiffness))) {
  case_.id = "bench";
  case_.y0 = scene::start_of(*scene_);
  if (forces == Forces::grid) {
    cases::set_problem(case_, scene::SceneProblem(*scene_), scene_);
    return;
  }
  PlainProblem problem{std::make_shared<PlainCloth>(*scene_), {}, scene_->gravity};
  for (const auto& p : scene_->particles) problem.inverse_mass.push_back(p.fixed ? 0 : 1 / p.mass);
  cases::set_problem(case_, problem);
}

const Entrant& ClothStage::solver(const std::string& id) const {
  for (const Entrant& entrant : case_.entrants)
    if (entrant.info.id() == id && entrant.solve) return entrant;
  throw std::runtime_error("no solver " + id);
}

std::vector<double> ClothStage::run(const std::string& id, Request request) const {
  request.budget.watched = false;
  request.budget.evaluations = 1'000'000'000;
  Outcome outcome = solver(id).solve(request);
  if (outcome.status != Status::ok) throw std::runtime_error(id + ": " + outcome.detail);
  return std::move(outcome.states);
}

std::vector<double> ClothStage::fixed(const std::string& id, double t, std::uint64_t steps,
                                      const Variant& options) const {
  Request request;
  request.mode = Mode::fixed;
  request.stops = {t};
  request.steps = steps;
  request.options = options;
  return run(id, request);
}

std::vector<double> ClothStage::adaptive(const std::string& id, double t, double tolerance) const {
  Request request;
  request.mode = Mode::adaptive;
  request.stops = {t};
  request.tolerance = tolerance;
  return run(id, request);
}

std::vector<double> ClothStage::truth(double t) const {
  std::vector<double> truth = adaptive("odeum/dormand_prince853", t, 1e-11);
  if (!(distance(truth, adaptive("odeum/gragg_bulirsch_stoer", t, 1e-10)) < 1e-9))
    throw std::runtime_error("two methods disagree about the truth");
  return truth;
}

double ClothStage::distance(const std::vector<double>& a, const std::vector<double>& b) const {
  return study::rms_distance(a, b, scene_->size());
}

}  // namespace odeum::bench
