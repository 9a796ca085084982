// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "odeum/advise/answer.hpp"
#include "odeum/solvers/settings.hpp"

/// What both forms of an answer, text and JSON, say.
namespace odeum::advise {

inline const Candidate& winner_of(const Advice& advice) { return advice.candidates[advice.winner]; }

std::string text_of_ns(double ns);

/// Its solver and the kind of its setting, as options have them: `odeum/rk4 --step`.
std::string name_of(const Candidate& candidate);

std::string command_of(const Advice& advice, const Case& c, const Asked& asked);

/// Others that the times do not tell from the winner; within a time, others of about its error.
std::vector<std::string> same_within_noise(const Advice& advice);

/// The time until which the answer holds, where that is a part of what was asked for.
std::optional<double> known_part(const Case& c);

struct RunnerUp {
  const Candidate* candidate;
  std::string why;  ///< the best of its library or family
};

/// The best of every other library, and the best of another family.
std::vector<RunnerUp> runners_up(const Advice& advice);

/// Why each of those that take no part any more was left.
Dropped reason_of(const Candidate& candidate, bool within);

template <class Visit>
void each_dropped(const Advice& advice, const Visit& visit) {
  for (std::size_t k = 0; k < advice.candidates.size(); ++k)
    if (std::ranges::find(advice.timed, k) == advice.timed.end()) visit(advice.candidates[k]);
}

}  // namespace odeum::advise
