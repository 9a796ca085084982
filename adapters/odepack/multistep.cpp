// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>

#include "odepack/run.hpp"

namespace odeum::adapters::odepack {
namespace {

void rhs(const int*, const double* t, const double* y, double* dydt, double* problem, const int*) {
  Problem::of(problem).rhs(*t, y, dydt);
}

void jacobian(const int*, const double* t, const double* y, const int*, const int*, double* j,
              const int* rows, double* problem, const int*) {
  Problem::of(problem).fill(*t, y, j, *rows);
}

Status status_of(int state) {
  switch (state) {
    case -1:
      return Status::over_budget;
    case -2:
    case -4:
      return Status::step_too_small;
    case -5:
      return Status::newton_failed;
    default:
      return Status::refused;
  }
}

const char* meaning_of(int state) {
  switch (state) {
    case -1:
      return "excess work in one call";
    case -2:
      return "the tolerances ask for more than the precision of double";
    case -3:
      return "illegal input";
    case -4:
      return "repeated error test failures, or steps below the rounding of t";
    case -5:
      return "repeated convergence failures of the corrector";
    case -6:
      return "an error weight became zero";
    default:
      return "too little work space, or another error";
  }
}

/// One run: the arguments of the integrators under the names of their documentation.
class Run {
 public:
  Run(const MultistepMethod& method, const ErasedContest& contest, const Request& request,
      Problem& problem)
      : method_(method),
        request_(request),
        problem_(problem),
        t_(contest.t0),
        y_(*contest.y0),
        relative_(request.tolerance.relative),
        absolute_(problem.absolute(request.tolerance)) {
    const bool vode = method.run == &Library::vode;
    const int n = problem.size(), lower = problem.lower(), upper = problem.upper();
    // Documented numbers: 10 for the functional iteration, 1 for a full matrix, 4 for a band, and 5
    // for a band by their own differences.
    const int by_matrix = problem.has_jacobian() ? (problem.banded() ? 4 : 1) : 5;
    if (method.switches)
      method_flag_ = by_matrix;
    else
      method_flag_ = method.stiff ? 20 + by_matrix : 10;
    std::size_t matrix = 0;
    if (method.stiff || method.switches)
      matrix = problem.banded() ? static_cast<std::size_t>(vode ? 3 * lower + 2 * upper + 2
                                                                : 2 * lower + upper + 1)
                                : static_cast<std::size_t>(vode ? 2 * n : n);
    // As the documentation of each asks for, at most: the histories of 12 orders.
    work_.resize(22 + static_cast<std::size_t>(n) * (17 + matrix));
    integers_.resize(30 + static_cast<std::size_t>(n));
    integers_[0] = lower;
    integers_[1] = upper;
    // Each call makes one step, which ends on the last stop at the latest.
    work_[0] = request.stops.back();
  }

  void to_the_end(Outcome& outcome) {
    std::size_t stop = 0;
    double end = t_;
    int stuck = 0;
    while (stop < request_.stops.size()) {
      const int state = step();
      outcome.counters.steps = static_cast<std::uint64_t>(integers_[10]);
      if (method_.run == &Library::vode)
        outcome.counters.rejected_steps = static_cast<std::uint64_t>(integers_[20] + integers_[21]);
      if (state != 2) return fail(state, outcome);
      if (!is_finite(y_.data(), y_.size())) return outcome.record(t_, y_.data(), y_.size());
      // They warn that t + h is t, and go on for as long as they may.
      stuck = t_ - end > 4e-16 * std::abs(t_) ? 0 : stuck + 1;
      if (stuck == 10) return fail(-4, outcome);
      if (request_.record_steps && t_ > end) outcome.step_ends.push_back(t_);
      end = t_;
      for (; stop < request_.stops.size() && request_.stops[stop] <= t_; ++stop)
        record(request_.stops[stop], outcome);
    }
  }

 private:
  int step() {
    int n = problem_.size(), kind = absolute_.size() > 1 ? 2 : 1, one_step = 5, optional = 1;
    int work_length = static_cast<int>(work_.size()),
        integers_length = static_cast<int>(integers_.size()), nothing = 0;
    double end = request_.stops.back();
    (library().*method_.run)(rhs, &n, y_.data(), &t_, &end, &kind, &relative_, absolute_.data(),
                             &one_step, &state_, &optional, work_.data(), &work_length,
                             integers_.data(), &integers_length, jacobian, &method_flag_,
                             problem_.pointer(), &nothing);
    return state_;
  }

  void record(double stop, Outcome& outcome) {
    if (stop == t_) return outcome.record(stop, y_.data(), y_.size());
    std::vector<double> inside(y_.size());
    int derivative = 0, n = problem_.size(), flag = 0;
    constexpr std::size_t history = 20;
    (library().*method_.interpolate)(&stop, &derivative, work_.data() + history, &n, inside.data(),
                                     &flag);
    outcome.record(stop, inside.data(), inside.size());
  }

  void fail(int state, Outcome& outcome) const {
    outcome.status = status_of(state);
    outcome.t = t_;
    outcome.detail = fmt::format("{} returned istate = {} ({}) at t = {}", method_.name, state,
                                 meaning_of(state), t_);
  }

  const MultistepMethod& method_;
  const Request& request_;
  Problem& problem_;
  double t_;
  std::vector<double> y_;
  double relative_;
  std::vector<double> absolute_, work_;
  std::vector<int> integers_;
  int method_flag_ = 0, state_ = 1;
};

}  // namespace

Outcome solve(const MultistepMethod& method, const ErasedContest& contest, const Request& request) {
  if (request.mode == Mode::fixed)
    return refused(fmt::format("{} has no fixed-step mode", method.name));
  if (contest.view.dimension == 0) return refused("the library has no vectors of length 0");
  Library& all = library();
  if (!all.failure.empty()) return refused(all.failure);
  const std::lock_guard alone(all.in_use);  // before the clock of the budget starts
  Problem problem(contest, request);
  if ((method.stiff || method.switches) && problem.too_large())
    return dense_over_budget(contest.view.dimension);
  Outcome outcome;
  try {
    Run(method, contest, request, problem).to_the_end(outcome);
  } catch (const Left& left) {
    outcome.status = left.status;
  }
  problem.guarded().guard().conclude(request, outcome);
  return outcome;
}

}  // namespace odeum::adapters::odepack
