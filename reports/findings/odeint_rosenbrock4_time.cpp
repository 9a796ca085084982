// SPDX-License-Identifier: BSD-3-Clause
// Boost.odeint alone, as C++17 (uBLAS): rosenbrock4 on y' = -y + sin 3t, whose order
// stepper_order gives as 4. The coefficients d1..d4 of h df/dt are the row sums of the method's
// matrix Gamma, and Gamma follows from the other coefficients: inverse(Gamma) = I / gamma - (c_ij).
// Exits 0 while the order is 1 and the header's d4 has the opposite sign of the row sum.
#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <cmath>
#include <cstdio>
#include <utility>

namespace od = boost::numeric::odeint;
using Vector = boost::numeric::ublas::vector<double>;
using Matrix = boost::numeric::ublas::matrix<double>;

double error(int steps) {
  const auto rhs = [](const Vector& y, Vector& dydt, double t) {
    dydt[0] = -y[0] + std::sin(3 * t);
  };
  const auto jacobian = [](const Vector&, Matrix& j, double t, Vector& dfdt) {
    j(0, 0) = -1;
    dfdt[0] = 3 * std::cos(3 * t);
  };
  od::rosenbrock4<double> stepper;
  Vector y(1);
  y[0] = 1;
  const double h = 2.0 / steps;
  for (int i = 0; i < steps; ++i) stepper.do_step(std::make_pair(rhs, jacobian), y, i * h, h);
  const double exact = 0.1 * (std::sin(6.0) - 3 * std::cos(6.0)) + 1.3 * std::exp(-2.0);
  return std::abs(y[0] - exact);
}

int main() {
  const double order = std::log2(error(8192) / error(16384));
  const od::default_rosenbrock_coefficients<double> k;
  const double c[4][4] = {{}, {k.c21}, {k.c31, k.c32}, {k.c41, k.c42, k.c43}};
  double sum[4];  // Gamma 1, from inverse(Gamma) s = 1, by forward substitution
  for (int i = 0; i < 4; ++i) {
    sum[i] = 1;
    for (int j = 0; j < i; ++j) sum[i] += c[i][j] * sum[j];
    sum[i] *= k.gamma;
  }
  std::printf("order %.2f; row sums %.6f %.6f %.6f %.6f; header d %.6f %.6f %.6f %.6f\n", order,
              sum[0], sum[1], sum[2], sum[3], k.d1, k.d2, k.d3, k.d4);
  return std::abs(order - 1) < 0.2 && std::abs(sum[3] + k.d4) < 1e-9 ? 0 : 1;
}
