// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "accuracy/tableau_steps.hpp"
#include "accuracy/wrong_solvers.hpp"

namespace odeum::tests {
namespace {

double truncated(double x, int digits) {
  const double unit = std::pow(10, digits);
  return std::trunc(x * unit) / unit;
}
Tableau truncated(Tableau t, int digits) {
  for (auto& row : t.a)
    for (double& x : row) x = truncated(x, digits);
  for (double& x : t.b) x = truncated(x, digits);
  for (double& x : t.c) x = truncated(x, digits);
  return t;
}

struct Named {
  const char* name;
  double order;
  Tableau tableau;
};
const std::vector<Named>& methods() {
  static const std::vector<Named> all{{"Euler", 1, euler()},
                                      {"midpoint", 2, midpoint()},
                                      {"Ralston 2", 2, ralston2()},
                                      {"Kutta 3", 3, kutta3()},
                                      {"three eighths", 4, three_eighths()},
                                      {"DOPRI5", 5, dormand_prince5()}};
  return all;
}
const Named& of_order(double order) {
  for (const Named& m : methods())
    if (m.order == order) return m;
  return methods().back();
}

/// (1 - weight) of one method's step and `weight` of another's.
MakeStep mixed(const Tableau& most, const Tableau& rest, double weight) {
  return [=](const OdeView& problem) -> Step {
    return [=](std::uint64_t, double t, double h, Vector& y) {
      Vector other = y;
      take_step(problem, most, t, h, y);
      take_step(problem, rest, t, h, other);
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += weight * (other[i] - y[i]);
    };
  };
}

MakeStep alternating(const Tableau& most, const Tableau& rest, std::uint64_t period) {
  return [=](const OdeView& problem) -> Step {
    return [=](std::uint64_t i, double t, double h, Vector& y) {
      take_step(problem, i % period == period - 1 ? rest : most, t, h, y);
    };
  };
}

/// Steps to which something happens before and after.
using Before = std::function<void(double& t, double& h)>;
using After = std::function<void(const Vector& start, double h, Vector& y)>;
MakeStep disturbed(const Tableau& tableau, const Before& before, const After& after) {
  return [=](const OdeView& problem) -> Step {
    return [=](std::uint64_t, double t, double h, Vector& y) {
      const Vector start = y;
      before(t, h);
      take_step(problem, tableau, t, h, y);
      after(start, h, y);
    };
  };
}

}  // namespace

std::vector<WrongSolver> right_tableaus() {
  std::vector<WrongSolver> solvers;
  for (const Named& m : methods()) {
    const MakeStep step = with_tableau(m.tableau);
    solvers.push_back({m.name, m.order, step, step});
  }
  const auto add = [&](const char* name, double order, const Tableau& tableau) {
    const MakeStep step = with_tableau(tableau);
    solvers.push_back({name, order, step, step});
  };
  add("Heun 2", 2, {{{}, {1}}, {0.5, 0.5}, {0, 1}});
  add("SSP 3", 3, {{{}, {1}, {0.25, 0.25}}, {1. / 6, 1. / 6, 2. / 3}, {0, 1, 0.5}});
  add("Heun 3", 3, {{{}, {1. / 3}, {0, 2. / 3}}, {0.25, 0, 0.75}, {0, 1. / 3, 2. / 3}});
  add("Ralston 3", 3, {{{}, {0.5}, {0, 0.75}}, {2. / 9, 1. / 3, 4. / 9}, {0, 0.5, 0.75}});
  add("Nyström 3", 3, {{{}, {2. / 3}, {0, 2. / 3}}, {0.25, 0.375, 0.375}, {0, 2. / 3, 2. / 3}});
  return solvers;
}

std::vector<WrongSolver> wrong_tableaus() {
  std::vector<WrongSolver> solvers;
  const auto add = [&](const Named& m, const std::string& fault, const MakeStep& wrong) {
    solvers.push_back(
        {fmt::format("{}, {}", m.name, fault), m.order, wrong, with_tableau(m.tableau)});
  };
  for (const Named& m : methods()) {
    if (m.order < 2) continue;
    for (const int digits : {2, 3, 4, 6})
      add(m, fmt::format("coefficients cut to {} digits", digits),
          with_tableau(truncated(m.tableau, digits)));
    for (const double weight : {1e-1, 1e-3, 1e-5}) {
      const Named& lower = of_order(m.order - 1);
      add(m, fmt::format("{:.0e} of {} mixed in", weight, lower.name),
          mixed(m.tableau, lower.tableau, weight));
    }
    const Named& lower = of_order(m.order - 1);
    solvers.push_back({fmt::format("{} claims {:g}", lower.name, m.order), m.order,
                       with_tableau(lower.tableau), with_tableau(m.tableau)});
    for (const std::uint64_t period : {std::uint64_t{2}, std::uint64_t{20}})
      add(m, fmt::format("each {}th step by {}", period, lower.name),
          alternating(m.tableau, lower.tableau, period));
  }
  const Named& five = methods().back();
  for (std::size_t i = 1; i < five.tableau.a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (five.tableau.a[i][j] == 0) continue;
      Tableau t = five.tableau;
      t.a[i][j] = -t.a[i][j];
      add(five, fmt::format("a{}{} of the other sign", i + 1, j + 1), with_tableau(t));
    }
  for (std::size_t i = 1; i < five.tableau.c.size(); ++i) {
    Tableau t = five.tableau;
    t.c[i] += 1e-3;
    add(five, fmt::format("c{} off by 1e-3", i + 1), with_tableau(t));
  }
  for (std::size_t i = 2; i < five.tableau.b.size(); ++i) {
    Tableau t = five.tableau;
    t.b[i] += 1e-4;
    t.b[0] -= 1e-4;
    add(five, fmt::format("b{} off by 1e-4, sum kept", i + 1), with_tableau(t));
  }
  const Before nothing = [](double&, double&) {};
  const After keeps = [](const Vector&, double, Vector&) {};
  for (const double error : {1e-4, 1e-7})
    add(five, fmt::format("steps longer by {:.0e} than time", error),
        disturbed(
            five.tableau, [=](double&, double& h) { h *= 1 + error; }, keeps));
  add(five, "time half a step early",
      disturbed(
          five.tableau, [](double& t, double& h) { t -= h / 2; }, keeps));
  for (const double digits : {6., 9., 12.})
    add(five, fmt::format("states rounded to {:g} decimals", digits),
        disturbed(five.tableau, nothing, [=](const Vector&, double, Vector& y) {
          for (double& x : y) x = std::round(x * std::pow(10, digits)) / std::pow(10, digits);
        }));
  add(five, "changes below 1e-6 dropped",
      disturbed(five.tableau, nothing, [](const Vector& start, double, Vector& y) {
        for (std::size_t i = 0; i < y.size(); ++i)
          if (std::abs(y[i] - start[i]) < 1e-6) y[i] = start[i];
      }));
  for (const double power : {2., 3., 4., 5.})
    add(five, fmt::format("h^{:g} of the state added", power),
        disturbed(five.tableau, nothing, [=](const Vector&, double h, Vector& y) {
          for (double& x : y) x *= 1 + 1e-2 * std::pow(h, power);
        }));
  return solvers;
}

}  // namespace odeum::tests
