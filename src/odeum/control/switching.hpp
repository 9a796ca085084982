// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <optional>

#include "odeum/control/run_method.hpp"
#include "odeum/kernel/spectral_radius.hpp"

namespace odeum {

/// Trial steps by an explicit pair while its steps are bound by accuracy, and by a linearly
/// implicit one while they would be bound by stability (Petzold, SIAM J. Sci. Stat. Comput. 4
/// (1983) 136).
///
/// Every tenth accepted step an estimate of the spectral radius rho of the Jacobian is made: where
/// the explicit steps are at the edge of the stability region, h rho near `limit`, twice in a row,
/// the implicit pair takes over; where the implicit steps could be taken by the explicit pair with
/// room, likewise twice, it goes back. A pair that takes over begins anew, with the step at hand.
template <class Explicit, class Implicit, Ode P>
class SwitchingTrial {
 public:
  SwitchingTrial(const P& problem, const Tolerance& tolerance, double limit)
      : problem_(problem),
        tolerance_(tolerance),
        limit_(limit),
        radius_(problem),
        slope_(make_state(problem)) {}

  Decision operator()(double t, double h, const State<P>& y, State<P>& y_new) {
    prepare();
    const Decision decision = stiff_ ? (*implicit_)(t, h, y, y_new) : (*explicit_)(t, h, y, y_new);
    if (decision.accept && ++accepted_ % every == 0) look(t + h, h, y_new);
    return decision;
  }

  Status between(const StepMade<State<P>>& step, double time, State<P>& y) {
    return stiff_ ? implicit_->between(step, time, y) : explicit_->between(step, time, y);
  }

 private:
  template <class M>
  using Pair = EmbeddedPair<typename M::template Stepper<P>,
                            typename ControlFor<M::info.control>::type, P, M>;
  static constexpr int every = 10;

  /// Before a step: what it is made by. The one before is left until then, since outputs within the
  /// last step are its own.
  void prepare() {
    if (votes_ >= 2) {
      stiff_ = !stiff_;
      votes_ = 0;
      explicit_.reset();
      implicit_.reset();
    }
    if (stiff_ && !implicit_)
      implicit_.emplace(problem_, tolerance_, order_of<Implicit>());
    else if (!stiff_ && !explicit_)
      explicit_.emplace(problem_, tolerance_, order_of<Explicit>());
  }
  template <class M>
  static constexpr int order_of() {
    return std::min(M::info.order, M::info.order_embedded);
  }

  void look(double t, double h, const State<P>& y) {
    problem_.rhs(t, y.data(), slope_.data());
    const double z = h * radius_.look(t, y, slope_);
    votes_ = (stiff_ ? z < 0.5 * limit_ : z > 0.9 * limit_) ? votes_ + 1 : 0;
  }

  const P& problem_;
  Tolerance tolerance_;
  double limit_;
  std::optional<Pair<Explicit>> explicit_;
  std::optional<Pair<Implicit>> implicit_;
  SpectralRadius<P> radius_;
  State<P> slope_;
  int accepted_ = 0, votes_ = 0;
  bool stiff_ = false;
};

}  // namespace odeum
