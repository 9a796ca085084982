// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/core/numbers.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::cases {

/// Until when a case goes and where its errors are measured, in place of what its statement says.
struct Span {
  double until = nan;  ///< NaN: to the statement's own end
  double frame = 0;    ///< the stops are its multiples after the start; 0: the statement's own

  bool given() const { return frame > 0 || until == until; }
};

/// The stops of a span from t0 on, `own` where nothing else is given, and where frames do not
/// divide it. An end that is none of its own stops has four stops at least. Throws
/// std::invalid_argument for an end before the start and for more than 20,000 frames.
std::vector<double> stops_of(const Span& span, double t0, const std::vector<double>& own);

/// A case with these stops, up to where the truth is known there, and with steps to match.
Case with_span(Case c, const Span& span, const TruthBounds& bounds = {});

}  // namespace odeum::cases
