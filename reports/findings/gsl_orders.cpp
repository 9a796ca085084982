// SPDX-License-Identifier: BSD-3-Clause
// GSL odeiv2 alone: rk2, whose gsl_odeiv2_step_order is 2, converges at order 3, and one step of
// rk4 is two classical steps of half the size. y' = -y + sin 3t to t = 2. Exits 0 while both stand.
#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <cstdio>

int rhs(double t, const double y[], double dydt[], void*) {
  dydt[0] = -y[0] + std::sin(3 * t);
  return GSL_SUCCESS;
}
const gsl_odeiv2_system problem = {rhs, nullptr, 1, nullptr};

double run(const gsl_odeiv2_step_type* type, int steps, unsigned* order) {
  gsl_odeiv2_step* step = gsl_odeiv2_step_alloc(type, 1);
  double y = 1, error = 0;
  const double h = 2.0 / steps;
  for (int i = 0; i < steps; ++i)
    gsl_odeiv2_step_apply(step, i * h, h, &y, &error, nullptr, nullptr, &problem);
  *order = gsl_odeiv2_step_order(step);
  gsl_odeiv2_step_free(step);
  return y;
}

int main() {
  const double exact = 0.1 * (std::sin(6.0) - 3 * std::cos(6.0)) + 1.3 * std::exp(-2.0);
  unsigned claimed = 0, four = 0;
  const double coarse = std::abs(run(gsl_odeiv2_step_rk2, 128, &claimed) - exact);
  const double fine = std::abs(run(gsl_odeiv2_step_rk2, 256, &claimed) - exact);
  const double order = std::log2(coarse / fine);

  double y = 1;  // the classical method, written out, with 20 steps
  const auto f = [](double t, double x) { return -x + std::sin(3 * t); };
  for (int i = 0; i < 20; ++i) {
    const double h = 0.1, t = i * h, k1 = f(t, y), k2 = f(t + h / 2, y + h / 2 * k1),
                 k3 = f(t + h / 2, y + h / 2 * k2), k4 = f(t + h, y + h * k3);
    y += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const double difference = run(gsl_odeiv2_step_rk4, 10, &four) - y;
  std::printf("rk2: claimed order %u, measured %.2f; rk4 in 10 steps minus classical in 20: %.1e\n",
              claimed, order, difference);
  return claimed == 2 && std::abs(order - 3) < 0.2 && std::abs(difference) < 1e-14 ? 0 : 1;
}
