// SPDX-License-Identifier: BSD-3-Clause
// Boost.odeint alone: velocity_verlet on q'' = -5 q - d q', whose order order() gives
// as 1. Exits 0 while it is 2 without damping and 1 with it.
#include <array>
#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>
#include <cmath>
#include <complex>
#include <cstdio>

using Half = std::array<double, 1>;

double error(int steps, double d) {
  const auto a = [d](const Half& q, const Half& v, Half& out, double) {
    out[0] = -5 * q[0] - d * v[0];
  };
  boost::numeric::odeint::velocity_verlet<Half> stepper;
  std::pair<Half, Half> y{{1}, {0}};
  const double h = 2.0 / steps;
  for (int i = 0; i < steps; ++i) stepper.do_step(a, y, i * h, h);
  const double w = std::sqrt(5 - d * d / 4);
  return std::abs(y.first[0] - std::exp(-d) * (std::cos(2 * w) + d / 2 / w * std::sin(2 * w)));
}

int main() {
  const double undamped = std::log2(error(256, 0) / error(512, 0));
  const double damped = std::log2(error(256, 0.5) / error(512, 0.5));
  std::printf("order without damping %.2f, with damping %.2f\n", undamped, damped);
  return std::abs(undamped - 2) < 0.2 && std::abs(damped - 1) < 0.2 ? 0 : 1;
}
