// SPDX-License-Identifier: BSD-3-Clause
// Boost.odeint alone, as C++17 (uBLAS): implicit_euler where I - h J is singular, y' = y with
// h = 1. Exits 0 while the library ends the process with std::exit(0): the line after the step is
// never reached; 1 otherwise.
#include <boost/numeric/odeint/stepper/implicit_euler.hpp>
#include <utility>

using Vector = boost::numeric::ublas::vector<double>;
using Matrix = boost::numeric::ublas::matrix<double>;

int main() {
  const auto rhs = [](const Vector& y, Vector& dydt, double) { dydt = y; };
  const auto jacobian = [](const Vector&, Matrix& j, double) { j(0, 0) = 1; };
  boost::numeric::odeint::implicit_euler<double> stepper;
  Vector y(1);
  y[0] = 1;
  stepper.do_step(std::make_pair(rhs, jacobian), y, 0.0, 1.0);
  return 1;
}
