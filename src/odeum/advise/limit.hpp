// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/advise/race.hpp"

/// What is measured of an answer's run, beside its error and its time.
namespace odeum::advise {

/// What keeps the winner's steps from being longer: `accuracy`, `stability`, `frame`, `stops`, or a
/// text that begins with `unknown`. By the coarser run, and where that says more than a larger
/// error by the eigenvalues of the Jacobian along the solution against the edge of the solver's own
/// region of stability, which is measured.
std::string limit_of(const Advice& advice, const Case& c);

/// How the problem carries a change of its start to the stops, and how the winner's run does, where
/// the problem makes it a hundred times as large: a sentence, else nothing. The problem's is that
/// of the flow of an own method to 1e-10, as far as its run is near the truth. For up to eight
/// unknowns by all of them, for up to 64 by random changes; for more it is not measured.
std::string growth_of(const Advice& advice, const Case& c);

}  // namespace odeum::advise
