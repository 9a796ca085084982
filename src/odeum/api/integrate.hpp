// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <tuple>

#include "odeum/api/between.hpp"
#include "odeum/api/parts.hpp"

/// Integration with one of Odeum's methods in a program of one's own: headers only.
///
///     #include <odeum/api/integrate.hpp>
///     #include <odeum/methods/dormand_prince54.hpp>
///
///     struct Pendulum {
///       static constexpr std::size_t dimension = 2;
///       void rhs(double, const double* y, double* dydt) const {
///         dydt[0] = y[1];
///         dydt[1] = -std::sin(y[0]);
///       }
///     };
///     std::array<double, 2> y{1, 0};
///     const auto run = odeum::integrate(Pendulum{}, odeum::methods::dormand_prince54{}, y, 0, 10,
///                                       odeum::Tolerance{1e-8});
///
/// A problem is any struct of problem/concepts.hpp: with `using real = float` for single precision
/// (explicit Runge-Kutta methods and velocity_verlet), with odeum::dynamic and size() where its
/// dimension is known at run time, with a Jacobian for implicit methods (else by differences). No
/// step allocates memory, except within extrapolation methods where a state inside of a step is
/// asked for.
namespace odeum {

/// Equal steps. h > 0, in the problem's unit of time, is reduced to the next length of which a
/// whole number ends at t1.
struct Step {
  double h;
};
// Steps chosen by the method: Tolerance{r} holds errors to r (1 + |y|), Tolerance{r, a} to
// a + r |y|, with one number a or a vector of one a component (core/tolerance.hpp).

/// How a run ended. `t` is the time reached; y is the state there.
struct RunEnd {
  Status status = Status::ok;  ///< step_too_small, newton_failed, non_finite
  double t = 0;
  std::uint64_t steps = 0, rejected_steps = 0, rhs_evaluations = 0;
  bool stopped = false;  ///< by an observer, at t
  bool event = false;    ///< until_event ended it, at t
  bool ok() const { return status == Status::ok; }
};

namespace detail {

/// The end of a run and the parts that hear of its steps.
template <class Last, class... Parts>
class Watch {
 public:
  Watch(Last& last, RunEnd& end, Parts&... parts) : last_(last), end_(end), parts_(parts...) {}

  template <class S>
  void begin(double t0, const S& y0) {
    for_each([&](auto& part) {
      if constexpr (requires { part.begin(t0, y0); }) part.begin(t0, y0);
    });
  }

  /// After a step; false where the run is over.
  template <class S>
  bool operator()(double t0, const S& y0, double t1, const S& y1) {
    last_.set(t0, y0, t1, y1);
    for_each([&](auto& part) {
      if constexpr (requires { part.cut(last_, end_.status); }) {
        if (end_.status == Status::ok) part.cut(last_, end_.status);
        end_.event = end_.event || part.happened();
      }
    });
    for_each([&](auto& part) {
      if constexpr (requires { part.report(last_, end_.status); })
        if (end_.status == Status::ok && !part.report(last_, end_.status)) end_.stopped = true;
    });
    end_.t = last_.end();
    return end_.ok() && !end_.event && !end_.stopped;
  }

 private:
  template <class F>
  void for_each(F&& f) {
    std::apply([&](auto&... part) { (f(part), ...); }, parts_);
  }

  Last& last_;
  RunEnd& end_;
  std::tuple<Parts&...> parts_;
};

template <class S>
bool all_finite(const S& y) {
  typename S::value_type sum = 0;
  for (const auto& x : y) sum += x * 0;
  return sum == 0;
}

inline void require(bool sound, const char* what) {
  if (!sound) throw std::invalid_argument(what);
}

/// How many equal steps end at t1.
inline std::uint64_t whole_steps(double t0, double t1, Step step) {
  require(step.h > 0 && std::isfinite(step.h), "a step has to be positive and finite");
  const double count = std::ceil((t1 - t0) / step.h * (1 - 1e-12));
  require(count < 1e15, "the step is too small for the interval");
  return static_cast<std::uint64_t>(std::max(count, 1.0));
}
inline void require_sound(const Tolerance& tolerance, std::size_t size) {
  require(tolerance.sound_for(size),
          "a tolerance has to be positive and finite, an absolute one a number or a vector of the "
          "state's size");
}

template <class M, Ode P>
void require_fit(const P& problem, const State<P>& y, double t0, double t1) {
  static_assert(M::template fits<Plain<P>>,
                "the problem lacks what the method needs, see `needs` of the method");
  if constexpr (requires { M::fits_problem(problem); })
    require(M::fits_problem(problem), "the problem lacks what the method needs, see its `needs`");
  require(y.size() == size_of(problem), "the state has another size than the problem");
  require(std::isfinite(t0) && std::isfinite(t1) && t1 > t0, "t1 has to be finite and after t0");
}

}  // namespace detail

/// Integrates y from t0 to t1 > t0 in equal steps by method M. `y` has the problem's size: the
/// state at t0, then that at RunEnd::t. Throws std::invalid_argument for a malformed request; a
/// numerical failure is a status. All functions are called on this thread, and what they throw
/// passes through. Several threads may run at once where the problem's functions allow it.
template <class M, Ode P, class... Parts>
RunEnd integrate(const P& problem, M, State<P>& y, double t0, double t1, Step step,
                 Parts... parts) {
  static_assert(M::info.fixed_step, "this method chooses its own steps: give a Tolerance");
  detail::require_fit<M>(problem, y, t0, t1);
  const std::uint64_t steps = detail::whole_steps(t0, t1, step);
  const double h = (t1 - t0) / static_cast<double>(steps);

  const Plain<P> seen(problem);
  typename M::template Stepper<Plain<P>> stepper(seen);
  RunEnd end;
  end.t = t0;
  LastStep<M, P, NoTrial> last(seen, nullptr, 0);
  detail::Watch watch(last, end, parts...);
  using Real = RealOf<P>;
  State<P> before = y;
  const auto time = [&](std::uint64_t i) {
    return i == steps ? t1 : t0 + static_cast<double>(i) * h;
  };
  if constexpr (requires { stepper.start(t0, h, y); })
    stepper.start(static_cast<Real>(t0), static_cast<Real>(h), y);
  watch.begin(t0, y);
  for (bool go_on = true; go_on && end.steps < steps;) {
    const double t = time(end.steps);
    if constexpr (sizeof...(Parts) > 0) before = y;
    end.status = stepper.step(static_cast<Real>(t), static_cast<Real>(h), y);
    if (end.ok() && !detail::all_finite(y)) end.status = Status::non_finite;
    if (!end.ok()) break;
    go_on = watch(t, before, time(++end.steps), y);
  }
  if (last.cut()) y = last.end_state();
  end.rhs_evaluations = seen.evaluations();
  return end;
}

/// The same to a tolerance, in steps that the method chooses. An absolute tolerance is in the units
/// of the components.
template <class M, Ode P, class... Parts>
RunEnd integrate(const P& problem, M, State<P>& y, double t0, double t1, const Tolerance& tolerance,
                 Parts... parts) {
  static_assert(has_trial_steps<M>, "this method runs at fixed steps only: give a Step");
  detail::require_fit<M>(problem, y, t0, t1);
  detail::require_sound(tolerance, y.size());
  Plain<P> seen(problem);
  seen.weigh_by(tolerance);
  auto steps = trial_steps_of<M>(seen, t0, y, t1, tolerance);
  using Trial = decltype(steps.trial);
  AdaptiveWalk walk(seen, t0, y, steps.first_step, steps.trial);
  RunEnd end;
  end.t = t0;
  LastStep<M, P, Trial> last(seen, &steps.trial, tolerance);
  detail::Watch watch(last, end, parts...);
  watch.begin(t0, y);
  for (bool go_on = true; go_on && walk.t() < t1;) {
    const double t = walk.t();
    const Trialled trialled = walk.attempt(t1);
    if (trialled == Trialled::too_small) end.status = Status::step_too_small;
    if (!end.ok()) break;
    if (trialled == Trialled::rejected) {
      ++end.rejected_steps;
      continue;
    }
    ++end.steps;
    go_on = watch(t, walk.before(), walk.t(), walk.y());
  }
  y = last.cut() ? last.end_state() : walk.y();
  end.rhs_evaluations = seen.evaluations();
  return end;
}

}  // namespace odeum
