// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>

#include "odeum/core/status.hpp"
#include "odeum/kernel/iteration.hpp"
#include "odeum/linear/shifted_solver.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum {

/// Newton's method for y = base + gamma_h f(t, y): the equation of every diagonally implicit stage
/// and of every implicit multistep formula. The factors are kept between calls, for other stages
/// and steps, as long as gamma_h is the same and the iteration converges fast; slow convergence
/// triggers a new Jacobian (Hairer, Wanner, Solving ODEs II, IV.8).
template <Ode P>
class Newton {
 public:
  explicit Newton(const P& problem)
      : problem_(problem),
        system_(problem),
        correction_(make_state(problem)),
        guess_(correction_),
        increment_(correction_) {}

  /// From now on iterate to `fraction` of a tolerance (relative and absolute, the same number), and
  /// fail early where convergence is too slow, since the step will be retried shorter. Without it
  /// the iteration goes on to rounding.
  void solve_to(double tolerance, double fraction) {
    accuracy_ = tolerance * fraction;
    max_iterations_ = 10;
  }

  /// On entry y is the guess, on return the solution. newton_failed where the iteration does not
  /// converge or the matrix is singular.
  Status solve(double t, double gamma_h, const State<P>& base, State<P>& y) {
    bool fresh = false;
    if (gamma_h != factored_for_ && !renew(t, gamma_h, y, fresh)) return Status::newton_failed;
    guess_ = y;
    restart(base, y);
    double last = 0;
    int since_renewal = 0;
    for (int iteration = 0; iteration < max_iterations_; ++iteration) {
      problem_.rhs(t, y.data(), correction_.data());
      for (std::size_t i = 0; i < y.size(); ++i)
        correction_[i] = gamma_h * correction_[i] - increment_[i];
      if (!system_.solve(correction_.data(), correction_accuracy)) return fail();
      // Not y = base + increment: at a stiff step base is far larger than y, whose digits would be
      // lost.
      for (std::size_t i = 0; i < y.size(); ++i) {
        increment_[i] += correction_[i];
        y[i] += correction_[i];
      }
      const double size = measure(base, y);
      const bool rate_known = since_renewal > 0;
      const double rate = rate_known ? size / last : 0;
      const bool done =
          accuracy_ == 0 ? at_rounding(size, rate, rate_known)
                         : size <= 1 || (rate_known && rate < 1 && size * rate / (1 - rate) <= 1);
      if (done) return Status::ok;
      const bool slow = since_renewal > 0 && rate > (fresh ? slow_fresh : slow_kept);
      if (!std::isfinite(size) || rate >= 1) {
        // Not finite or diverging: if the Jacobian was a reused one, restart from the guess.
        if (fresh && (accuracy_ > 0 || !std::isfinite(size))) return fail();
        if (!fresh) restart(base, y);
      }
      if (slow || !std::isfinite(size)) {
        if (!renew(t, gamma_h, y, fresh)) return Status::newton_failed;
        since_renewal = 0;
      } else {
        ++since_renewal;
      }
      last = size;
    }
    return fail();
  }

  /// y - base of the last solution, to its own precision.
  const State<P>& increment() const { return increment_; }

 private:
  // A contraction above this triggers a new Jacobian: earlier for a reused one, since the next
  // steps profit too.
  static constexpr double slow_kept = 0.05, slow_fresh = 0.1;

  bool renew(double t, double gamma_h, const State<P>& y, bool& fresh) {
    fresh = true;
    system_.linearise(t, y);
    factored_for_ = system_.factorise(gamma_h) ? gamma_h : 0;
    return factored_for_ == gamma_h;
  }
  void restart(const State<P>& base, State<P>& y) {
    y = guess_;
    for (std::size_t i = 0; i < y.size(); ++i) increment_[i] = y[i] - base[i];
  }
  Status fail() {
    factored_for_ = 0;
    return Status::newton_failed;
  }
  /// Size of the correction; one is small enough.
  double measure(const State<P>& base, const State<P>& y) const {
    if (accuracy_ == 0) {
      const double size = max_norm(correction_);
      if (size == 0) return 0;  // the state may be zero too
      return size / (iteration_tolerance * std::max({max_norm(y), max_norm(base), smallest_state}));
    }
    double sum = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double scaled = correction_[i] / (accuracy_ * (1 + std::abs(base[i])));
      sum += scaled * scaled;
    }
    return std::sqrt(sum / static_cast<double>(y.size()));
  }

  const P& problem_;
  ShiftedSystem<P> system_;
  State<P> correction_, guess_;
  State<P> increment_;       ///< gamma_h f: rounded by itself, not as the state that it is added to
  double factored_for_ = 0;  ///< gamma_h of the factors; 0: none
  double accuracy_ = 0;
  int max_iterations_ = 50;
};

}  // namespace odeum
