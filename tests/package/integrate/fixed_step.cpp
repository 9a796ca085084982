// SPDX-License-Identifier: BSD-3-Clause
#include <odeum/api/integrate.hpp>
#include <odeum/methods/rk4.hpp>

#include "pendulum.hpp"

int main() {
  std::array<double, 2> y{1, 0};
  const odeum::RunEnd run = odeum::integrate(Pendulum{}, odeum::methods::rk4{}, y, 0,
                                             Pendulum::period(), odeum::Step{0.01});
  // After a period the start is met, to the error of 670 steps of order 4.
  const double error = std::hypot(y[0] - 1, y[1]);
  return run.ok() && run.steps == 670 && error < 1e-8 && error > 1e-14 ? 0 : 1;
}
