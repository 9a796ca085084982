// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "odeum/core/lanes.hpp"
#include "odeum/core/status.hpp"
#include "odeum/problem/concepts.hpp"

/// Runs of many members of one problem, one in each lane of a vector register. What steps them is
/// the kernel of the method, as for a member alone; its numbers are Lanes. `Members` gives
///
///     using Problem = ...;                         // in lanes
///     Problem make() const;                        // for one register
///     void seat(std::size_t member, std::size_t lane, Problem&, State<Problem>& y);
///                                                  // its parameters and its state at the start
///     bool next(std::size_t& member);              // one that nobody has run; false: none is left
///     double first_step(std::size_t member);       // of an adaptive run, after seat()
///     std::uint64_t most_evaluations() const;      // likewise, after which a member is given up
///     void leave(std::size_t member, const MemberEnd&, const State<Problem>& y, std::size_t lane);
namespace odeum {

/// How the run of a member ended.
struct MemberEnd {
  Status status = Status::ok;
  double t = 0;
  std::uint64_t steps = 0, rejected_steps = 0, rhs_evaluations = 0;
};

/// So many registers at a time: while an operation on one waits for the operation before it, the
/// processor finds those on the others.
inline constexpr std::size_t registers_together = 4;

/// Methods that are run in lanes: explicit tableaus, Rosenbrock methods and DOP853.
template <class M>
concept RunsInLanes = requires {
  M::rosenbrock_tableau;
}
|| requires {
  M::tableau;
  requires M::tableau.is_explicit();
};

template <class M>
constexpr bool keeps_last_stage() {
  if constexpr (requires { M::tableau; }) return M::tableau.first_same_as_last();
  return false;
}

/// Evaluations of the right-hand side in a step, that at its start among them.
template <class M>
constexpr std::uint64_t evaluations_of_step() {
  if constexpr (requires { M::tableau; }) {
    return M::tableau.stages;
  } else {
    constexpr const auto& T = M::rosenbrock_tableau;
    std::uint64_t count = 1;
    for (const auto& row : T.a) count += std::ranges::any_of(row, [](double a) { return a != 0; });
    return count;
  }
}

/// One problem a register, and one state.
template <class P>
using Problems = std::array<P, registers_together>;
template <class P>
using StatesOf = std::array<State<P>, registers_together>;

template <class M, class P>
void equal_steps(const Problems<P>& problems, StatesOf<P>& states, double t0, double h,
                 std::uint64_t steps) {
  using Stepper = typename M::template Stepper<P>;
  const auto step = [&](Stepper& stepper, std::uint64_t i, State<P>& y) {
    stepper.step(t0 + static_cast<double>(i) * h, h, y);
  };
  if constexpr (P::dimension == dynamic) {
    std::vector<Stepper> steppers(problems.begin(), problems.end());
    for (std::uint64_t i = 0; i < steps; ++i)
      for (std::size_t r = 0; r < registers_together; ++r) step(steppers[r], i, states[r]);
  } else {
    // A stepper that lives for one step has its stages in registers.
    StatesOf<P> all = states;
    for (std::uint64_t i = 0; i < steps; ++i)
#pragma GCC unroll 4
      for (std::size_t r = 0; r < registers_together; ++r) {
        Stepper stepper(problems[r]);
        State<P> y = all[r];
        step(stepper, i, y);
        all[r] = y;
      }
    states = all;
  }
}

/// Members `first` to `last`, `registers_together` registers of them at most, in equal steps.
template <class M, class Members>
void run_fixed_in_lanes(Members& members, std::size_t first, std::size_t last, double t0, double t1,
                        std::uint64_t steps) {
  using P = typename Members::Problem;
  Problems<P> problems = [&]<std::size_t... I>(std::index_sequence<I...>) {
    return Problems<P>{((void)I, members.make())...};
  }
  (std::make_index_sequence<registers_together>{});
  StatesOf<P> states;
  for (std::size_t r = 0; r < registers_together; ++r) {
    states[r] = make_state(problems[r]);
    for (std::size_t lane = 0; lane < Lanes::count; ++lane)  // beyond the last one it is repeated
      members.seat(std::min(first + r * Lanes::count + lane, last - 1), lane, problems[r],
                   states[r]);
  }
  equal_steps<M>(problems, states, t0, (t1 - t0) / static_cast<double>(steps), steps);
  // The stage at the end of a step has no use where no estimate is asked for.
  const std::uint64_t evaluations =
      steps * (evaluations_of_step<M>() - (keeps_last_stage<M>() ? 1 : 0));
  for (std::size_t at = first; at < last; ++at) {
    const std::size_t row = (at - first) / Lanes::count, lane = (at - first) % Lanes::count;
    members.leave(at, {Status::ok, t1, steps, 0, evaluations}, states[row], lane);
  }
}

}  // namespace odeum
