// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>

#include "odeum/cases/inlined_for.hpp"
#include "odeum/core/guarded.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::cases::inlined {

/// Whether a view is that of a P: each type's view has functions of its own. Instantiated in a unit
/// that is not timed (cases/inlined/CMakeLists.txt), since these functions compute results too.
template <Ode P>
bool views(const OdeView& view);

/// The contest of a case whose problem is a P; no problem in it where the case has another.
template <Ode P>
Contest<Bare<P>> bare_contest(const Case& c) {
  Contest<Bare<P>> contest;
  if (!views<P>(c.problem.view)) return contest;
  contest.problem =
      std::make_shared<const Bare<P>>(Bare<P>{*static_cast<const P*>(c.problem.view.problem)});
  contest.t0 = c.t0;
  contest.y0 = c.problem.y0;
  return contest;
}

}  // namespace odeum::cases::inlined
