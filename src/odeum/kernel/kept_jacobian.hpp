// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/simplified_newton.hpp"

namespace odeum {

/// Says when a Jacobian and its factors are renewed, for kernels whose steps are retried: an
/// iteration that diverges starts again from its guess with a new Jacobian, and fails where the
/// Jacobian was new.
class KeptJacobian {
 public:
  /// `factorise(gamma_h)`: false where the matrix is singular. `attempt()`: one Newton iteration.
  template <class Linearise, class Factorise, class Attempt>
  bool solve(double gamma_h, Linearise&& linearise, Factorise&& factorise, Attempt&& attempt) {
    while (true) {
      if (wanted_) {
        linearise();
        wanted_ = false;
        fresh_ = true;
        factored_for_ = 0;
      }
      if (gamma_h != factored_for_) {
        factored_for_ = 0;
        if (!factorise(gamma_h)) return false;
        factored_for_ = gamma_h;
      }
      const NewtonVerdict verdict = attempt();
      if (fresh_ || verdict != NewtonVerdict::diverges) return verdict == NewtonVerdict::done;
      wanted_ = true;
    }
  }
  /// After a step, or where the next attempt is at another state; `wanted`: with a new Jacobian.
  void moved(bool wanted) {
    fresh_ = false;
    wanted_ = wanted;
  }
  void renew_unless_fresh() { wanted_ = wanted_ || !fresh_; }

 private:
  double factored_for_ = 0;  ///< 0: no factors
  bool wanted_ = true, fresh_ = false;
};

}  // namespace odeum
