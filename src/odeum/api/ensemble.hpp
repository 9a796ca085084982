// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <type_traits>
#include <vector>

#include "odeum/api/integrate.hpp"
#include "odeum/control/lane_walk.hpp"
#include "odeum/core/parallel.hpp"

/// Many members of one small problem at once, in the lanes of vector registers: headers only.
///
///     #include <odeum/api/ensemble.hpp>
///     #include <odeum/methods/rk4.hpp>
///
///     template <class Real>
///     struct Lorenz {
///       using real = Real;
///       static constexpr std::size_t dimension = 3;
///       Real s{10}, r{28}, b{8. / 3};
///       void rhs(Real, const Real* y, Real* dydt) const {
///         dydt[0] = s * (y[1] - y[0]);
///         dydt[1] = y[0] * (r - y[2]) - y[1];
///         dydt[2] = y[0] * y[1] - b * y[2];
///       }
///     };
///     std::vector<Lorenz<double>> members = ...;
///     std::vector<std::array<double, 3>> states = ...;  // one a member, at the start
///     const auto ends = odeum::integrate_ensemble(members, odeum::methods::rk4{}, states, 0, 10,
///                                                 odeum::Step{1e-3});  // and then at the end
///
/// The problem is a template on its number type, which is double or odeum::Lanes, and all of its
/// data are numbers of that type, one a member. Functions are called without std:: after
/// `using std::sin;`, and select(x < y, a, b) stands for x < y ? a : b. Lanes are as wide as the
/// target's registers (-march).
///
/// Methods: explicit Runge-Kutta methods, with a Tolerance those with an embedded pair, and
/// Rosenbrock methods with one, for which the problem has `jacobian` and either `time_derivative`
/// or `static constexpr bool autonomous() { return true; }`.
///
/// A member's result does not depend on the others. It has the bits of odeum::integrate where the
/// compiler joins no product and sum (-ffp-contract=off) and the linear systems have at most 3
/// unknowns; else it differs by rounding.
namespace odeum {

namespace detail {

/// Members whose parameters and states are given as arrays.
template <template <class> class P, class M>
class GivenMembers {
 public:
  using Problem = P<Lanes>;
  using Scalar = P<double>;
  GivenMembers(const std::vector<Scalar>& members, std::vector<State<Scalar>>& states)
      : members_(members), states_(states), ends_(members.size()) {}
  void begin(double t0, double t1, const Tolerance& tolerance) {
    t0_ = t0, t1_ = t1, tolerance_ = &tolerance;
  }

  Problem make() const { return Problem{}; }
  bool next(std::size_t& member) { return (member = next_++) < members_.size(); }
  static constexpr std::uint64_t most_evaluations() { return UINT64_MAX; }
  double first_step(std::size_t member) const {
    constexpr int order = std::min(M::info.order, M::info.order_embedded);
    return initial_step(members_[member], t0_, states_[member], t1_, order, *tolerance_);
  }
  void seat(std::size_t member, std::size_t lane, Problem& problem, State<Problem>& y) const {
    for (std::size_t n = 0; n < y.size(); ++n) y[n].set(lane, states_[member][n]);
    if constexpr (!std::is_empty_v<Scalar>) {
      constexpr std::size_t numbers = sizeof(Scalar) / sizeof(double);
      static_assert(std::is_trivially_copyable_v<Problem> &&
                        sizeof(Scalar) == numbers * sizeof(double) &&
                        sizeof(Problem) == numbers * sizeof(Lanes),
                    "the data of an ensemble's problem have to be numbers of its type alone");
      const auto from = std::bit_cast<std::array<double, numbers>>(members_[member]);
      auto to = std::bit_cast<std::array<Lanes, numbers>>(problem);
      for (std::size_t k = 0; k < numbers; ++k) to[k].set(lane, from[k]);
      problem = std::bit_cast<Problem>(to);
    }
  }
  void leave(std::size_t member, const MemberEnd& end, const State<Problem>& y, std::size_t lane) {
    State<Scalar> last{};
    for (std::size_t n = 0; n < y.size(); ++n) last[n] = y[n][lane];
    RunEnd& run = ends_[member];
    run = {.status = end.status, .t = end.t, .steps = end.steps};
    run.rejected_steps = end.rejected_steps;
    run.rhs_evaluations = end.rhs_evaluations;
    if (run.ok() && !all_finite(last))
      run.status = Status::non_finite;
    else
      states_[member] = last;
  }
  std::vector<RunEnd>& ends() { return ends_; }

 private:
  const std::vector<Scalar>& members_;
  std::vector<State<Scalar>>& states_;
  std::vector<RunEnd> ends_;
  std::atomic<std::size_t> next_{0};
  double t0_ = 0, t1_ = 0;
  const Tolerance* tolerance_ = nullptr;
};

template <class M, template <class> class P>
void require_fit_of_all(const std::vector<P<double>>& members,
                        const std::vector<State<P<double>>>& states, double t0, double t1) {
  static_assert(RunsInLanes<M>, "no method for lanes: an explicit tableau or a Rosenbrock method");
  static_assert(Ode<P<Lanes>> && std::is_same_v<typename P<Lanes>::real, Lanes>,
                "the problem has to be a template on its number type, and name it as `real`");
  if constexpr (requires { M::rosenbrock_tableau; })
    static_assert(
        WithJacobian<P<Lanes>> && (NonAutonomous<P<Lanes>> || requires { P<Lanes>::autonomous(); }),
        "a Rosenbrock method needs jacobian, and time_derivative or autonomous()");
  require(members.size() == states.size(), "an ensemble needs a state for each member");
  if (!members.empty()) require_fit<M>(members.front(), states.front(), t0, t1);
}

}  // namespace detail

/// Integrates each member from t0 to t1 in equal steps, on `jobs` threads, which call the functions
/// of the problem at once. `states`: one a member, at t0, then at the time of its RunEnd; returns
/// one RunEnd a member, in their order. Throws std::invalid_argument for a malformed request; a
/// numerical failure is the status of a member.
template <template <class> class P, class M>
std::vector<RunEnd> integrate_ensemble(const std::vector<P<double>>& members, M method,
                                       std::vector<State<P<double>>>& states, double t0, double t1,
                                       Step step, unsigned jobs = 1) {
  static_assert(M::info.fixed_step, "this method chooses its own steps: give a Tolerance");
  detail::require_fit_of_all<M, P>(members, states, t0, t1);
  const std::uint64_t steps = detail::whole_steps(t0, t1, step);
  detail::GivenMembers<P, M> given(members, states);
  constexpr std::size_t block = registers_together * Lanes::count;
  parallel_for((members.size() + block - 1) / block, jobs, [&](std::size_t k) {
    run_fixed_in_lanes<M>(given, k * block, std::min(members.size(), (k + 1) * block), t0, t1,
                          steps);
  });
  // A member that failed still has its state at the start: alone it tells when.
  for (std::size_t k = 0; k < members.size(); ++k)
    if (!given.ends()[k].ok())
      given.ends()[k] = integrate(members[k], method, states[k], t0, t1, step);
  return std::move(given.ends());
}

/// The same to a tolerance: each member in steps of its own.
template <template <class> class P, class M>
std::vector<RunEnd> integrate_ensemble(const std::vector<P<double>>& members, M,
                                       std::vector<State<P<double>>>& states, double t0, double t1,
                                       const Tolerance& tolerance, unsigned jobs = 1) {
  static_assert(M::info.order_embedded != 0, "adaptive runs in lanes need an embedded pair");
  detail::require_fit_of_all<M, P>(members, states, t0, t1);
  if (members.empty()) return {};
  detail::require_sound(tolerance, states.front().size());
  detail::GivenMembers<P, M> given(members, states);
  given.begin(t0, t1, tolerance);
  parallel_for(jobs, jobs,
               [&](std::size_t) { run_adaptive_in_lanes<M>(given, t0, t1, tolerance); });
  return std::move(given.ends());
}

}  // namespace odeum
