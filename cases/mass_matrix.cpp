// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/set_problem.hpp"

namespace odeum::cases {
namespace {

/// Two masses on a line, each on a spring to its wall and one spring between them, in the
/// coordinates s = x1 + x2 and d = x1 - x2. The kinetic energy m1 x1'^2 / 2 + m2 x2'^2 / 2 is then
/// (s', d') M (s', d')^T / 2 with
///
///     M = 1/4 [ m1 + m2, m1 - m2; m1 - m2, m1 + m2 ],
///
/// which is not diagonal where the masses differ, and M (s, d)'' = -K (s, d) with
/// K = 1/4 [ k1 + k2, k1 - k2; k1 - k2, k1 + k2 + 4 k12 ].
struct SumAndDifference {
  static constexpr std::size_t dimension = 4;
  static constexpr bool velocity_dependent = false;
  double m1 = 1, m2 = 3, k1 = 4, k2 = 5, k12 = 2;

  double m_same() const { return (m1 + m2) / 4; }
  double m_cross() const { return (m1 - m2) / 4; }
  double k_cross() const { return (k1 - k2) / 4; }
  double k_sum() const { return (k1 + k2) / 4; }
  double k_difference() const { return (k1 + k2) / 4 + k12; }

  template <class R>
  void acceleration(R, const R* q, const R*, R* a) const {
    const R force_s = -k_sum() * q[0] - k_cross() * q[1];
    const R force_d = -k_cross() * q[0] - k_difference() * q[1];
    const R determinant = m_same() * m_same() - m_cross() * m_cross();
    a[0] = (m_same() * force_s - m_cross() * force_d) / determinant;
    a[1] = (m_same() * force_d - m_cross() * force_s) / determinant;
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 2, t, y, dydt);
  }
  void jacobian(double t, const double*, double* j) const {
    for (std::size_t i = 0; i < 16; ++i) j[i] = 0;
    j[2] = j[7] = 1;
    for (std::size_t column = 0; column < 2; ++column) {
      double unit[2] = {0, 0}, a[2];
      unit[column] = 1;
      acceleration(t, unit, unit, a);
      j[8 + column] = a[0];
      j[12 + column] = a[1];
    }
  }
  void linear_matrix(double* a) const { jacobian(0, nullptr, a); }
  double energy(const double* y) const {
    const double kinetic = m_same() * (y[2] * y[2] + y[3] * y[3]) / 2 + m_cross() * y[2] * y[3];
    const double elastic =
        (k_sum() * y[0] * y[0] + k_difference() * y[1] * y[1]) / 2 + k_cross() * y[0] * y[1];
    return kinetic + elastic;
  }
};

/// In x1 and x2 the masses are a diagonal matrix: x_i'' = -A x with A = diag(1/m) K', symmetric as
/// B = m^(-1/2) K' m^(-1/2), whose two modes are known in closed form.
void exact(const SumAndDifference& p, const double* y0, double t, double* y) {
  const double r1 = std::sqrt(p.m1), r2 = std::sqrt(p.m2);
  const double b11 = (p.k1 + p.k12) / p.m1, b22 = (p.k2 + p.k12) / p.m2, b12 = -p.k12 / (r1 * r2);
  const double angle = std::atan2(2 * b12, b11 - b22) / 2;
  const double c = std::cos(angle), s = std::sin(angle);
  const double squares[2] = {c * c * b11 + 2 * c * s * b12 + s * s * b22,
                             s * s * b11 - 2 * c * s * b12 + c * c * b22};
  // Mass-weighted coordinates z = sqrt(m) x, rotated into the modes and back.
  const double z[2] = {r1 * (y0[0] + y0[1]) / 2, r2 * (y0[0] - y0[1]) / 2};
  const double w[2] = {r1 * (y0[2] + y0[3]) / 2, r2 * (y0[2] - y0[3]) / 2};
  const double mode[2] = {c * z[0] + s * z[1], -s * z[0] + c * z[1]};
  const double rate[2] = {c * w[0] + s * w[1], -s * w[0] + c * w[1]};
  double moved[2], moving[2];
  for (int k = 0; k < 2; ++k) {
    const double omega = std::sqrt(squares[k]);
    moved[k] = mode[k] * std::cos(omega * t) + rate[k] / omega * std::sin(omega * t);
    moving[k] = rate[k] * std::cos(omega * t) - mode[k] * omega * std::sin(omega * t);
  }
  const double x1 = (c * moved[0] - s * moved[1]) / r1, x2 = (s * moved[0] + c * moved[1]) / r2;
  const double v1 = (c * moving[0] - s * moving[1]) / r1, v2 = (s * moving[0] + c * moving[1]) / r2;
  y[0] = x1 + x2, y[1] = x1 - x2, y[2] = v1 + v2, y[3] = v1 - v2;
}

Case make_case(const Values& values) {
  const SumAndDifference p{values[0], values[1], values[2], values[3], values[4]};
  require_positive("m1", p.m1);
  require_positive("m2", p.m2);
  for (const auto& [name, k] : {std::pair{"k1", p.k1}, {"k2", p.k2}, {"k12", p.k12}})
    require_positive(name, k);
  Case c;
  c.nature.linear = c.nature.smooth = true;
  c.equation = fmt::format(
      "M (s, d)'' = -K (s, d), M = 1/4 [{0} {1}; {1} {0}], K = 1/4 [{2} {3}; "
      "{3} {4}]",
      p.m1 + p.m2, p.m1 - p.m2, p.k1 + p.k2, p.k1 - p.k2, p.k1 + p.k2 + 4 * p.k12);
  c.source =
      "two coupled oscillators, Goldstein, Classical Mechanics, chapter 6: M is not diagonal";
  c.y0 = {values[5], values[6], values[7], values[8]};
  c.components = {"s", "d", "s_rate", "d_rate"};
  c.stops = {2.5, 5, 7.5, 10};
  c.settings.steps_multiple = 4;
  c.settings.coarsest_steps = 32;
  c.settings.finest_steps = 65536;
  c.truth.at = [p, y0 = c.y0](double t, double* y) {
    exact(p, y0.data(), t, y);
    return true;
  };
  c.truth.floor = 1e-14;  // rounding of numbers of size 1 with omega t up to 30
  c.truth.source = "closed form: normal modes in x1 and x2";
  c.truth.closed_form = true;
  set_problem(c, p);
  return c;
}

}  // namespace

/// Two masses on springs in coordinates whose mass matrix is not diagonal.
std::vector<Statement> mass_matrix() {
  return {{.id = "mass_matrix",
           .title = "Two masses in sum and difference coordinates",
           .tags = {"second_order", "separable", "mechanical"},
           .make = [] {
             return with_parameters({{"m1", 1, "mass, kg"},
                                     {"m2", 3, "mass, kg"},
                                     {"k1", 4, "stiffness to the wall, N/m"},
                                     {"k2", 5, "stiffness to the wall, N/m"},
                                     {"k12", 2, "stiffness between the masses, N/m"},
                                     {"s0", 1, "x1 + x2 at the start, m"},
                                     {"d0", 0.5, "x1 - x2 at the start, m"},
                                     {"s_rate0", 0, "its rate, m/s"},
                                     {"d_rate0", -0.3, "its rate, m/s"}},
                                    make_case);
           }}};
}

}  // namespace odeum::cases
