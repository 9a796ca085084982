// SPDX-License-Identifier: BSD-3-Clause
#include <odeum/api/integrate.hpp>
#include <odeum/methods/dormand_prince853.hpp>

#include "pendulum.hpp"

int main() {
  std::array<double, 2> y{1, 0};
  const odeum::RunEnd run = odeum::integrate(Pendulum{}, odeum::methods::dormand_prince853{}, y, 0,
                                             Pendulum::period(), odeum::Tolerance{1e-10});
  // The tolerance bounds the error of a step; over a period a factor of 20 more is left for sums.
  return run.ok() && std::hypot(y[0] - 1, y[1]) < 2e-9 ? 0 : 1;
}
