// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <random>

#include "accuracy/wrong_solvers.hpp"

namespace odeum::tests {
namespace {

constexpr std::array<double, 4> magnitudes{1e-3, 1e-5, 1e-7, 1e-9};

struct FourStages {
  std::array<std::array<double, 4>, 4> a{};
  std::array<double, 4> b{}, c{};
};
constexpr FourStages classical{
    {{{}, {0.5}, {0, 0.5}, {0, 0, 1}}}, {1. / 6, 1. / 3, 1. / 3, 1. / 6}, {0, 0.5, 0.5, 1}};

/// What is done to a number on its way through a step.
using Change = std::function<double(double)>;
double unchanged(double x) { return x; }
double to_float(double x) { return static_cast<double>(static_cast<float>(x)); }

void take_step(const OdeView& problem, const FourStages& tableau, double t, double h, Vector& y,
               const Change& slope = unchanged) {
  const std::size_t n = y.size();
  std::array<Vector, 4> k;
  Vector stage(n);
  for (std::size_t s = 0; s < 4; ++s) {
    stage = y;
    for (std::size_t j = 0; j < s; ++j)
      for (std::size_t i = 0; i < n; ++i) stage[i] += h * tableau.a[s][j] * k[j][i];
    k[s].resize(n);
    problem.rhs(problem.problem, t + tableau.c[s] * h, stage.data(), k[s].data());
    for (double& x : k[s]) x = slope(x);
  }
  for (std::size_t s = 0; s < 4; ++s)
    for (std::size_t i = 0; i < n; ++i) y[i] += h * tableau.b[s] * k[s][i];
}

MakeStep with_stages(const FourStages& tableau) {
  return [tableau](const OdeView& problem) -> Step {
    return
        [=](std::uint64_t, double t, double h, Vector& y) { take_step(problem, tableau, t, h, y); };
  };
}

const MakeStep right_rk4 = with_stages(classical);

/// RK4 whose step is followed by `after`.
template <class After>
MakeStep rk4_then(After after) {
  return [after](const OdeView& problem) -> Step {
    return [=](std::uint64_t i, double t, double h, Vector& y) mutable {
      take_step(problem, classical, t, h, y);
      after(i, h, y);
    };
  };
}

/// RK4 but for the steps that `when` picks, which `other` takes.
template <class When, class Other>
MakeStep rk4_but(When when, Other other) {
  return [=](const OdeView& problem) -> Step {
    return [=](std::uint64_t i, double t, double h, Vector& y) {
      if (when(i))
        other(problem, t, h, y);
      else
        take_step(problem, classical, t, h, y);
    };
  };
}

void euler_step(const OdeView& problem, double t, double h, Vector& y) {
  Vector k(y.size());
  problem.rhs(problem.problem, t, y.data(), k.data());
  for (std::size_t i = 0; i < y.size(); ++i) y[i] += h * k[i];
}

MakeStep rk4_with_noise(double size) {
  return rk4_then([size, random = std::mt19937(1)](std::uint64_t, double, Vector& y) mutable {
    const auto range = static_cast<double>(std::mt19937::max());
    for (double& x : y) x += size * (2 * static_cast<double>(random()) / range - 1);
  });
}

/// Adams-Bashforth of order 4, its first three steps by RK4 or by Euler.
MakeStep adams_bashforth(bool started_well, double error) {
  return [=](const OdeView& problem) -> Step {
    return [=, past = std::vector<Vector>()](std::uint64_t i, double t, double h,
                                             Vector& y) mutable {
      Vector f(y.size());
      problem.rhs(problem.problem, t, y.data(), f.data());
      past.insert(past.begin(), f);
      if (past.size() > 4) past.pop_back();
      if (i < 3) {
        if (started_well)
          take_step(problem, classical, t, h, y);
        else
          euler_step(problem, t, h, y);
        return;
      }
      const std::array<double, 4> weights{55. / 24 + error, -59. / 24 - error, 37. / 24, -9. / 24};
      for (std::size_t j = 0; j < 4; ++j)
        for (std::size_t n = 0; n < y.size(); ++n) y[n] += h * weights[j] * past[j][n];
    };
  };
}

/// Velocity Verlet for y = [q, v]; `late`: the velocity is advanced with the old acceleration, or
/// the position with the velocity of the step before.
enum class Late { nothing, force, velocity };
MakeStep verlet(Late late) {
  return [late](const OdeView& problem) -> Step {
    return [=, before = Vector()](std::uint64_t, double t, double h, Vector& y) mutable {
      const std::size_t n = y.size() / 2;
      Vector f(y.size()), next(y.size());
      problem.rhs(problem.problem, t, y.data(), f.data());
      const Vector start = y;
      if (before.empty()) before = start;
      const Vector& velocity = late == Late::velocity ? before : start;
      for (std::size_t i = 0; i < n; ++i) y[i] += h * velocity[n + i] + h * h / 2 * f[n + i];
      problem.rhs(problem.problem, t + h, y.data(), next.data());
      const Vector& end = late == Late::force ? f : next;
      for (std::size_t i = n; i < 2 * n; ++i) y[i] += h / 2 * (f[i] + end[i]);
      before = start;
    };
  };
}

}  // namespace

std::vector<WrongSolver> wrong_coefficients() {
  std::vector<WrongSolver> solvers;
  for (const double error : magnitudes) {
    const auto add = [&](const std::string& place, const FourStages& tableau) {
      solvers.push_back(
          {fmt::format("RK4, {} off by {:.0e}", place, error), 4, with_stages(tableau), right_rk4});
    };
    for (std::size_t i = 0; i < 4; ++i) {
      FourStages t = classical;
      t.b[i] += error;
      add(fmt::format("b{}", i + 1), t);
      if (i == 0) continue;
      t = classical;
      t.c[i] += error;
      add(fmt::format("c{}", i + 1), t);
      for (std::size_t j = 0; j < i; ++j) {
        t = classical;
        t.a[i][j] += error;
        add(fmt::format("a{}{}", i + 1, j + 1), t);
      }
    }
    for (std::size_t i = 2; i < 4; ++i) {
      FourStages t = classical;
      t.a[i][i - 2] += error;
      t.a[i][i - 1] -= error;
      add(fmt::format("a{}{}, row sum kept,", i + 1, i - 1), t);
      t = classical;
      t.a[i][i - 1] += error;
      t.c[i] += error;
      add(fmt::format("a{}{} and c{}", i + 1, i, i + 1), t);
    }
    for (std::size_t i = 0; i + 1 < 4; ++i) {
      FourStages t = classical;
      t.b[i] += error;
      t.b[i + 1] -= error;
      add(fmt::format("b{}, sum kept,", i + 1), t);
    }
  }
  return solvers;
}

std::vector<WrongSolver> wrong_explicit_steps() {
  std::vector<WrongSolver> solvers;
  const auto add = [&](std::string name, const MakeStep& wrong) {
    solvers.push_back({std::move(name), 4, wrong, right_rk4});
  };
  add("RK4, state rounded to float", rk4_then([](std::uint64_t, double, Vector& y) {
        for (double& x : y) x = to_float(x);
      }));
  add("RK4, slopes rounded to float", [](const OdeView& problem) -> Step {
    return [=](std::uint64_t, double t, double h, Vector& y) {
      take_step(problem, classical, t, h, y, to_float);
    };
  });
  add("RK4, time rounded to float", [](const OdeView& problem) -> Step {
    return [=](std::uint64_t, double t, double h, Vector& y) {
      take_step(problem, classical, to_float(t), h, y);
    };
  });
  add("RK4, a step late in time", [](const OdeView& problem) -> Step {
    return [=](std::uint64_t, double t, double h, Vector& y) {
      take_step(problem, classical, t - h, h, y);
    };
  });
  FourStages no_nodes = classical;
  no_nodes.c = {};
  add("RK4, time stands still in a step", with_stages(no_nodes));
  // Order 4 on linear autonomous problems alone.
  add("RK4, Jameson's four stages in its place",
      with_stages(
          {{{{}, {0.25}, {0, 1. / 3}, {0, 0, 0.5}}}, {0, 0, 0, 1}, {0, 0.25, 1. / 3, 0.5}}));
  const auto nothing = [](const OdeView&, double, double, Vector&) {};
  add("RK4, first step dropped", rk4_but([](std::uint64_t i) { return i == 0; }, nothing));
  add("RK4, eighth step dropped", rk4_but([](std::uint64_t i) { return i == 7; }, nothing));
  add("RK4, first step by Euler", rk4_but([](std::uint64_t i) { return i == 0; }, euler_step));
  add("RK4, each tenth step by Euler",
      rk4_but([](std::uint64_t i) { return i % 10 == 9; }, euler_step));
  for (const double size : {1e-7, 1e-9, 1e-11})
    add(fmt::format("RK4, noise of {:.0e} a step", size), rk4_with_noise(size));
  for (const double pace : {3., 11.})
    add(fmt::format("RK4, error constant oscillates with {} log h", pace),
        rk4_then([pace](std::uint64_t, double h, Vector& y) {
          for (double& x : y) x += std::pow(h, 5) * (1 + std::sin(pace * std::log(h)));
        }));
  solvers.push_back({"Adams-Bashforth 4, started by Euler", 4, adams_bashforth(false, 0),
                     adams_bashforth(true, 0)});
  for (const double error : {1e-4, 1e-7})
    solvers.push_back({fmt::format("Adams-Bashforth 4, weights off by {:.0e}", error), 4,
                       adams_bashforth(true, error), adams_bashforth(true, 0)});
  solvers.push_back({"Verlet, late force", 2, verlet(Late::force), verlet(Late::nothing), true});
  solvers.push_back(
      {"Verlet, late velocity", 2, verlet(Late::velocity), verlet(Late::nothing), true});
  return solvers;
}

}  // namespace odeum::tests
