// SPDX-License-Identifier: BSD-3-Clause
// Forces on pairs of particles and on particles that are listed one by one.
#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <utility>

#include "odeum/scene/model/spring_law.hpp"
#include "odeum/scene/model/terms.hpp"

namespace odeum::scene {
namespace {

class PairGravitation final : public Term {
 public:
  explicit PairGravitation(std::vector<Gravitation> pairs) : pairs_(std::move(pairs)) {}

  TermInfo info(const Bodies&) const override {
    return {
        .name = "gravitation", .law = "G m_a m_b / r^2", .count = pairs_.size(), .unit = "pairs"};
  }
  void add(const Bodies& bodies, const double* q, const double*, double* force) const override {
    for (const Gravitation& pair : pairs_) {
      const auto x = difference(q + 3 * pair.a, q + 3 * pair.b);
      const double length = length_of(x), f = product(bodies, pair) / (length * length * length);
      for (std::size_t d = 0; d < 3; ++d) {
        force[3 * pair.a + d] += f * x[d];
        force[3 * pair.b + d] -= f * x[d];
      }
    }
  }
  // The derivative of the force on a with respect to the position of b is G m_a m_b (I - 3 u u^T) /
  // l^3.
  void add_blocks(const Bodies& bodies, const double* q, const double*,
                  BlockSink& sink) const override {
    for (const Gravitation& pair : pairs_) {
      const auto x = difference(q + 3 * pair.a, q + 3 * pair.b);
      const double length = length_of(x), f = product(bodies, pair) / (length * length * length);
      Mat3 by_position;
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
          by_position[3 * i + j] = f * ((i == j ? 1 : 0) - 3 * (x[i] / length) * (x[j] / length));
      sink.add_pair(pair.a, pair.b, by_position, Mat3{});
    }
  }
  double potential(const Bodies& bodies, const double* q) const override {
    double sum = 0;
    for (const Gravitation& pair : pairs_)
      sum -= product(bodies, pair) / length_of(difference(q + 3 * pair.a, q + 3 * pair.b));
    return sum;
  }

 private:
  static double product(const Bodies& bodies, const Gravitation& pair) {
    return pair.constant * bodies.mass[pair.a] * bodies.mass[pair.b];
  }
  std::vector<Gravitation> pairs_;
};

class ParticleDrag final : public Term {
 public:
  struct One {
    std::size_t particle;
    double coefficient;
  };
  explicit ParticleDrag(std::vector<One> all) : all_(std::move(all)) {}

  TermInfo info(const Bodies&) const override {
    return {.name = "particle_drag",
            .law = "-c v",
            .count = all_.size(),
            .unit = "particles",
            .velocity_dependent = true,
            .linear = true};
  }
  void add(const Bodies&, const double*, const double* v, double* force) const override {
    for (const auto& [i, c] : all_)
      for (std::size_t d = 0; d < 3; ++d) force[3 * i + d] -= c * v[3 * i + d];
  }
  void add_blocks(const Bodies&, const double*, const double*, BlockSink& sink) const override {
    for (const auto& [i, c] : all_) sink.add(i, i, Mat3{}, {-c, 0, 0, 0, -c, 0, 0, 0, -c});
  }

 private:
  std::vector<One> all_;
};

}  // namespace

std::unique_ptr<Term> make_gravitation(const Scene& scene) {
  if (scene.gravitations.empty()) return nullptr;
  for (const Gravitation& g : scene.gravitations)
    if (g.a >= scene.size() || g.b >= scene.size() || g.a == g.b)
      throw std::invalid_argument(
          fmt::format("gravitation between particles {} and {} of {}", g.a, g.b, scene.size()));
  return std::make_unique<PairGravitation>(scene.gravitations);
}

std::unique_ptr<Term> make_particle_drag(const Scene& scene) {
  std::vector<ParticleDrag::One> all;
  for (std::size_t i = 0; i < scene.size(); ++i)
    if (scene.particles[i].drag != 0 && !scene.particles[i].fixed)
      all.push_back({i, scene.particles[i].drag});
  if (all.empty()) return nullptr;
  return std::make_unique<ParticleDrag>(std::move(all));
}

}  // namespace odeum::scene
