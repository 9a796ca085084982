// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <concepts>

#include "odeum/problem/shared.hpp"
#include "odeum/solvers/solver.hpp"

namespace odeum {

template <class P>
concept Shared = std::derived_from<P, SharedOde>;

/// A contest whose problem is of one of the shared types; P has to be one that the view offers.
template <Shared P>
Contest<P> shared_contest(const ErasedContest& erased) {
  return {std::make_shared<const P>(erased.view, erased.keep_alive), erased.t0, erased.y0,
          erased.scene};
}

/// Calls visit.template operator()<P>() with the shared type that shows most of a problem.
template <class Visit>
void with_shared_type(const OdeView& view, Visit&& visit) {
  if (!view.second_order())
    visit.template operator()<SharedOde>();
  else if (view.velocity_dependent)
    visit.template operator()<SharedSecondOrder>();
  else
    visit.template operator()<SharedSeparable>();
}

}  // namespace odeum
