// SPDX-License-Identifier: BSD-3-Clause
#include <odeum/api/integrate.hpp>
#include <odeum/methods/dormand_prince54.hpp>

#include "pendulum.hpp"

int main() {
  std::array<double, 2> y{1, 0};
  int steps = 0;
  const auto watch = [&](double, const std::array<double, 2>&) { return ++steps < 10; };
  const odeum::RunEnd run = odeum::integrate(Pendulum{}, odeum::methods::dormand_prince54{}, y, 0,
                                             100, odeum::Tolerance{1e-8}, odeum::each_step(watch));
  return run.ok() && run.stopped && steps == 10 && run.steps == 10 && run.t < 100 ? 0 : 1;
}
