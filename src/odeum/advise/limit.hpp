// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/advise/race.hpp"

/// What is measured of an answer's run, beside its error and its time.
namespace odeum::advise {

/// What keeps the winner's steps from being longer: `accuracy`, `stability`, `frame`, `stops`,
/// `time`, or `unknown`, each with a reason where it has one. By the nearest coarser run that
/// misses the error, and where that has far more of it than the order explains by the eigenvalues
/// of the Jacobian along the solution against the edge of the solver's own region of stability,
/// which is measured.
std::string limit_of(const Advice& advice, const Case& c);

/// How the problem carries a change of its start to the stops, and how the winner's run does, where
/// the problem makes it a hundred times as large: a sentence, else nothing. The problem's is that
/// of the flow of an own method to 1e-10, as far as its run is near the truth. For up to eight
/// unknowns by all of them, for up to 64 by random changes; for more it is not measured.
std::string growth_of(const Advice& advice, const Case& c);

}  // namespace odeum::advise
