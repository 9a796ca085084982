// SPDX-License-Identifier: BSD-3-Clause
// Boost.odeint alone, as C++17 (uBLAS): implicit_euler means to iterate with the first Jacobian of
// the step, but its solve() factorises, each time, the matrix that the last call left factorised.
// One step of h = 0.4 of q'' = -5 sin q - 0.1 q'^3; compared with the same iteration and criterion
// on the original matrix. Exits 0 while the library has not converged after 1000 evaluations (it
// has no limit) where the other needs fewer than 20.
#include <boost/numeric/odeint/stepper/implicit_euler.hpp>
#include <cmath>
#include <cstdio>
#include <utility>

using Vector = boost::numeric::ublas::vector<double>;
using Matrix = boost::numeric::ublas::matrix<double>;
struct TooMany {};

int evaluations = 0;
void rhs(const Vector& y, Vector& dydt, double) {
  if (++evaluations > 1000) throw TooMany{};
  dydt[0] = y[1];
  dydt[1] = -5 * std::sin(y[0]) - 0.1 * y[1] * y[1] * y[1];
}
void jacobian(const Vector& y, Matrix& j, double) {
  j(0, 0) = 0;
  j(0, 1) = 1;
  j(1, 0) = -5 * std::cos(y[0]);
  j(1, 1) = -0.3 * y[1] * y[1];
}

int main() {
  const double h = 0.4;
  Vector y(2), x(2), f(2);
  y[0] = x[0] = 1;
  y[1] = x[1] = 0.5;
  Matrix j(2, 2);
  jacobian(y, j, h);
  const double a = 1 - h * j(0, 0), b = -h * j(0, 1), c = -h * j(1, 0), d = 1 - h * j(1, 1);
  for (double size = 1; size > 1e-6;) {  // the library's own criterion
    rhs(x, f, h);
    const double r0 = y[0] + h * f[0] - x[0], r1 = y[1] + h * f[1] - x[1];
    const double d0 = (d * r0 - b * r1) / (a * d - b * c), d1 = (a * r1 - c * r0) / (a * d - b * c);
    x[0] += d0;
    x[1] += d1;
    size = std::hypot(d0, d1);
  }
  const int expected = evaluations;
  evaluations = 0;
  try {
    boost::numeric::odeint::implicit_euler<double>().do_step(std::make_pair(rhs, jacobian), y, 0.0,
                                                             h);
  } catch (const TooMany&) {
  }
  std::printf("evaluations: %d with the matrix as it was, %d in odeint\n", expected, evaluations);
  return expected < 20 && evaluations > 1000 ? 0 : 1;
}
