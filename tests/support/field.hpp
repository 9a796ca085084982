// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "support/enrolled.hpp"
#include "support/own_runs.hpp"

namespace odeum::tests {

/// q'' = a(t, q) with an `a` of the test's choice and its derivatives.
struct Field {
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = false;
  double (*a)(double t, double q);
  double (*a_q)(double t, double q);
  double (*a_t)(double t, double q);

  void acceleration(double t, const double* q, const double*, double* out) const {
    out[0] = a(t, q[0]);
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
  void jacobian(double t, const double* y, double* j) const {
    j[0] = j[3] = 0;
    j[1] = 1;
    j[2] = a_q(t, y[0]);
  }
  void time_derivative(double t, const double* y, double* dfdt) const {
    dfdt[0] = 0;
    dfdt[1] = a_t(t, y[0]);
  }
};

/// Every own method on it that fits it: none needs a series or a constant matrix.
inline std::vector<Entrant> own_methods_on(const Field& field, double t0, std::vector<double> y0) {
  const auto problem = std::make_shared<const Field>(field);
  ErasedContest contest = contest_on(*problem, t0, std::move(y0));
  contest.keep_alive = problem;
  std::vector<Entrant> entrants = enrolled_on(contest, own_methods());
  std::erase_if(entrants, [](const Entrant& entrant) { return !entrant.unfit.empty(); });
  return entrants;
}

}  // namespace odeum::tests
