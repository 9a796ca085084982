// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/kernel/method.hpp"

/// Which solvers are compiled with the right-hand side of a problem inlined: those that its cases
/// can suit. An explicit method on Robertson's equations, or Radau IIA on the Pleiades, is far from
/// the fastest however it is compiled, and such pairs are a third of the time that timed units
/// compile.
namespace odeum::cases::inlined {

template <class P>
inline constexpr bool has_stiff_cases = true;
template <class P>
inline constexpr bool has_nonstiff_cases = true;

template <class P>
constexpr bool suits(Inlined kind) {
  return kind == Inlined::stiff ? has_stiff_cases<P> : has_nonstiff_cases<P>;
}

}  // namespace odeum::cases::inlined
