// SPDX-License-Identifier: BSD-3-Clause
// The translation unit that compiles the whole catalogue for a test problem.
#include "support/field.hpp"

#include "odeum/contest/own_solvers.hpp"

namespace odeum::tests {

std::vector<Entrant> own_methods_on(const Field& field, double t0, std::vector<double> y0) {
  Contest<Field> contest;
  contest.problem = std::make_shared<const Field>(field);
  contest.t0 = t0;
  contest.y0 = std::make_shared<const std::vector<double>>(std::move(y0));
  std::vector<Entrant> entrants;
  enroll_own(contest, entrants);
  // A field of the test's choice has no series and no constant matrix to offer.
  std::erase_if(entrants, [](const Entrant& entrant) {
    return entrant.info.family == "taylor" || entrant.info.family == "exponential";
  });
  return entrants;
}

}  // namespace odeum::tests
