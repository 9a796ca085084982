// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <utility>

#include "odeum/core/guard.hpp"
#include "odeum/problem/shifted_solver.hpp"

namespace odeum {

/// A problem's own solver of linear systems, whose work counts against a guard's budget.
class CountedSolver final : public ShiftedSolver {
 public:
  CountedSolver(std::unique_ptr<ShiftedSolver> solver, Guard& guard)
      : solver_(std::move(solver)), guard_(guard) {}

  bool factorise(double t, const double* y, double gamma_h) override {
    return counting([&] { return solver_->factorise(t, y, gamma_h); });
  }
  bool solve(double* x, double relative) override {
    return counting([&] { return solver_->solve(x, relative); });
  }
  void solve_once_a_step() override { solver_->solve_once_a_step(); }
  bool bound() override { return solver_->bound(); }
  std::uint64_t products() const override { return solver_->products(); }

 private:
  template <class Work>
  bool counting(Work&& work) {
    const std::uint64_t before = solver_->products();
    const bool done = work();
    guard_.count_products(solver_->products() - before);
    return done;
  }

  std::unique_ptr<ShiftedSolver> solver_;
  Guard& guard_;
};

/// Null where the problem has no solver of its own.
inline std::unique_ptr<ShiftedSolver> counted(std::unique_ptr<ShiftedSolver> solver, Guard& guard) {
  if (!solver) return nullptr;
  return std::make_unique<CountedSolver>(std::move(solver), guard);
}

}  // namespace odeum
