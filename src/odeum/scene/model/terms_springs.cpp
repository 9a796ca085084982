// SPDX-License-Identifier: BSD-3-Clause
// Springs damped along their own line; those damped on the whole velocity are a MassSpring's.
#include <cmath>

#include "odeum/scene/model/terms.hpp"

namespace odeum::scene {
namespace {

/// With x = x_b - x_a, l = |x|, u = x / l and w = v_b - v_a, the force on a is
/// [k (l - L) + d w.u] u, on b its opposite.
class AxialSprings final : public Term {
 public:
  AxialSprings(const Bodies& bodies, std::vector<DescribedSpring> springs)
      : bodies_(bodies), springs_(std::move(springs)) {}

  TermInfo info() const override {
    TermInfo info{.name = "springs_axial",
                  .law = "[k (l - L) + d (w.u)] u",
                  .count = springs_.size(),
                  .unit = "springs",
                  .velocity_dependent = true};
    for (const DescribedSpring& spring : springs_) info.smooth &= !spring.tension_only;
    return info;
  }

  std::uint64_t add(const double* q, const double* v, double* a) const override {
    for (const DescribedSpring& spring : springs_) {
      const double *qa = q + 3 * spring.a, *qb = q + 3 * spring.b;
      const double *va = v + 3 * spring.a, *vb = v + 3 * spring.b;
      const double x = qb[0] - qa[0], y = qb[1] - qa[1], z = qb[2] - qa[2];
      const double squared = x * x + y * y + z * z, length = std::sqrt(squared);
      if (length == 0) continue;  // no direction
      const bool slack = spring.tension_only && length <= spring.rest_length;
      const double elastic = slack ? 0 : spring.stiffness * (1 - spring.rest_length / length);
      const double rate = (vb[0] - va[0]) * x + (vb[1] - va[1]) * y + (vb[2] - va[2]) * z;
      const double s = elastic + spring.damping * rate / squared;
      const double ma = s * bodies_.inverse_mass[spring.a], mb = s * bodies_.inverse_mass[spring.b];
      double *const aa = a + 3 * spring.a, *const ab = a + 3 * spring.b;
      aa[0] += ma * x, aa[1] += ma * y, aa[2] += ma * z;
      ab[0] -= mb * x, ab[1] -= mb * y, ab[2] -= mb * z;
    }
    return springs_.size();
  }

  // d/dx of the force on a: k (1 - L/l) (I - u u^T) + k u u^T for the elastic part, and for the
  // damping d [ u (w - (w.u) u)^T + (w.u) (I - u u^T) ] / l; d/dw is d u u^T.
  void add_blocks(const double* q, const double* v, BlockSink& sink) const override {
    for (const DescribedSpring& spring : springs_) {
      double u[3], w[3], length = 0, rate = 0;
      for (std::size_t d = 0; d < 3; ++d) {
        u[d] = q[3 * spring.b + d] - q[3 * spring.a + d];
        w[d] = v[3 * spring.b + d] - v[3 * spring.a + d];
        length += u[d] * u[d];
      }
      length = std::sqrt(length);
      if (length == 0) continue;
      for (int d = 0; d < 3; ++d) rate += w[d] * (u[d] /= length);
      const bool slack = spring.tension_only && length <= spring.rest_length;
      const double along = slack ? 0 : spring.stiffness;
      const double across = slack ? 0 : spring.stiffness * (1 - spring.rest_length / length);
      const double turning = spring.damping / length;
      Mat3 x{}, y{}, minus_x{}, minus_y{};
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const double identity = i == j ? 1 : 0, uu = u[i] * u[j];
          const int k = 3 * i + j;
          x[k] = along * uu + (across + turning * rate) * (identity - uu) +
                 turning * u[i] * (w[j] - rate * u[j]);
          y[k] = spring.damping * uu;
          minus_x[k] = -x[k];
          minus_y[k] = -y[k];
        }
      sink.add(spring.a, spring.b, x, y);
      sink.add(spring.b, spring.a, x, y);
      sink.add(spring.a, spring.a, minus_x, minus_y);
      sink.add(spring.b, spring.b, minus_x, minus_y);
    }
  }

  double potential(const double* q) const override {
    double sum = 0;
    for (const DescribedSpring& spring : springs_) {
      double squared = 0;
      for (std::size_t d = 0; d < 3; ++d) {
        const double difference = q[3 * spring.b + d] - q[3 * spring.a + d];
        squared += difference * difference;
      }
      const double stretch = std::sqrt(squared) - spring.rest_length;
      if (stretch > 0 || !spring.tension_only) sum += spring.stiffness * stretch * stretch / 2;
    }
    return sum;
  }

 private:
  const Bodies& bodies_;
  std::vector<DescribedSpring> springs_;
};

}  // namespace

std::unique_ptr<Term> make_axial_springs(const Bodies& bodies,
                                         std::vector<DescribedSpring> springs) {
  return std::make_unique<AxialSprings>(bodies, std::move(springs));
}

}  // namespace odeum::scene
