// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/set_problem.hpp"
#include "problems/two_species.hpp"

namespace odeum::cases {
namespace {

/// u_i' = left u_{i-1} + middle u_i + right u_{i+1} - 100 u_i v_i, v_i' = -100 u_i v_i.
struct MedAkzoCells {
  static constexpr std::size_t cells = 200;
  static constexpr double rate = 100, length = 4;
  std::vector<double> left, middle, right;

  MedAkzoCells() {
    const auto n = static_cast<double>(cells);
    for (std::size_t j = 1; j <= cells; ++j) {
      const double z = static_cast<double>(j) / n - 1;
      const double alpha = 2 * z * z * z / (length * length),
                   beta = z * z * z * z / (length * length);
      left.push_back(beta * n * n - alpha * n / 2);
      middle.push_back(-2 * beta * n * n);
      right.push_back(beta * n * n + alpha * n / 2);
    }
  }
  static double u_before() { return 2; }
  static double v_before() { return 0; }
  static double u_after(double u_last) { return u_last; }
  static double v_after(double) { return 0; }
  void cell(std::size_t i, double u_left, double, double u, double v, double u_right, double,
            double* f) const {
    const double reaction = rate * u * v;
    f[0] = left[i] * u_left + middle[i] * u + right[i] * u_right - reaction;
    f[1] = -reaction;
  }
  void slopes(std::size_t i, double u, double v, double* s) const {
    s[0] = left[i];
    s[1] = middle[i] - rate * v + (i + 1 == cells ? right[i] : 0);
    s[2] = -rate * u;
    s[3] = right[i];
    s[4] = s[7] = 0;
    s[5] = -rate * v;
    s[6] = -rate * u;
  }
};

Case make_medakzo() {
  Case c;
  c.nature.stiff = true;
  c.equation =
      "u_j' = alpha_j (u_{j+1} - u_{j-1}) / (2 d) + beta_j (u_{j-1} - 2 u_j + u_{j+1}) / d^2 - 100 "
      "u_j v_j, v_j' = -100 u_j v_j, j = 1..200, d = 1/200, alpha_j = (j d - 1)^3 / 8, beta_j = "
      "(j d - 1)^4 / 16, u_0 = 2, u_201 = u_200, u(0) = 0, v(0) = 1";
  c.source = "Test Set for IVP Solvers, Medical Akzo Nobel problem, without the jump at t = 5";
  for (std::size_t j = 0; j < MedAkzoCells::cells; ++j) {
    c.y0.push_back(0);
    c.y0.push_back(1);
  }
  c.stops = {1, 2, 3, 4, 5};
  c.settings.steps_multiple = 5;
  c.settings.coarsest_steps = 160;
  c.settings.finest_steps = 5120;
  c.settings.evaluation_budget = 30'000;
  c.truth = reference_truth("medakzo", 5e-15);
  set_problem(c, TwoSpecies<MedAkzoCells>(MedAkzoCells()));
  return c;
}

}  // namespace

/// Antibodies that enter tissue, up to t = 5, where the supply would end with a jump.
std::vector<Statement> medakzo() {
  return {{.id = "medakzo",
           .title = "Medical Akzo Nobel problem",
           .tags = {"diffusion"},
           .make = make_medakzo}};
}

}  // namespace odeum::cases
