// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/scene_system.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace odeum::truth {
namespace {

using scene::SceneProblem;

constexpr std::size_t few_springs = 64;  // of more, sums in extended precision take too long

/// Springs in line or in a grid pull a particle to both sides, so that their forces cancel, and
/// moving all coordinates in one proportion, as for other systems, tells nothing about the rounding
/// of each: here every coordinate moves by itself.
class SceneInsight final : public Insight {
 public:
  SceneInsight(std::function<void(Real, const Real*, Real*)> rhs, Real unit)
      : rhs_(std::move(rhs)), unit_(unit) {}

  Inside look(Real, Real, const State&, const State&) override { return {}; }
  bool rounding(Real t, const State& y, State& bound) override {
    constexpr Real amplified = 0x1p11L;  // so that the change of f is above its rounding
    const std::size_t n = y.size();
    State f(n), moved(n), f_moved(n);
    rhs_(t, y.data(), f.data());
    for (int draw = 0; draw < 3; ++draw) {
      for (std::size_t i = 0; i < n; ++i) {
        bits_ = bits_ * 6364136223846793005U + 1442695040888963407U;  // Knuth's generator
        moved[i] = y[i] * (1 + ((bits_ >> 63U) != 0 ? amplified : -amplified) * unit_);
      }
      rhs_(t, moved.data(), f_moved.data());
      for (std::size_t i = 0; i < n; ++i)
        bound[i] = std::max(bound[i], std::abs(f_moved[i] - f[i]) / amplified);
    }
    return true;
  }

 private:
  std::function<void(Real, const Real*, Real*)> rhs_;
  Real unit_;
  std::uint64_t bits_ = 1;
};

}  // namespace

System system_of(const std::shared_ptr<const SceneProblem>& problem) {
  System system;
  const std::size_t n = system.states = problem->size();
  const scene::Structure& structure = problem->structure();
  system.y0.assign(problem->start().begin(), problem->start().end());
  system.smooth = structure.smooth();
  system.concurrent = true;
  if (problem->plain() && problem->springs().size() <= few_springs) {
    system.rhs = scene::extended_problem(*problem->scene()).f;
  } else {
    system.rounding = 0x1p-53L;
    system.rhs =
        widened(n, n, [problem](double t, const double* y, double* f) { problem->rhs(t, y, f); });
  }
  if (n <= most_in_matrix)
    system.jacobian = widened(n, n * n, [problem, n](double t, const double* y, double* j) {
      std::vector<double> unit(n), column(n);
      for (std::size_t k = 0; k < n; ++k) {
        unit[k] = 1;
        problem->jacobian_times(t, y, unit.data(), column.data());
        unit[k] = 0;
        for (std::size_t i = 0; i < n; ++i) j[i * n + k] = column[i];
      }
    });
  system.work = work_of(*problem);
  system.insight = [rhs = system.rhs, rounding = system.rounding](Real) {
    return std::make_unique<SceneInsight>(rhs, rounding);
  };
  return system;
}

double work_of(const SceneProblem& problem) {
  double work = 20 * static_cast<double>(problem.size());
  for (const scene::TermInfo& term : problem.structure().terms) {
    const double each = term.name == "contact_particles" ? 500 : 30;  // pairs are searched for
    work += each * static_cast<double>(term.count);
  }
  return work;
}

}  // namespace odeum::truth
