// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <utility>
#include <vector>

#include "odeum/control/lane_walk.hpp"
#include "odeum/problem/shared.hpp"
#include "odeum/solvers/lane_run.hpp"
#include "odeum/solvers/solver.hpp"

/// How an own method runs in lanes. The unit that compiles the method compiles this, too.
namespace odeum {

/// What kernels see of a LaneView.
class LaneOde {
 public:
  using real = Lanes;
  static constexpr std::size_t dimension = dynamic;

  explicit LaneOde(const LaneView& view) : view_(&view), constants_(view.constants, Lanes(0)) {}
  std::size_t size() const { return view_->dimension; }
  void rhs(const Lanes& t, const Lanes* y, Lanes* f) const { call(view_->rhs, t, y, f); }
  void jacobian(const Lanes& t, const Lanes* y, Lanes* j) const { call(view_->jacobian, t, y, j); }
  void time_derivative(const Lanes& t, const Lanes* y, Lanes* f) const {
    if (view_->time_derivative)
      call(view_->time_derivative, t, y, f);
    else
      std::fill(f, f + size(), Lanes(0));
  }
  Lanes& constant(std::size_t k) { return constants_[k]; }

 private:
  void call(LaneView::Function function, const Lanes& t, const Lanes* y, Lanes* f) const {
    const Lanes* const constants = constants_.data();
    function(&constants, &t, y, f);
  }
  const LaneView* view_;
  std::vector<Lanes> constants_;
};

/// Members of a family, see control/lanes_fixed_step.hpp.
class FamilyMembers {
 public:
  using Problem = LaneOde;
  /// `order`: of the estimate by which a run to a tolerance finds its first step.
  FamilyMembers(const LaneMembers& members, const Request& request, int order);

  Problem make() const { return LaneOde(members_.family.lanes); }
  bool next(std::size_t& member) { return (member = next_++) < members_.count; }
  std::uint64_t most_evaluations() const { return request_.budget.evaluations; }
  double first_step(std::size_t) const;  ///< of the member seated last
  void seat(std::size_t member, std::size_t lane, Problem& problem, State<Problem>& y);
  void leave(std::size_t member, const MemberEnd& end, const State<Problem>& y, std::size_t lane);
  std::vector<Outcome>& outcomes() { return outcomes_; }

 private:
  const LaneMembers& members_;
  const Request& request_;
  int order_;
  SharedOde alone_;
  std::vector<Outcome> outcomes_;
  std::vector<bool> fails_;  ///< whose values make no problem
  std::size_t next_ = 0;
};

template <class M>
std::vector<Outcome> run_members(const LaneMembers& all, const Request& request) {
  FamilyMembers members(all, request, std::min(M::info.order, M::info.order_embedded));
  const double t0 = all.family.t0, t1 = request.stops.back();
  if (request.mode == Mode::adaptive) {
    if constexpr (M::info.order_embedded != 0)
      run_adaptive_in_lanes<M>(members, t0, t1, request.tolerance);
  } else {
    constexpr std::size_t block = registers_together * Lanes::count;
    for (std::size_t first = 0; first < all.count; first += block)
      run_fixed_in_lanes<M>(members, first, std::min(all.count, first + block), t0, t1,
                            request.steps);
  }
  return std::move(members.outcomes());
}

/// Whether M runs so on the problem. A run at a fixed step by a Rosenbrock method remarks on what
/// grows, which the elimination in lanes does not see.
template <class M>
bool fits_lanes(Mode mode, const LaneFamily& family) {
  constexpr std::size_t most_unknowns = 64, most_eliminated = 16;
  const std::size_t n = family.lanes.dimension;
  if (!family.lanes.rhs || (mode == Mode::adaptive && M::info.order_embedded == 0)) return false;
  if constexpr (requires { M::rosenbrock_tableau; })
    return mode == Mode::adaptive && n <= most_eliminated && family.alone.jacobian &&
           !family.alone.sparsity;
  return n <= most_unknowns;
}

/// The member `lanes` of a Solver.
template <class M>
LaneRun lane_run_of(Mode mode, const LaneFamily& family) {
  return fits_lanes<M>(mode, family) ? run_members<M> : nullptr;
}

}  // namespace odeum
