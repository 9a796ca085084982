// SPDX-License-Identifier: BSD-3-Clause
#include <odeum/api/integrate.hpp>
#include <odeum/methods/dormand_prince853.hpp>

#include "pendulum.hpp"

int main() {
  std::array<double, 2> y{1, 0};
  const odeum::RunEnd run = odeum::integrate(Pendulum{}, odeum::methods::dormand_prince853{}, y, 0,
                                             Pendulum::period(), odeum::Tolerance{1e-10});
  // The tolerance bounds the error of a step; over a period a factor of 20 more is left for sums.
  const bool met = run.ok() && std::hypot(y[0] - 1, y[1]) < 2e-9;

  // A small swing is below one number of 1e-4, and has its digits by an absolute tolerance.
  std::array<double, 2> small{1e-6, 0};
  const odeum::RunEnd finer =
      odeum::integrate(Pendulum{}, odeum::methods::dormand_prince853{}, small, 0, 2 * M_PI,
                       odeum::Tolerance{1e-4, {1e-10, 1e-10}});
  return met && finer.ok() && std::hypot(small[0] - 1e-6, small[1]) < 2e-9 ? 0 : 1;
}
