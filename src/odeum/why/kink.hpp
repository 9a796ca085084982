// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <optional>

#include "odeum/measure/recording.hpp"

namespace odeum::why {

using namespace measure;  // a diagnosis is about runs that were recorded

/// A time at which the right-hand side along the solution is not smooth.
struct Kink {
  double t = 0;
  std::size_t component = 0;
  bool jump = false;  ///< of the value itself; else of its derivative
  double size = 0;    ///< how far f is from a straight line over `width`, around t
  double width = 0;
  /// What it adds to the error of a step h over it.
  double effect(double h) const { return size * h * (jump ? 1 : h / width); }
};
/// Searches between two states of a run: the irregular part of f that does not shrink as an
/// interval around it does.
std::optional<Kink> kink_between(const Case& c, const Moment& from, const Moment& to);

}  // namespace odeum::why
