// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/model/scene_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/scene/model/momentum.hpp"

namespace odeum::scene {
namespace {

bool for_mass_spring(const DescribedSpring& spring) { return !spring.axial || spring.damping == 0; }

// Adds the derivative times a direction, block by block.
class ProductSink final : public BlockSink {
 public:
  ProductSink(const double* dq, const double* dv, const Bodies& bodies, double* product)
      : dq_(dq), dv_(dv), bodies_(bodies), product_(product) {}
  void add(std::size_t i, std::size_t j, const Mat3& by_position,
           const Mat3& by_velocity) override {
    for (std::size_t r = 0; r < 3; ++r) {
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c)
        sum += by_position[3 * r + c] * dq_[3 * j + c] + by_velocity[3 * r + c] * dv_[3 * j + c];
      product_[3 * i + r] += bodies_.inverse_mass[i] * sum;
    }
  }

 private:
  const double *dq_, *dv_;
  const Bodies& bodies_;
  double* product_;
};

}  // namespace

SceneProblem::SceneProblem(const Description& description) : gravity_(description.gravity) {
  for (const DescribedParticle& particle : description.particles) {
    bodies_.mass.push_back(particle.mass);
    bodies_.inverse_mass.push_back(particle.fixed ? 0 : 1 / particle.mass);
    bodies_.radius.push_back(particle.radius);
    start_.insert(start_.end(), particle.position.begin(), particle.position.end());
  }
  for (const DescribedParticle& particle : description.particles)
    for (const double component : particle.velocity)
      start_.push_back(particle.fixed ? 0 : component);
  add_springs(description);
  for (const UniformForce& force : description.forces)
    terms_.push_back(make_uniform_force(bodies_, force));
  const bool round = std::any_of(bodies_.radius.begin(), bodies_.radius.end(),
                                 [](double radius) { return radius > 0; });
  for (const Contact& contact : description.contacts)
    if (round || !std::holds_alternative<ParticleContact>(contact))  // points never touch
      terms_.push_back(make_contact(bodies_, contact));
  describe(description);
}

void SceneProblem::add_springs(const Description& description) {
  Scene scene;
  scene.gravity = gravity_;
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    const DescribedParticle& particle = description.particles[i];
    scene.particles.push_back({.position = particle.position,
                               .velocity = particle.fixed ? Vec3{} : particle.velocity,
                               .mass = particle.fixed ? 1 : particle.mass,
                               .fixed = particle.fixed});
  }
  std::vector<DescribedSpring> axial;
  for (const DescribedSpring& spring : description.springs) {
    if (for_mass_spring(spring))
      scene.springs.push_back({.a = spring.a,
                               .b = spring.b,
                               .stiffness = spring.stiffness,
                               .damping = spring.damping,
                               .rest_length = spring.rest_length,
                               .tension_only = spring.tension_only});
    else
      axial.push_back(spring);
  }
  if (!scene.springs.empty()) springs_.emplace(scene);
  if (!axial.empty()) terms_.push_back(make_axial_springs(bodies_, std::move(axial)));
  if (terms_.empty() && description.forces.empty() && description.contacts.empty())
    plain_ = std::make_shared<const Scene>(std::move(scene));
}

void SceneProblem::describe(const Description& description) {
  Structure& s = structure_;
  s.particles = bodies_.size();
  for (const double inverse : bodies_.inverse_mass) s.fixed += inverse == 0;
  if (gravity_ != Vec3{})
    s.terms.push_back({.name = "gravity",
                       .law = "m g",
                       .count = s.particles - s.fixed,
                       .unit = "particles",
                       .linear = true});
  if (springs_) {
    TermInfo info{.name = "springs",
                  .law = "k (l - L) u + d (v_b - v_a)",
                  .count = springs_->springs().size(),
                  .unit = "springs",
                  .linear = true};
    for (const Spring& spring : springs_->springs()) {
      info.velocity_dependent |= spring.damping != 0;
      info.linear &= spring.rest_length == 0 && !spring.tension_only;
      info.smooth &= !spring.tension_only;
    }
    if (!info.velocity_dependent) info.law = "k (l - L) u";
    s.terms.push_back(info);
    if (const auto* grid = springs_->grid())
      s.kernel = fmt::format("gather on the regular {} x {} grid", grid->layout().rows,
                             grid->layout().columns);
    else
      s.kernel = "edge list";
  }
  for (const auto& term : terms_) {
    s.terms.push_back(term->info());
    names_.push_back(s.terms.back().name);
    if (names_.back() == "springs_axial")
      s.kernel += s.kernel.empty() ? "edge list" : ", and an edge list for axial damping";
  }
  if (s.kernel.empty()) s.kernel = "none: no springs";
  s.separable = s.linear = true;
  for (const TermInfo& info : s.terms) {
    s.separable &= !info.velocity_dependent;
    s.linear &= info.linear;
    s.smooth &= info.smooth;
  }
  s.closed_form = description.springs.empty() && terms_.empty();
}

void SceneProblem::acceleration(const double* q, const double* v, double* a) const {
  if (!v) v = q;  // undamped: any finite numbers do
  if (springs_) {
    springs_->acceleration(0, q, v, a);
    if (tally_) tally_->add("springs", springs_->springs().size());
  } else {
    for (std::size_t i = 0; i < bodies_.size(); ++i)
      for (std::size_t d = 0; d < 3; ++d) a[3 * i + d] = bodies_.free(i) ? gravity_[d] : 0;
  }
  for (std::size_t k = 0; k < terms_.size(); ++k) {
    const std::uint64_t interactions = terms_[k]->add(q, v, a);
    if (tally_) tally_->add(names_[k], interactions);
  }
}

void SceneProblem::jacobian_times(const double* y, const double* x, double* product) const {
  const std::size_t n = 3 * particles();
  if (springs_) {
    springs_->jacobian_times(0, y, x, product);
  } else {
    std::copy(x + n, x + 2 * n, product);
    std::fill(product + n, product + 2 * n, 0.0);
  }
  ProductSink sink(x, x + n, bodies_, product + n);
  for (const auto& term : terms_) term->add_blocks(y, y + n, sink);
}

void SceneProblem::blocks(const double* q, const double* v, BlockSink& sink) const {
  if (springs_)
    for (const Spring& spring : springs_->springs()) {
      const Mat3 x = spring_stiffness_block(spring, q);
      const double d = spring.damping;
      Mat3 minus_x;
      for (std::size_t k = 0; k < 9; ++k) minus_x[k] = -x[k];
      const Mat3 y{d, 0, 0, 0, d, 0, 0, 0, d}, minus_y{-d, 0, 0, 0, -d, 0, 0, 0, -d};
      sink.add(spring.a, spring.b, x, y);
      sink.add(spring.b, spring.a, x, y);
      sink.add(spring.a, spring.a, minus_x, minus_y);
      sink.add(spring.b, spring.b, minus_x, minus_y);
    }
  for (const auto& term : terms_) term->add_blocks(q, v, sink);
}

double SceneProblem::kinetic(const double* y) const {
  const double* const v = y + 3 * particles();
  double sum = 0;
  for (std::size_t i = 0; i < particles(); ++i)
    if (bodies_.free(i))
      for (std::size_t d = 0; d < 3; ++d) sum += bodies_.mass[i] * v[3 * i + d] * v[3 * i + d] / 2;
  return sum;
}

double SceneProblem::potential(const double* y) const {
  double sum = 0;
  if (gravity_ != Vec3{})
    for (std::size_t i = 0; i < particles(); ++i)
      if (bodies_.free(i))
        for (std::size_t d = 0; d < 3; ++d) sum -= bodies_.mass[i] * gravity_[d] * y[3 * i + d];
  if (springs_)
    for (const Spring& spring : springs_->springs()) {
      const double *a = y + 3 * spring.a, *b = y + 3 * spring.b;
      const double stretch = std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]) - spring.rest_length;
      if (stretch > 0 || !spring.tension_only) sum += spring.stiffness * stretch * stretch / 2;
    }
  for (const auto& term : terms_) sum += term->potential(y);
  return sum;
}

Vec3 SceneProblem::momentum(const double* y) const { return linear_momentum(bodies_.mass, y); }

Vec3 SceneProblem::angular_momentum(const double* y) const {
  return scene::angular_momentum(bodies_.mass, y);
}

void SceneProblem::closed_form(double t, const double* y0, double* y) const {
  const std::size_t n = 3 * particles();
  for (std::size_t k = 0; k < n; ++k) {
    const double g = bodies_.free(k / 3) ? gravity_[k % 3] : 0;
    y[k] = y0[k] + t * (y0[n + k] + t * g / 2);
    y[n + k] = y0[n + k] + t * g;
  }
}

}  // namespace odeum::scene
