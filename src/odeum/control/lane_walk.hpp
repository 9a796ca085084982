// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cstring>
#include <optional>

#include "odeum/control/lanes_fixed_step.hpp"
#include "odeum/control/run_method.hpp"
#include "odeum/linear/lane_system.hpp"

/// Runs of many members to a tolerance, see lanes_fixed_step.hpp.
namespace odeum {

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
        scale_(tolerance, y_) {
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) take_next(lane);
  }

  /// A trial step of each member; false where none is left.
  bool attempt() {
    bool any = false;
    std::array<double, Lanes::count> t{}, h{};
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
      Seat& seat = seats_[lane];
      while (seat.taken && !seat.clock.begin(t1_)) replace(lane, Status::step_too_small);
      any = any || seat.taken;
      t[lane] = seat.clock.t();
      h[lane] = seat.clock.used();
    }
    if (!any) return false;
    const Lanes now = lanes_of(t), step = lanes_of(h);
    if constexpr (keeps_last_stage<M>()) know_first_stages(now);
    copy_components(y_, y_new_);
    stepper_.step(now, step, y_new_, error_);
    decide_all(scaled_error_square(error_, y_, y_new_, scale_));
    return true;
  }

 private:
  using Control = typename ControlFor<M::info.control>::type;
  struct Seat {
    bool taken = false, knows_first = false;
    std::size_t member = 0;
    StepClock clock{0, 0};
    std::optional<Control> control{};
    MemberEnd end{};
  };
  static Lanes lanes_of(const std::array<double, Lanes::count>& numbers) {
    Lanes lanes;
    std::memcpy(&lanes, numbers.data(), sizeof(lanes));
    return lanes;
  }

  void take_next(std::size_t lane) {
    Seat& seat = seats_[lane];
    seat.taken = members_.next(seat.member);
    if (!seat.taken) return;
    members_.seat(seat.member, lane, problem_, y_);
    seat.clock = StepClock(t0_, members_.first_step(seat.member));
    seat.control.emplace(order);
    seat.end = MemberEnd{.rhs_evaluations = 2};  // of the first step
    seat.knows_first = false;
    fresh_.set(lane, true);
    any_fresh_ = true;
  }
  void replace(std::size_t lane, Status status) {
    Seat& seat = seats_[lane];
    seat.end.status = status;
    seat.end.t = seat.clock.t();
    members_.leave(seat.member, seat.end, y_, lane);
    take_next(lane);
  }

  /// First same as last: the first stage is known, but for members that begin.
  void know_first_stages(const Lanes& t) {
    if (any_fresh_) {
      problem_.rhs(t, y_.data(), y_new_.data());
      State<P>& first = stepper_.first_stage();
      each_component(y_, [&](std::size_t n) { first[n] = select(fresh_, y_new_[n], first[n]); });
      fresh_ = LaneMask{};
      any_fresh_ = false;
    }
    stepper_.repeat();
  }

  void decide_all(const Lanes& square) {
    std::array<double, Lanes::count> squares;
    std::memcpy(squares.data(), &square, sizeof(square));
    LaneMask accepted{};
    bool ended = false;
    for (std::size_t lane = 0; lane < Lanes::count; ++lane) {
      Seat& seat = seats_[lane];
      if (!seat.taken) continue;
      const double used = seat.clock.used();
      const bool accept = seat.clock.end(decide(*seat.control, used, squares[lane]));
      accepted.set(lane, accept);
      seat.end.rhs_evaluations += evaluations_of_step<M>() - (seat.knows_first ? 1 : 0);
      seat.knows_first = keeps_last_stage<M>() || !accept;
      ++(accept ? seat.end.steps : seat.end.rejected_steps);
      ended = ended || seat.clock.t() >= t1_;
    }
    each_component(y_, [&](std::size_t n) { y_[n] = select(accepted, y_new_[n], y_[n]); });
    if constexpr (keeps_last_stage<M>()) {
      State<P>& first = stepper_.first_stage();
      const State<P>& last = stepper_.last_stage();
      each_component(y_, [&](std::size_t n) { first[n] = select(accepted, last[n], first[n]); });
    }
    if (!ended) return;
    for (std::size_t lane = 0; lane < Lanes::count; ++lane)
      if (seats_[lane].taken && seats_[lane].clock.t() >= t1_) replace(lane, Status::ok);
  }

  Members& members_;
  double t0_, t1_;
  P problem_;
  typename M::template Stepper<P> stepper_;
  State<P> y_, y_new_, error_;
  ErrorScale<State<P>> scale_;
  std::array<Seat, Lanes::count> seats_{};
  LaneMask fresh_{};
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
