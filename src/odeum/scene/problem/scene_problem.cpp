// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/problem/scene_problem.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "odeum/linear/conjugate_gradients.hpp"
#include "odeum/scene/model/momentum.hpp"
#include "odeum/scene/model/spring_law.hpp"
#include "odeum/scene/surface/surface_term.hpp"

namespace odeum::scene {
namespace {

/// The springs with axial damping, or the others.
std::vector<Spring> springs_of(const Scene& scene, bool axial) {
  std::vector<Spring> result;
  for (const Spring& spring : scene.springs)
    if (axial == (spring.axial && spring.damping != 0)) result.push_back(spring);
  return result;
}

void require_sound(const Scene& scene) {
  if (scene.velocity_matrix != Mat3{})
    throw std::invalid_argument("a scene problem has no velocity_matrix");
  for (const Particle& particle : scene.particles) {
    if (!particle.fixed && !(particle.mass > 0))
      throw std::invalid_argument("a free particle needs a positive mass");
    if (particle.fixed && particle.velocity != Vec3{})
      throw std::invalid_argument("a fixed particle has no velocity");
  }
  for (const Spring& s : scene.springs)
    if (s.a >= scene.size() || s.b >= scene.size() || s.a == s.b)
      throw std::invalid_argument(
          fmt::format("spring between particles {} and {} of {}", s.a, s.b, scene.size()));
}

/// Calls work(arrays, entries of each, array of the result) with vectors of the particles in the
/// layout of a grid.
template <class Work>
void on_grid(const GridLayout& layout, std::initializer_list<const double*> vectors, double* result,
             const Work& work) {
  // One for each thread, since threads share the problem, and for each kind of work, which has
  // always as many vectors.
  thread_local std::vector<double> space;
  thread_local GridLayout last;
  const std::size_t n = 3 * layout.size;
  if (layout != last) {
    // What another grid left in the margins of this one may not be finite.
    space.assign((vectors.size() + 1) * n, 0);
    last = layout;
  }
  double* array = space.data();
  for (const double* const vector : vectors) layout.scatter(vector, array), array += n;
  work(space.data(), n, array);
  layout.gather(array, result);
}

/// Adds the derivatives times a direction.
class ProductSink final : public BlockSink {
 public:
  ProductSink(const double* dq, const double* dv, double* product)
      : dq_(dq), dv_(dv), product_(product) {}
  void add(std::size_t i, std::size_t j, const Mat3& by_position,
           const Mat3& by_velocity) override {
    for (std::size_t r = 0; r < 3; ++r)
      for (std::size_t c = 0; c < 3; ++c)
        product_[3 * i + r] +=
            by_position[3 * r + c] * dq_[3 * j + c] + by_velocity[3 * r + c] * dv_[3 * j + c];
  }

 private:
  const double *dq_, *dv_;
  double* product_;
};

}  // namespace

SceneProblem::SceneProblem(const Scene& scene, std::vector<Lifetime> lives)
    : gravity_(scene.gravity),
      start_(start_of(scene)),
      springs_("springs", springs_of(scene, false)),
      scene_(std::make_shared<const Scene>(scene)),
      lives_(std::move(lives)) {
  require_sound(scene);
  bool any_radius = false;
  for (const Particle& particle : scene.particles) {
    bodies_.mass.push_back(particle.mass);
    bodies_.inverse_mass.push_back(particle.fixed ? 0 : 1 / particle.mass);
    bodies_.radius.push_back(particle.radius);
    any_radius |= particle.radius > 0;
  }
  if (const auto found = find_grid(scene.particles, springs_.springs()))
    grid_.emplace(scene, *found);
  if (auto axial = springs_of(scene, true); !axial.empty())
    terms_.push_back(std::make_unique<EdgeSprings>("springs_axial", std::move(axial)));
  for (auto* const make : {make_gravitation, make_particle_drag})
    if (auto term = make(scene)) terms_.push_back(std::move(term));
  for (const UniformForce& force : scene.forces) terms_.push_back(make_uniform_force(force));
  for (const Contact& contact : scene.contacts)
    if (any_radius || !std::holds_alternative<ParticleContact>(contact))  // points never touch
      terms_.push_back(make_contact(contact));
  if (!scene.surfaces.empty()) terms_.push_back(make_surface_contact(scene));
  describe(scene);
}

void SceneProblem::describe(const Scene& scene) {
  Structure& s = structure_;
  s.particles = bodies_.size(), s.fixed = bodies_.fixed();
  if (gravity_ != Vec3{})
    s.terms.push_back({.name = "gravity",
                       .law = "m g",
                       .count = s.particles - s.fixed,
                       .unit = "particles",
                       .linear = true});
  if (!springs().empty()) {
    s.terms.push_back(springs_.info(bodies_));
    s.kernel = grid_ ? fmt::format("gather on the regular {} x {} grid", grid_->layout().rows,
                                   grid_->layout().columns)
                     : "edge list";
  }
  for (const auto& term : terms_) {
    s.terms.push_back(term->info(bodies_));
    if (s.terms.back().name == "springs_axial")
      s.kernel += s.kernel.empty() ? "edge list" : ", and an edge list for axial damping";
  }
  if (s.kernel.empty()) s.kernel = "none: no springs";
  s.separable = s.linear = true;
  s.order_kept = lives_.empty() ? any_order : order_at_kinks;
  for (const TermInfo& info : s.terms) {
    s.separable &= !info.velocity_dependent;
    s.linear &= info.linear;
    s.order_kept = std::min(s.order_kept, info.order_kept);
  }
  s.closed_form = scene.springs.empty() && terms_.empty();
}

void SceneProblem::acceleration(double t, const double* q, const double* v, double* a) const {
  if (!v) v = q;  // no force depends on it: any finite numbers do
  if (grid_) {
    on_grid(grid_->layout(), {q, v}, a, [&](const double* gq, std::size_t n, double* force) {
      grid_->springs().forces(gq, gq + n, force, 0, grid_->layout().rows);
    });
  } else {
    std::fill_n(a, size() / 2, 0.0);
    springs_.add(bodies_, q, v, a);
  }
  for (const auto& term : terms_) term->add(bodies_, q, v, a);
  for (std::size_t i = 0; i < particles(); ++i) {
    const double free = bodies_.free(i) ? 1 : 0;
    for (std::size_t d = 0; d < 3; ++d)
      a[3 * i + d] = a[3 * i + d] * bodies_.inverse_mass[i] + free * gravity_[d];
    if (!acts(i, t)) std::fill_n(a + 3 * i, 3, 0.0);
  }
}

// The damping force vanishes with the velocities.
void SceneProblem::undamped_acceleration(double t, const double* q, double* a) const {
  if (!grid_) {
    const std::vector<double> at_rest(size() / 2);
    return acceleration(t, q, at_rest.data(), a);
  }
  on_grid(grid_->layout(), {q}, a, [&](const double* gq, std::size_t, double* ga) {
    grid_->undamped_acceleration(t, gq, ga);
  });
}

std::uint64_t SceneProblem::damp(double t, const double* q, double h, double* v,
                                 double relative) const {
  if (!grid_) return damp_edges(h, v, relative);
  const GridLayout& layout = grid_->layout();
  std::vector<double> gv(3 * layout.size);
  layout.scatter(v, gv.data());
  const std::uint64_t products = grid_->damp(t, q, h, gv.data(), relative);
  return layout.gather(gv.data(), v), products;
}

// v += x with (M - h/2 D) x = h D v, by conjugate gradients; fixed particles keep x = 0.
std::uint64_t SceneProblem::damp_edges(double h, double* v, double relative) const {
  const std::size_t n = size() / 2;
  std::vector<double> right(n), x(n), diagonal(n);
  const auto damping_times = [&](const double* w, double* product) {
    std::fill_n(product, n, 0.0);
    for (const Spring& s : springs())
      for (std::size_t d = 0; d < 3; ++d) {
        const double f = s.damping * (w[3 * s.b + d] - w[3 * s.a + d]);
        product[3 * s.a + d] += f, product[3 * s.b + d] -= f;
      }
    for (std::size_t i = 0; i < n; ++i)
      if (!bodies_.free(i / 3)) product[i] = 0;
  };
  for (std::size_t i = 0; i < n; ++i) diagonal[i] = bodies_.free(i / 3) ? bodies_.mass[i / 3] : 1;
  for (const Spring& s : springs())
    for (std::size_t d = 0; d < 3; ++d)
      for (const std::size_t end : {s.a, s.b}) diagonal[3 * end + d] += h / 2 * s.damping;
  damping_times(v, right.data());
  for (double& component : right) component *= h;
  linear::ConjugateGradients cg(n);
  cg.solve(
      [&](const double* w, double* product) {
        damping_times(w, product);
        for (std::size_t i = 0; i < n; ++i)
          product[i] = bodies_.mass[i / 3] * w[i] - h / 2 * product[i];
      },
      [&](const double* r, double* z) {
        for (std::size_t i = 0; i < n; ++i) z[i] = r[i] / diagonal[i];
      },
      right.data(), x.data(), relative);
  for (std::size_t i = 0; i < n; ++i) v[i] += x[i];
  return cg.products();
}

void SceneProblem::jacobian_times(double t, const double* y, const double* x,
                                  double* product) const {
  const std::size_t n = size() / 2;
  double* const change = product + n;
  std::copy_n(x + n, n, product);
  ProductSink sink(x, x + n, change);
  if (grid_) {
    on_grid(grid_->layout(), {y, x, x + n}, change,
            [&](const double* gq, std::size_t entries, double* derivative) {
              grid_->springs().derivative(gq, gq + entries, gq + 2 * entries, derivative, 0,
                                          grid_->layout().rows);
            });
  } else {
    std::fill_n(change, n, 0.0);
    springs_.add_blocks(bodies_, y, y + n, sink);
  }
  for (const auto& term : terms_) term->add_blocks(bodies_, y, y + n, sink);
  for (std::size_t i = 0; i < n; ++i) change[i] *= acts(i / 3, t) ? bodies_.inverse_mass[i / 3] : 0;
}

void SceneProblem::blocks(const double* q, const double* v, BlockSink& sink) const {
  springs_.add_blocks(bodies_, q, v, sink);
  for (const auto& term : terms_) term->add_blocks(bodies_, q, v, sink);
}

double SceneProblem::kinetic(const double* y) const {
  const double* const v = y + size() / 2;
  double sum = 0;
  for (std::size_t i = 0; i < size() / 2; ++i)
    if (bodies_.free(i / 3)) sum += bodies_.mass[i / 3] * v[i] * v[i] / 2;
  return sum;
}

double SceneProblem::potential(const double* y) const {
  double sum = 0;
  for (std::size_t i = 0; i < size() / 2; ++i)
    if (bodies_.free(i / 3)) sum -= bodies_.mass[i / 3] * gravity_[i % 3] * y[i];
  sum += springs_.potential(bodies_, y);
  for (const auto& term : terms_) sum += term->potential(bodies_, y);
  return sum;
}

Vec3 SceneProblem::momentum(const double* y) const { return linear_momentum(bodies_.mass, y); }

Vec3 SceneProblem::angular_momentum(const double* y) const {
  return scene::angular_momentum(bodies_.mass, y);
}

// The force acts for a time `under`, and `after` that the particle flies on.
void SceneProblem::closed_form(double t, const double* y0, double* y) const {
  const std::size_t n = size() / 2;
  for (std::size_t k = 0; k < n; ++k) {
    const Lifetime life = lives_.empty() ? Lifetime{} : lives_[k / 3];
    const double birth = std::max(life.birth, 0.0);
    const double under = std::clamp(t - birth, 0.0, life.death - birth);
    const double after = std::max(t - birth, 0.0) - under;
    const double g = bodies_.free(k / 3) ? gravity_[k % 3] : 0;
    y[k] = y0[k] + t * y0[n + k] + under * g * (under / 2 + after);
    y[n + k] = y0[n + k] + under * g;
  }
}

ExtendedProblem extended_problem(const Scene& scene) {
  using Real = ExtendedProblem::real;
  require_sound(scene);
  ExtendedProblem problem;
  const std::vector<double> start = start_of(scene);
  problem.y0.assign(start.begin(), start.end());
  problem.f = [scene](Real, const Real* y, Real* dydt) {
    const std::size_t n = 3 * scene.size();
    std::copy_n(y + n, n, dydt);
    Real* const a = dydt + n;
    std::fill_n(a, n, Real(0));
    add_spring_forces(scene.springs, y, y + n, a);
    for (std::size_t i = 0; i < n; ++i) {
      const Particle& particle = scene.particles[i / 3];
      a[i] = particle.fixed ? 0 : a[i] / particle.mass + scene.gravity[i % 3];
    }
  };
  return problem;
}

}  // namespace odeum::scene
