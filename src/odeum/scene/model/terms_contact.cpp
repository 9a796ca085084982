// SPDX-License-Identifier: BSD-3-Clause
// Penalty contacts: with planes, with spheres, and between particles.
#include <cmath>

#include "odeum/scene/model/terms.hpp"

namespace odeum::scene {
namespace {

/// One contact: its depth (m), the unit normal that points out, and how that turns as the bodies
/// move (1 / distance of the centres; 0 for a plane).
struct Touch {
  double depth;
  double normal[3];
  double curvature;
};

/// Normal force and friction at a relative velocity v, and what their derivatives are made of:
///
///     N = max(0, k depth - c v.n),   F = N n - mu N s,   s = u / sqrt(|u|^2 + friction_speed^2),
///     u = v - (v.n) n.
struct Push {
  double n_force = 0, vn = 0, slide[3]{}, s[3]{}, root = 1;

  Push(const Penalty& law, const Touch& touch, const double* v) {
    for (int d = 0; d < 3; ++d) vn += v[d] * touch.normal[d];
    n_force = law.stiffness * touch.depth - law.damping * vn;
    if (!(n_force > 0)) n_force = 0;  // a contact never pulls
    double squared = friction_speed * friction_speed;
    for (int d = 0; d < 3; ++d) {
      slide[d] = v[d] - vn * touch.normal[d];
      squared += slide[d] * slide[d];
    }
    root = std::sqrt(squared);
    for (int d = 0; d < 3; ++d) s[d] = slide[d] / root;
  }

  void force(const Penalty& law, const Touch& touch, double* f) const {
    for (int d = 0; d < 3; ++d) f[d] = n_force * (touch.normal[d] - law.friction * s[d]);
  }

  // dF/dx = (n - mu s) (dN/dx)^T + N P / r - mu N S du/dx and dF/dv = (n - mu s) (dN/dv)^T -
  // mu N S P, with P = I - n n^T, S = (I - s s^T) / root, 1/r the curvature, dn/dx = P / r,
  // dN/dx = -k n - c u / r, dN/dv = -c n, du/dx = -(n u^T + (v.n) P) / r.
  void derivatives(const Penalty& law, const Touch& touch, Mat3& by_x, Mat3& by_v) const {
    const double* const n = touch.normal;
    const double r1 = touch.curvature, mu = law.friction;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) {
        const double p = (i == j ? 1 : 0) - n[i] * n[j];
        const double lead = n[i] - mu * s[i];
        double s_du = 0, s_p = 0;
        for (int k = 0; k < 3; ++k) {
          const double s_ik = ((i == k ? 1 : 0) - s[i] * s[k]) / root;
          const double p_kj = (k == j ? 1 : 0) - n[k] * n[j];
          s_du -= s_ik * (n[k] * slide[j] + vn * p_kj) * r1;
          s_p += s_ik * p_kj;
        }
        by_x[3 * i + j] = lead * (-law.stiffness * n[j] - law.damping * slide[j] * r1) +
                          n_force * (p * r1 - mu * s_du);
        by_v[3 * i + j] = -lead * law.damping * n[j] - mu * n_force * s_p;
      }
  }
};

// Two centres a vector x apart, to be kept `reach` from each other.
bool touch_round(const double* x, double reach, Touch& touch) {
  const double squared = x[0] * x[0] + x[1] * x[1] + x[2] * x[2];
  if (!(squared < reach * reach) || squared == 0) return false;  // at one place: no direction
  const double distance = std::sqrt(squared);
  touch.depth = reach - distance;
  touch.curvature = 1 / distance;
  for (int d = 0; d < 3; ++d) touch.normal[d] = x[d] * touch.curvature;
  return true;
}

bool touch_surface(const PlaneContact& plane, const double* q, double radius, Touch& touch) {
  double distance = 0;
  for (std::size_t d = 0; d < 3; ++d) distance += (q[d] - plane.point[d]) * plane.normal[d];
  touch.depth = radius - distance;
  if (!(touch.depth > 0)) return false;
  for (std::size_t d = 0; d < 3; ++d) touch.normal[d] = plane.normal[d];
  touch.curvature = 0;
  return true;
}
bool touch_surface(const SphereContact& sphere, const double* q, double radius, Touch& touch) {
  const double x[3] = {q[0] - sphere.center[0], q[1] - sphere.center[1], q[2] - sphere.center[2]};
  return touch_round(x, sphere.radius + radius, touch);
}

const char* name_of(const PlaneContact&) { return "contact_plane"; }
const char* name_of(const SphereContact&) { return "contact_sphere"; }
const char* name_of(const ParticleContact&) { return "contact_particles"; }

/// Calls visit(i, j, touch, relative velocity) for each contact of a particle i with j, which is i
/// again for a surface that does not move.
template <class Surface, class Visit>
void for_touching(const Surface& surface, const Bodies& bodies, const double* q, const double* v,
                  const Visit& visit) {
  Touch touch{};
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (bodies.free(i) && touch_surface(surface, q + 3 * i, bodies.radius[i], touch))
      visit(i, i, touch, v + 3 * i);
}
template <class Visit>
void for_touching(const ParticleContact&, const Bodies& bodies, const double* q, const double* v,
                  const Visit& visit) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  possible_contacts(bodies, q, pairs);
  Touch touch{};
  for (const auto& [i, j] : pairs) {
    const std::size_t a = std::size_t{3} * i, b = std::size_t{3} * j;
    const double *qi = q + a, *qj = q + b, *vi = v + a, *vj = v + b;
    const double x[3] = {qi[0] - qj[0], qi[1] - qj[1], qi[2] - qj[2]};
    if (!touch_round(x, bodies.radius[i] + bodies.radius[j], touch)) continue;
    const double w[3] = {vi[0] - vj[0], vi[1] - vj[1], vi[2] - vj[2]};
    visit(std::size_t{i}, std::size_t{j}, touch, w);
  }
}

/// A surface against every free particle, or every particle against every other one.
template <class Law>
class ContactTerm final : public Term {
 public:
  explicit ContactTerm(const Law& law) : law_(law) {}

  TermInfo info(const Bodies& bodies) const override {
    constexpr bool particles = std::is_same_v<Law, ParticleContact>;
    return {.name = name_of(law_),
            .law = law_.friction > 0 ? "N n - mu N s, N = max(0, k depth - c v.n)"
                                     : "N n, N = max(0, k depth - c v.n)",
            .count = particles ? bodies.size() : 1,
            .unit = particles ? "particles" : "surfaces",
            .velocity_dependent = law_.damping != 0 || law_.friction != 0,
            .linear = false,
            .order_kept = order_at_kinks};
  }

  void add(const Bodies& bodies, const double* q, const double* v, double* force) const override {
    for_touching(law_, bodies, q, v,
                 [&](std::size_t i, std::size_t j, const Touch& touch, const double* w) {
                   double f[3];
                   Push(law_, touch, w).force(law_, touch, f);
                   for (std::size_t d = 0; d < 3; ++d) {
                     force[3 * i + d] += f[d];
                     if (j != i) force[3 * j + d] -= f[d];
                   }
                 });
  }

  void add_blocks(const Bodies& bodies, const double* q, const double* v,
                  BlockSink& sink) const override {
    for_touching(law_, bodies, q, v,
                 [&](std::size_t i, std::size_t j, const Touch& touch, const double* w) {
                   const Push push(law_, touch, w);
                   if (push.n_force == 0) return;
                   Mat3 x, y;
                   push.derivatives(law_, touch, x, y);
                   if (j == i) return sink.add(i, i, x, y);
                   for (std::size_t k = 0; k < 9; ++k) x[k] = -x[k], y[k] = -y[k];
                   sink.add_pair(i, j, x, y);
                 });
  }

  double potential(const Bodies& bodies, const double* q) const override {
    double sum = 0;
    for_touching(law_, bodies, q, q,
                 [&](std::size_t, std::size_t, const Touch& touch, const double*) {
                   sum += law_.stiffness * touch.depth * touch.depth / 2;
                 });
    return sum;
  }

 private:
  Law law_;
};

}  // namespace

std::unique_ptr<Term> make_contact(const Contact& contact) {
  return std::visit(
      []<class Law>(const Law& law) -> std::unique_ptr<Term> {
        return std::make_unique<ContactTerm<Law>>(law);
      },
      contact);
}

}  // namespace odeum::scene
