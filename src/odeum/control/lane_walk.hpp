// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>

#include "odeum/control/lane_clock.hpp"
#include "odeum/control/lanes_fixed_step.hpp"
#include "odeum/control/run_method.hpp"
#include "odeum/linear/lane_system.hpp"

/// Runs of many members to a tolerance, see lanes_fixed_step.hpp.
namespace odeum {

/// So many, made of one argument each.
template <class T, std::size_t count>
std::array<T, count> filled_with(int argument) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array<T, count>{((void)I, T(argument))...};
  }
  (std::make_index_sequence<count>{});
}

/// One register of members, each with a step of its own; a lane whose member has ended takes the
/// next one.
template <class M, class Members>
class LaneWalk {
 public:
  using P = typename Members::Problem;
  static constexpr int order = std::min(M::info.order, M::info.order_embedded);

  LaneWalk(Members& members, double t0, double t1, const Tolerance& tolerance)
      : members_(members),
        t0_(t0),
        t1_(t1),
        problem_(members.make()),
        stepper_(problem_),
        y_(make_state(problem_)),
        y_new_(y_),
        error_(y_),
        scale_(tolerance, y_),
        controls_(filled_with<Control, Lanes::count>(order)),
        most_attempts_(most_attempts(members.most_evaluations())) {
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) take_next(lane);
  }

  /// A trial step of each member; false where none is left.
  bool attempt() {
    if (!begin_all()) return false;
    if constexpr (keeps_last_stage<M>()) know_first_stages();
    copy_components(y_, y_new_);
    stepper_.step(clock_.t(), clock_.used(), y_new_, error_);
    end_all(scaled_error_square(error_, y_, y_new_, scale_));
    return true;
  }

 private:
  /// The whole steps that a budget of evaluations allows.
  static double most_attempts(std::uint64_t evaluations) {
    const std::uint64_t whole =
        evaluations / std::max<std::uint64_t>(evaluations_of_step<M>() - 1, 1);
    return 1 + static_cast<double>(whole);
  }

  using Control = typename ControlFor<M::info.control>::type;
  static constexpr bool remembers = !std::is_invocable_v<const Control&, double, double>;
  using Numbers = std::array<double, Lanes::count>;

  bool begin_all() {
    for (LaneMask sound = clock_.begin(t1_); !all(sound); sound = clock_.begin(t1_))
      for (std::size_t lane = 0; lane < Lanes::count; ++lane)
        if (!sound[lane]) replace(lane, Status::step_too_small);
    return any(taken_);
  }

  void end_all(const Lanes& square) {
    const LaneMask finite = abs(square) <= std::numeric_limits<double>::max();
    const LaneMask accept = taken_ & finite & (square <= 1);
    clock_.end(accept, select(finite, next_steps(square), clock_.used() / 4));
    each_component(y_, [&](std::size_t n) { y_[n] = select(accept, y_new_[n], y_[n]); });
    if constexpr (keeps_last_stage<M>()) {
      State<P>& first = stepper_.first_stage();
      const State<P>& last = stepper_.last_stage();
      each_component(y_, [&](std::size_t n) { first[n] = select(accept, last[n], first[n]); });
    }
    attempts_ += 1;
    steps_ += select(accept, Lanes(1), 0);
    repeats_ += select(rejected_, Lanes(1), 0);
    rejected_ = !accept;
    const LaneMask going = (clock_.t() < t1_) & (attempts_ < most_attempts_);
    if (all(going)) return;
    for (std::size_t lane = 0; lane < Lanes::count; ++lane)
      if (!going[lane]) replace(lane, clock_.t()[lane] >= t1_ ? Status::ok : Status::over_budget);
  }

  /// Asks the controller of each member; all lanes in one loop where it remembers nothing.
  Lanes next_steps(const Lanes& square) {
    Numbers squares = square.numbers(), next = clock_.used().numbers();
    if constexpr (!remembers) {
      const Control& control = controls_.front();
#pragma GCC unroll 1  // it becomes vector code, which an unrolled loop does not
      for (std::size_t lane = 0; lane < Lanes::count; ++lane)
        next[lane] = control(next[lane], squares[lane]).next_step;
    } else {
      for (std::size_t lane = 0; lane < Lanes::count; ++lane)
        if (std::isfinite(squares[lane]))
          next[lane] = controls_[lane](next[lane], squares[lane]).next_step;
    }
    return Lanes::of(next);
  }

  void take_next(std::size_t lane) {
    taken_.set(lane, members_.next(numbers_[lane]));
    // A lane without a member makes the same step again and again.
    double first_step = t1_ - t0_;
    if (taken_[lane]) {
      members_.seat(numbers_[lane], lane, problem_, y_);
      first_step = members_.first_step(numbers_[lane]);
    }
    clock_.set(lane, t0_, first_step);
    if constexpr (remembers) {
      std::destroy_at(&controls_[lane]);
      std::construct_at(&controls_[lane], order);
    }
    for (Lanes* count : {&attempts_, &steps_, &repeats_}) count->set(lane, 0);
    rejected_.set(lane, false);
    fresh_.set(lane, true);
    any_fresh_ = true;
  }
  void replace(std::size_t lane, Status status) {
    if (taken_[lane]) {
      const auto count = [&](const Lanes& of) { return static_cast<std::uint64_t>(of[lane]); };
      // A first stage that is known is not evaluated: first same as last, or after a rejection.
      const std::uint64_t tried = count(attempts_),
                          known = keeps_last_stage<M>() && tried > 0 ? tried - 1 : count(repeats_);
      const MemberEnd end{status, clock_.t()[lane], count(steps_), tried - count(steps_),
                          2 + tried * evaluations_of_step<M>() - known};
      members_.leave(numbers_[lane], end, y_, lane);
    }
    take_next(lane);
  }

  /// First same as last: the first stage is known, but for members that begin.
  void know_first_stages() {
    if (any_fresh_) {
      problem_.rhs(clock_.t(), y_.data(), y_new_.data());
      State<P>& first = stepper_.first_stage();
      each_component(y_, [&](std::size_t n) { first[n] = select(fresh_, y_new_[n], first[n]); });
      fresh_ = LaneMask{};
      any_fresh_ = false;
    }
    stepper_.repeat();
  }

  Members& members_;
  double t0_, t1_;
  P problem_;
  typename M::template Stepper<P> stepper_;
  State<P> y_, y_new_, error_;
  ErrorScale<State<P>> scale_;
  std::array<std::size_t, Lanes::count> numbers_{};  ///< of the members
  std::array<Control, Lanes::count> controls_;
  LaneClock clock_;
  LaneMask taken_{}, rejected_{}, fresh_{};
  Lanes attempts_ = 0, steps_ = 0, repeats_ = 0;
  double most_attempts_;
  bool any_fresh_ = false;
};

/// Members to a tolerance, until none is left; several threads may share the members.
template <class M, class Members>
void run_adaptive_in_lanes(Members& members, double t0, double t1, const Tolerance& tolerance) {
  std::array<std::optional<LaneWalk<M, Members>>, registers_together> walks;
  for (auto& walk : walks) walk.emplace(members, t0, t1, tolerance);
  for (bool any = true; any;) {
    any = false;
    for (auto& walk : walks) any = walk->attempt() || any;
  }
}

}  // namespace odeum
