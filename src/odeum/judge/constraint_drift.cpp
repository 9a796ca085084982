// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/constraint_drift.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace odeum::judge {

ConstraintDrift drift_off_constraints(const Case& c, const Request& request,
                                      const Outcome& outcome) {
  ConstraintDrift drift;
  if (!c.problem.implicit || c.problem.implicit->constraints.names.empty()) return drift;
  const Constraints& all = c.problem.implicit->constraints;
  const std::size_t n = c.y0.size(),
                    reached = std::min(outcome.states.size() / n, request.stops.size());
  std::vector<double> values(all.names.size());
  for (std::size_t k = 0; k < reached; ++k) {
    all.values(request.stops[k], outcome.states.data() + k * n, values.data());
    for (std::size_t i = 0; i < values.size(); ++i) {
      Drift& largest = i < all.given ? drift.given : drift.hidden;
      if (std::abs(values[i]) <= largest.size) continue;
      largest = {std::abs(values[i]), request.stops[k], all.names[i]};
    }
  }
  return drift;
}

std::string remark_on_drift(const Case& c, const SolverInfo& info, const Request& request,
                            const ConstraintDrift& drift) {
  if (!c.problem.implicit || c.problem.implicit->index < 2 || drift.given.name.empty()) return {};
  const auto asked = request.options.find("projection");
  const bool projected = asked != request.options.end() && asked->second != 0;
  return fmt::format(
      "constraints of index {}: the run is at most {:.2g} off {}, and {:.2g} off {}{}",
      c.problem.implicit->index, drift.given.size, drift.given.name, drift.hidden.size,
      drift.hidden.name,
      info.options.contains("projection") && !projected ? "; --option projection=1 keeps both"
                                                        : "");
}

}  // namespace odeum::judge
