// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <numbers>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/set_problem.hpp"

namespace odeum::cases {
namespace {

/// A chain of 32 unit masses between fixed ends, q_j'' = F(q_{j+1} - q_j) - F(q_j - q_{j-1}) with
/// F(d) = d + alpha d^2 + beta d^3.
struct Chain {
  static constexpr std::size_t dimension = 64, masses = 32;
  static constexpr bool velocity_dependent = false;
  double alpha, beta;

  template <class R>
  void acceleration(R, const R* q, const R*, R* a) const {
    R before = force(q[0]);
    for (std::size_t j = 0; j < masses; ++j) {
      const R after = force((j + 1 < masses ? q[j + 1] : 0) - q[j]);
      a[j] = after - before;
      before = after;
    }
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, masses, t, y, dydt);
  }
  void jacobian(double, const double* q, double* j) const {
    for (std::size_t i = 0; i < dimension * dimension; ++i) j[i] = 0;
    for (std::size_t i = 0; i < masses; ++i) j[i * dimension + masses + i] = 1;
    for (std::size_t i = 0; i < masses; ++i) {
      double* const row = j + (masses + i) * dimension;
      const double before = stiffness(q[i] - (i ? q[i - 1] : 0));
      const double after = stiffness((i + 1 < masses ? q[i + 1] : 0) - q[i]);
      row[i] = -before - after;
      if (i) row[i - 1] = before;
      if (i + 1 < masses) row[i + 1] = after;
    }
  }
  double energy(const double* y) const {
    double sum = 0;
    for (std::size_t j = 0; j <= masses; ++j) {
      const double d = (j < masses ? y[j] : 0) - (j ? y[j - 1] : 0);
      sum += d * d * (0.5 + d * (alpha / 3 + d * beta / 4));
      if (j < masses) sum += y[masses + j] * y[masses + j] / 2;
    }
    return sum;
  }
  template <class R>
  R force(R d) const {
    return d * (1 + d * (alpha + d * beta));
  }
  double stiffness(double d) const { return 1 + d * (2 * alpha + 3 * beta * d); }
};

Case make_case(const std::string& id, const Values& values) {
  Case c;
  c.equation =
      "q_j'' = F(q_{j+1} - q_j) - F(q_j - q_{j-1}), F(d) = d + alpha d^2 + beta d^3, in the first "
      "mode";
  c.source = "Fermi, Pasta, Ulam, Tsingou, Los Alamos report LA-1940 (1955)";
  c.y0.resize(Chain::dimension);
  for (std::size_t j = 0; j < Chain::masses; ++j)
    c.y0[j] = values[2] * std::sin(std::numbers::pi * static_cast<double>(j + 1) / 33);
  c.stops = {10, 50};
  c.settings.no_convergence = "64 unknowns; smaller cases show the same orders";
  c.settings.steps_multiple = 5;
  c.settings.coarsest_steps = 80;
  c.settings.finest_steps = 2560;
  c.settings.evaluation_budget = 20'000;
  c.truth = reference_truth(id, 3.5e-16);
  set_problem(c, Chain{.alpha = values[0], .beta = values[1]});
  return c;
}

Statement state(const std::string& id, const char* title, double alpha, double beta) {
  return {.id = id,
          .title = title,
          .tags = {"second_order", "separable", "mechanical", "oscillatory"},
          .make = [=] {
            return with_tabled_parameters(
                {{"alpha", alpha, "quadratic part of the springs"},
                 {"beta", beta, "cubic part of the springs"},
                 {"amplitude", 1, "of the first mode at the start"}},
                [=](const Values& values) { return make_case(id, values); });
          }};
}

}  // namespace

/// A nonlinear chain with its energy initially in the longest mode, and the recurrence.
std::vector<Statement> fput() {
  return {state("fput_alpha", "Fermi, Pasta, Ulam and Tsingou's chain, quadratic", 0.25, 0),
          state("fput_beta", "Fermi, Pasta, Ulam and Tsingou's chain, cubic", 0, 1)};
}

}  // namespace odeum::cases
