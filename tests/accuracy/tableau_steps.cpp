// SPDX-License-Identifier: BSD-3-Clause
#include "accuracy/tableau_steps.hpp"

namespace odeum::tests {

Tableau euler() { return {{{}}, {1}, {0}}; }
Tableau midpoint() { return {{{}, {0.5}}, {0, 1}, {0, 0.5}}; }
Tableau ralston2() { return {{{}, {2. / 3}}, {0.25, 0.75}, {0, 2. / 3}}; }
Tableau kutta3() { return {{{}, {0.5}, {-1, 2}}, {1. / 6, 2. / 3, 1. / 6}, {0, 0.5, 1}}; }
Tableau three_eighths() {
  return {{{}, {1. / 3}, {-1. / 3, 1}, {1, -1, 1}},
          {0.125, 0.375, 0.375, 0.125},
          {0, 1. / 3, 2. / 3, 1}};
}
Tableau dormand_prince5() {
  return {{{},
           {1. / 5},
           {3. / 40, 9. / 40},
           {44. / 45, -56. / 15, 32. / 9},
           {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
           {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656}},
          {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84},
          {0, 0.2, 0.3, 0.8, 8. / 9, 1},
          {5179. / 57600, 0, 7571. / 16695, 393. / 640, -92097. / 339200, 187. / 2100, 1. / 40}};
}

std::vector<Vector> take_step(const OdeView& problem, const Tableau& tableau, double t, double h,
                              Vector& y) {
  const std::size_t n = y.size();
  std::vector<Vector> k(tableau.b.size(), Vector(n));
  Vector stage(n);
  for (std::size_t s = 0; s < k.size(); ++s) {
    stage = y;
    for (std::size_t j = 0; j < s; ++j)
      for (std::size_t i = 0; i < n; ++i) stage[i] += h * tableau.a[s][j] * k[j][i];
    problem.rhs(problem.problem, t + tableau.c[s] * h, stage.data(), k[s].data());
  }
  for (std::size_t s = 0; s < k.size(); ++s)
    for (std::size_t i = 0; i < n; ++i) y[i] += h * tableau.b[s] * k[s][i];
  return k;
}

MakeStep with_tableau(const Tableau& tableau) {
  return [tableau](const OdeView& problem) -> Step {
    return
        [=](std::uint64_t, double t, double h, Vector& y) { take_step(problem, tableau, t, h, y); };
  };
}

}  // namespace odeum::tests
