// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/core/status.hpp"
#include "odeum/kernel/method.hpp"
#include "odeum/problem/shifted_solver.hpp"

namespace odeum::methods {

/// Velocity Verlet for the forces without damping, and the trapezoidal rule for the damping, in a
/// symmetric splitting of q'' = a(t, q) + d(t, q, v):
///
///     v += h/2 a_n,   q += h/2 v,   v += h/2 (d(v) + d(v')) =: v' - v,   q += h/2 v,
///     v += h/2 a_{n+1}.
///
/// Stiff damping does not limit the step; the elastic forces do as they limit velocity Verlet. One
/// evaluation of a and one step of the damping a step; without damping it is velocity Verlet.
struct imex_verlet {
  static constexpr bool leaves_out_ends = false;  ///< not looked at: it evaluates parts of f
  static constexpr MethodInfo info{
      .id = "imex_verlet",
      .family = "splitting",
      .order = 2,
      .source =
          "Strang, SIAM J. Numer. Anal. 5 (1968) 506-517; order of the parts as in "
          "Leimkuhler, Matthews, Appl. Math. Res. Express 2013, 34-56 (BAOAB)"};
  static constexpr std::string_view needs =
      "a second-order problem with damping that can be computed apart from the other forces";
  template <class P>
  static constexpr bool fits = WithDamping<P>;
  template <class P>
  static bool fits_problem(const P& problem) {
    return offers_damp(problem);
  }

  template <class P>
  class Stepper {
   public:
    using Real = RealOf<P>;

    /// The error of each change of v by the damping falls to `relative` of it.
    explicit Stepper(const P& problem, double relative = ShiftedSolver::exact)
        : problem_(problem), a_(make_state(problem)), relative_(relative) {}

    void start(Real t, Real /*h*/, const State<P>& y) {
      problem_.undamped_acceleration(t, y.data(), a_.data());
    }

    Status step(Real t, Real h, State<P>& y) {
      const std::size_t n = y.size() / 2;
      Real *const q = y.data(), *const v = q + n, half = h / 2;
      for (std::size_t i = 0; i < n; ++i) {
        v[i] += half * a_[i];
        q[i] += half * v[i];
      }
      problem_.damp(t + half, q, h, v, relative_);
      for (std::size_t i = 0; i < n; ++i) q[i] += half * v[i];
      problem_.undamped_acceleration(t + h, q, a_.data());
      for (std::size_t i = 0; i < n; ++i) v[i] += half * a_[i];
      return Status::ok;
    }

   private:
    const P& problem_;
    State<P> a_;
    double relative_;
  };

  static OscillatorMap oscillator_map(double w) {
    return {1 - w * w / 2, w, -w * (1 - w * w / 4), 1 - w * w / 2};
  }
};

}  // namespace odeum::methods
