// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/test_problems.hpp"

#include <cmath>

namespace odeum::proof {
namespace {

// M = [[-0.4, -2.1], [1.7, -0.2]] has the eigenvalues -0.3 +- i sqrt(3.56).
constexpr double m11 = -0.4, m12 = -2.1, m21 = 1.7, m22 = -0.2;
constexpr double z1_start = 0.7, z2_start = -0.4;

/// z(s) = exp(M s) z(0).
void rotated(double s, double& z1, double& z2) {
  const double w = std::sqrt(3.56), decay = std::exp(-0.3 * s);
  const double c = decay * std::cos(w * s), o = decay * std::sin(w * s) / w;
  z1 = c * z1_start + o * ((m11 + 0.3) * z1_start + m12 * z2_start);
  z2 = c * z2_start + o * (m21 * z1_start + (m22 + 0.3) * z2_start);
}

/// The transformation y_2 = z_2 + g(z_1) with g(x) = 1/(1 + x^2/2), and g' and g''. Its poles keep
/// errors of high orders near their leading terms, as those of an entire function would not be.
struct Bend {
  explicit Bend(double x) {
    const double d = 1 + 0.5 * x * x;
    value = 1 / d;
    slope = -x / (d * d);
    curvature = (1.5 * x * x - 1) / (d * d * d);
  }
  double value, slope, curvature;
};

/// The field of y = (z_1, z_2 + g(z_1)) and its Jacobian.
void bent_field(const double* y, double* f) {
  const Bend g(y[0]);
  const double z2 = y[1] - g.value;
  f[0] = m11 * y[0] + m12 * z2;
  f[1] = m21 * y[0] + m22 * z2 + g.slope * f[0];
}
void bent_jacobian(const double* y, double* j) {
  const Bend g(y[0]);
  const double f0 = m11 * y[0] + m12 * (y[1] - g.value);
  j[0] = m11 - m12 * g.slope;
  j[1] = m12;
  j[2] = m21 - m22 * g.slope + g.curvature * f0 + g.slope * j[0];
  j[3] = m22 + g.slope * j[1];
}

// The rate of the transformed time; its integral from 0 is `elapsed`.
double pace(double t) { return 1 + 0.6 * std::cos(2 * t + 0.3); }
double pace_change(double t) { return -1.2 * std::sin(2 * t + 0.3); }
double elapsed(double t) { return t + 0.3 * (std::sin(2 * t + 0.3) - std::sin(0.3)); }

TestProblem<FunctionProblem> linear() {
  TestProblem<FunctionProblem> g;
  g.id = "linear";
  g.problem.unknowns = 2;
  g.problem.f = [](double, const double* y, double* f) {
    f[0] = m11 * y[0] + m12 * y[1];
    f[1] = m21 * y[0] + m22 * y[1];
  };
  g.problem.f_y = [](double, const double*, double* j) {
    j[0] = m11;
    j[1] = m12;
    j[2] = m21;
    j[3] = m22;
  };
  g.problem.f_t = [](double, const double*, double* d) { d[0] = d[1] = 0; };
  g.truth = [](double t, double* y) { rotated(t, y[0], y[1]); };
  return g;
}

TestProblem<FunctionProblem> nonlinear() {
  TestProblem<FunctionProblem> g;
  g.id = "nonlinear";
  g.problem.unknowns = 2;
  g.problem.f = [](double, const double* y, double* f) { bent_field(y, f); };
  g.problem.f_y = [](double, const double* y, double* j) { bent_jacobian(y, j); };
  g.problem.f_t = [](double, const double*, double* d) { d[0] = d[1] = 0; };
  g.truth = [](double t, double* y) {
    rotated(t, y[0], y[1]);
    y[1] += Bend(y[0]).value;
  };
  return g;
}

TestProblem<FunctionProblem> non_autonomous() {
  TestProblem<FunctionProblem> g;
  g.id = "non_autonomous";
  g.problem.unknowns = 3;
  g.problem.f = [](double t, const double* y, double* f) {
    bent_field(y, f);
    f[0] *= pace(t);
    f[1] *= pace(t);
    f[2] = std::cos(3 * t);
  };
  g.problem.f_y = [](double t, const double* y, double* j) {
    double bent[4];
    bent_jacobian(y, bent);
    const double p = pace(t);
    const double rows[9] = {p * bent[0], p * bent[1], 0, p * bent[2], p * bent[3], 0, 0, 0, 0};
    std::copy(rows, rows + 9, j);
  };
  g.problem.f_t = [](double t, const double* y, double* d) {
    bent_field(y, d);
    d[0] *= pace_change(t);
    d[1] *= pace_change(t);
    d[2] = -3 * std::sin(3 * t);
  };
  g.truth = [](double t, double* y) {
    rotated(elapsed(t), y[0], y[1]);
    y[1] += Bend(y[0]).value;
    y[2] = std::sin(3 * t) / 3;
  };
  return g;
}

constexpr double stiffness = 2.3;

TestProblem<FunctionMechanics<false>> oscillator() {
  TestProblem<FunctionMechanics<false>> g;
  g.id = "linear";
  g.problem = mechanics<false>(
      1, {.a = [](double, const double* q, const double*, double* a) { a[0] = -stiffness * q[0]; },
          .a_q = [](double, const double*, const double*, double* a) { a[0] = -stiffness; }});
  g.truth = [](double t, double* y) {
    const double w = std::sqrt(stiffness);
    y[0] = 0.8 * std::cos(w * t) + 0.5 / w * std::sin(w * t);
    y[1] = 0.5 * std::cos(w * t) - 0.8 * w * std::sin(w * t);
  };
  return g;
}

// Kepler's ellipse of semi-major axis 1: E - e sin E = t, the perihelion passed at t = -0.5.
TestProblem<FunctionMechanics<false>> kepler() {
  constexpr double e = 0.3;
  TestProblem<FunctionMechanics<false>> g;
  g.id = "nonlinear";
  g.problem = mechanics<false>(
      2, {.a =
              [](double, const double* q, const double*, double* a) {
                const double r2 = q[0] * q[0] + q[1] * q[1], r3 = r2 * std::sqrt(r2);
                a[0] = -q[0] / r3;
                a[1] = -q[1] / r3;
              },
          .a_q =
              [](double, const double* q, const double*, double* a) {
                const double r2 = q[0] * q[0] + q[1] * q[1], r3 = r2 * std::sqrt(r2);
                a[0] = (3 * q[0] * q[0] / r2 - 1) / r3;
                a[1] = a[2] = 3 * q[0] * q[1] / (r2 * r3);
                a[3] = (3 * q[1] * q[1] / r2 - 1) / r3;
              }});
  g.truth = [](double t, double* y) {
    const double mean = t + 0.5;
    double anomaly = mean;
    for (int i = 0; i < 20; ++i)
      anomaly -= (anomaly - e * std::sin(anomaly) - mean) / (1 - e * std::cos(anomaly));
    const double b = std::sqrt(1 - e * e), rate = 1 / (1 - e * std::cos(anomaly));
    y[0] = std::cos(anomaly) - e;
    y[1] = b * std::sin(anomaly);
    y[2] = -std::sin(anomaly) * rate;
    y[3] = b * std::cos(anomaly) * rate;
  };
  return g;
}

// A pendulum driven so that its angle is phi(t).
double phi(double t) { return 0.8 * std::sin(1.3 * t + 0.4) + 0.3 * t; }
double phi_1(double t) { return 1.04 * std::cos(1.3 * t + 0.4) + 0.3; }
double phi_2(double t) { return -1.352 * std::sin(1.3 * t + 0.4); }
double phi_3(double t) { return -1.7576 * std::cos(1.3 * t + 0.4); }

template <bool Velocity>
TestProblem<FunctionMechanics<Velocity>> driven_pendulum() {
  constexpr double d = Velocity ? 0.6 : 0;
  TestProblem<FunctionMechanics<Velocity>> g;
  g.id = "non_autonomous";
  g.problem = mechanics<Velocity>(
      1, {.a =
              [](double t, const double* q, const double* v, double* a) {
                a[0] = phi_2(t) + std::sin(phi(t)) - std::sin(q[0]);
                if constexpr (Velocity) a[0] += d * (phi_1(t) - v[0]);
              },
          .a_q = [](double, const double* q, const double*, double* a) { a[0] = -std::cos(q[0]); },
          .a_v = [](double, const double*, const double*, double* a) { a[0] = -d; },
          .a_t = [](double t, const double*, const double*,
                    double* a) { a[0] = phi_3(t) + std::cos(phi(t)) * phi_1(t) + d * phi_2(t); }});
  g.truth = [](double t, double* y) {
    y[0] = phi(t);
    y[1] = phi_1(t);
  };
  return g;
}

// q'' = -2 beta q' - k q with beta = 0.3.
TestProblem<FunctionMechanics<true>> damped_oscillator() {
  constexpr double beta = 0.3;
  TestProblem<FunctionMechanics<true>> g;
  g.id = "linear";
  g.problem = mechanics<true>(
      1, {.a = [](double, const double* q, const double* v,
                  double* a) { a[0] = -stiffness * q[0] - 2 * beta * v[0]; },
          .a_q = [](double, const double*, const double*, double* a) { a[0] = -stiffness; },
          .a_v = [](double, const double*, const double*, double* a) { a[0] = -2 * beta; }});
  g.truth = [](double t, double* y) {
    const double w = std::sqrt(stiffness - beta * beta), decay = std::exp(-beta * t);
    const double c = decay * std::cos(w * t), s = decay * std::sin(w * t) / w;
    y[0] = 0.8 * c + (0.5 + beta * 0.8) * s;
    y[1] = 0.5 * c - (beta * 0.5 + stiffness * 0.8) * s;
  };
  return g;
}

// q'' = -q'^2 + ...: with q = log u and u'' = -u, q'' = -1 - q'^2.
TestProblem<FunctionMechanics<true>> quadratic_drag() {
  TestProblem<FunctionMechanics<true>> g;
  g.id = "nonlinear";
  g.horizon = 0.5;
  g.problem = mechanics<true>(
      1, {.a = [](double, const double*, const double* v, double* a) { a[0] = -1 - v[0] * v[0]; },
          .a_q = [](double, const double*, const double*, double* a) { a[0] = 0; },
          .a_v = [](double, const double*, const double* v, double* a) { a[0] = -2 * v[0]; }});
  g.truth = [](double t, double* y) {
    y[0] = std::log(std::cos(t - 1));
    y[1] = -std::tan(t - 1);
  };
  return g;
}

template <class P>
std::vector<TestProblem<P>> started(std::vector<TestProblem<P>> test_problems) {
  for (TestProblem<P>& g : test_problems) {
    g.y0.resize(g.problem.size());
    g.truth(g.t0, g.y0.data());
  }
  return test_problems;
}

}  // namespace

template <bool Velocity>
FunctionMechanics<Velocity> mechanics(std::size_t degrees, const Accelerations& d) {
  FunctionMechanics<Velocity> m;
  m.unknowns = 2 * degrees;
  m.a = d.a;
  m.f = [degrees, a = d.a](double t, const double* y, double* f) {
    std::copy(y + degrees, y + 2 * degrees, f);
    a(t, y, y + degrees, f + degrees);
  };
  m.f_y = [degrees, d](double t, const double* y, double* j) {
    const std::size_t n = 2 * degrees;
    std::vector<double> by_q(degrees * degrees), by_v(degrees * degrees);
    d.a_q(t, y, y + degrees, by_q.data());
    if (d.a_v) d.a_v(t, y, y + degrees, by_v.data());
    std::fill_n(j, n * n, 0.0);
    for (std::size_t i = 0; i < degrees; ++i) {
      j[i * n + degrees + i] = 1;
      for (std::size_t k = 0; k < degrees; ++k) {
        j[(degrees + i) * n + k] = by_q[i * degrees + k];
        j[(degrees + i) * n + degrees + k] = by_v[i * degrees + k];
      }
    }
  };
  m.f_t = [degrees, a_t = d.a_t](double t, const double* y, double* f) {
    std::fill_n(f, 2 * degrees, 0.0);
    if (a_t) a_t(t, y, y + degrees, f + degrees);
  };
  return m;
}
template FunctionMechanics<false> mechanics(std::size_t, const Accelerations&);
template FunctionMechanics<true> mechanics(std::size_t, const Accelerations&);

const std::vector<TestProblem<FunctionProblem>>& test_problems() {
  static const auto all = started<FunctionProblem>({linear(), nonlinear(), non_autonomous()});
  return all;
}
const std::vector<TestProblem<FunctionMechanics<false>>>& separable_test_problems() {
  static const auto all =
      started<FunctionMechanics<false>>({oscillator(), kepler(), driven_pendulum<false>()});
  return all;
}
const std::vector<TestProblem<FunctionMechanics<true>>>& second_order_test_problems() {
  static const auto all = started<FunctionMechanics<true>>(
      {damped_oscillator(), quadratic_drag(), driven_pendulum<true>()});
  return all;
}

}  // namespace odeum::proof
