// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string_view>
#include <type_traits>

#include "odeum/api/plain.hpp"
#include "odeum/control/run_method.hpp"
#include "odeum/kernel/dense_output.hpp"

/// States within a step.
namespace odeum {

/// How the state within a step of a method is found. An interpolant one order below the method
/// keeps its order, since the error of one interpolation does not accumulate.
enum class Inside {
  interpolant,  ///< the one of its trial steps
  hermite,      ///< Hermite's cubic, for explicit methods up to order 4; two evaluations a step
  restep,       ///< one step of the method from where the step began
  run,          ///< a run to the tolerance from where the step began, since the order varies
  none
};

/// Slopes at the ends of a step are as accurate as its states only where no equation is solved: on
/// a stiff problem f magnifies the error of the state a million times.
template <class M, class Problem>
constexpr bool slopes_are_accurate() {
  for (const std::string_view family : {"explicit_rk", "symplectic", "splitting", "nystroem"})
    if (M::info.family == family) return true;
  if constexpr (M::info.family == "multistep" && M::info.fixed_step) return !requires {
      M::template Stepper<Problem>::solves_equations;
    };
  return false;
}

template <class M, bool adaptive, class Trial, class Problem>
constexpr Inside inside_of() {
  if constexpr (requires { Trial::always_over_stops; }) return Inside::interpolant;
  const bool order_varies = adaptive && M::info.adaptive_order;
  if (!order_varies && M::info.order >= 1 && M::info.order <= 4 &&
      slopes_are_accurate<M, Problem>())
    return Inside::hermite;
  if (order_varies) return Inside::run;
  return M::info.one_step ? Inside::restep : Inside::none;
}

/// Stands for trial steps at fixed steps.
struct NoTrial {};

namespace detail {
/// Stands for a method whose steps are not needed.
struct NoMethod {
  template <class Problem>
  using Stepper = NoMethod;
};
}  // namespace detail

/// The last step of a run, from t0 and y0 to t1 and y1, as observers see it; for the thread of the
/// run. States have the problem's size.
template <class M, Ode P, class Trial>
class LastStep {
 public:
  using S = State<P>;
  using Problem = Plain<P>;
  static constexpr bool adaptive = !std::same_as<Trial, NoTrial>;
  static constexpr Inside inside = inside_of<M, adaptive, Trial, Problem>();

  LastStep(const Problem& problem, const Trial* trial, const Tolerance& tolerance)
      : problem_(problem), trial_(trial), tolerance_(tolerance), inner_(make_state(problem)) {
    end_state_ = inner_;
    if constexpr (inside == Inside::hermite) f0_.emplace(inner_), f1_ = f0_;
    if constexpr (inside == Inside::restep) stepper_.emplace(problem);
  }

  /// The step from (t0, y0) to (t1, y1), which stay valid until the next one.
  void set(double t0, const S& y0, double t1, const S& y1) {
    t0_ = t0, t1_ = end_ = t1, y0_ = &y0, y1_ = &y1;
    cut_ = slopes_known_ = false;
  }
  double begin() const { return t0_; }
  /// The end, and the state there: of the step, or where it was cut.
  double end() const { return end_; }
  const S& end_state() const { return cut_ ? end_state_ : *y1_; }
  bool cut() const { return cut_; }
  /// The run ends at t, within the step.
  Status cut_at(double t) {
    const Status status = at(t, inner_);
    end_state_ = inner_;
    end_ = t;
    cut_ = true;
    return status;
  }
  /// Room for a state, for the parts of a run.
  S& inner() { return inner_; }

  /// Fills y with the state at a time in [t0, t1]; the status of the step that finds it, after a
  /// failure of which y is not to be used.
  Status at(double t, S& y) {
    static_assert(inside != Inside::none,
                  "between the fixed steps of an implicit multistep method, or one above order 4, "
                  "no state of its order is known: choose the step so that it ends on the times");
    if (t == t1_ || t == t0_) {
      y = t == t1_ ? *y1_ : *y0_;
      return Status::ok;
    }
    if constexpr (inside == Inside::interpolant) {
      return trial_->between(StepMade<S>{t0_, t1_ - t0_, *y0_, *y1_}, t, y);
    } else if constexpr (inside == Inside::hermite) {
      return by_hermite(t, y);
    } else if constexpr (inside == Inside::restep) {
      y = *y0_;
      if constexpr (requires { stepper_->start(t, t, y); }) stepper_->start(t0_, t - t0_, y);
      return stepper_->step(t0_, t - t0_, y);
    } else {
      return by_run(t, y);
    }
  }

 private:
  using Real = RealOf<P>;
  using Stepper = typename std::conditional_t<inside == Inside::restep, M,
                                              detail::NoMethod>::template Stepper<Problem>;

  Status by_hermite(double t, S& y) {
    if (!slopes_known_) {
      problem_.rhs(static_cast<Real>(t0_), y0_->data(), f0_->data());
      problem_.rhs(static_cast<Real>(t1_), y1_->data(), f1_->data());
      slopes_known_ = true;
    }
    const double h = t1_ - t0_;
    cubic_hermite((t - t0_) / h, h, *y0_, *f0_, *y1_, *f1_, y);
    return Status::ok;
  }

  Status by_run(double t, S& y) {
    auto steps = trial_steps_of<M>(problem_, t0_, *y0_, t, tolerance_);
    AdaptiveWalk walk(problem_, t0_, *y0_, steps.first_step, steps.trial);
    while (walk.t() < t)
      if (walk.attempt(t) == Trialled::too_small) return Status::step_too_small;
    y = walk.y();
    return Status::ok;
  }

  const Problem& problem_;
  const Trial* trial_;
  Tolerance tolerance_;
  double t0_ = 0, t1_ = 0, end_ = 0;
  const S *y0_ = nullptr, *y1_ = nullptr;
  S inner_, end_state_;
  bool cut_ = false, slopes_known_ = false;
  std::optional<S> f0_, f1_;
  std::optional<Stepper> stepper_;
};

}  // namespace odeum
