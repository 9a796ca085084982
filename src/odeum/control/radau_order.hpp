// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <utility>
#include <variant>

#include "odeum/control/radau_control.hpp"

namespace odeum {

/// Trial steps by Radau IIA methods of ascending order, by which of them the contraction of
/// Newton's iteration says (Hairer, Wanner, J. Comput. Appl. Math. 111 (1999) 93-111, section 5):
/// where it is small the next higher one takes as few iterations, and longer steps; where it is
/// close to 1, or the iteration fails twice in a row, the next lower one converges at longer steps.
/// A method that takes over begins anew, with the step at hand.
template <Ode P, class... Trials>
class RadauOrderTrial {
 public:
  RadauOrderTrial(const P& problem, const Tolerance& tolerance)
      : problem_(problem),
        tolerance_(tolerance),
        trial_(std::in_place_index<0>, problem, tolerance) {}

  Decision operator()(double t, double h, const State<P>& y, State<P>& y_new) {
    // The one before is left until now, since outputs within the last step are its own.
    if (trial_.index() != wanted_) take(std::index_sequence_for<Trials...>());
    return std::visit(
        [&](auto& trial) {
          const Decision decision = trial(t, h, y, y_new);
          look(decision.accept, trial.contraction());
          return decision;
        },
        trial_);
  }

  Status between(const StepMade<State<P>>& step, double time, State<P>& y) const {
    return std::visit([&](const auto& trial) { return trial.between(step, time, y); }, trial_);
  }

 private:
  static constexpr double raise_below = 0.002, lower_above = 0.8;
  static constexpr int kept = 10;  ///< steps by one method, at least

  template <std::size_t... I>
  void take(std::index_sequence<I...>) {
    ((I == wanted_ ? void(trial_.template emplace<I>(problem_, tolerance_)) : void()), ...);
    steps_ = failures_ = 0;
  }

  void look(bool accepted, double contraction) {
    failures_ = !accepted && contraction >= lower_above ? failures_ + 1 : 0;
    if (accepted) ++steps_;
    const std::size_t made = trial_.index();
    if (made > 0 && (failures_ > 1 || (steps_ > kept && contraction > lower_above)))
      wanted_ = made - 1;
    else if (accepted && steps_ > kept && contraction < raise_below && made + 1 < sizeof...(Trials))
      wanted_ = made + 1;
  }

  const P& problem_;
  Tolerance tolerance_;
  std::variant<Trials...> trial_;
  std::size_t wanted_ = 0;        ///< which of them
  int steps_ = 0, failures_ = 0;  ///< accepted by it; in a row
};

}  // namespace odeum
