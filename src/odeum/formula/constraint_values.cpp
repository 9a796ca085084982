// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>

#include "odeum/formula/evaluator.hpp"
#include "odeum/formula/text_ode.hpp"

namespace odeum::formula {

Constraints constraints_of(const Problem& problem) {
  Constraints all;
  all.jumps = problem.jumps;
  std::vector<Id> values, slopes;
  for (const StateConstraint& constraint : problem.constraints) {
    all.names.push_back(constraint.name);
    values.push_back(constraint.value);
    if (!constraint.is_hidden) ++all.given;
  }
  if (values.empty()) return all;
  Graph graph = problem.graph;
  const auto n = static_cast<std::uint32_t>(problem.states.size());
  const auto gradient = gradients(graph, values, n);
  std::vector<std::size_t> places;
  for (std::size_t row = 0; row < gradient.size(); ++row)
    for (const Entry& entry : gradient[row]) {
      if (entry.by == n) continue;  // the time
      places.push_back(row * n + entry.by);
      slopes.push_back(entry.value);
    }
  using Values = Evaluator<double>;
  all.values = [at = std::make_shared<const Values>(graph, values)](
                   double t, const double* y, double* out) { (*at)(t, y, out); };
  all.slopes = [at = std::make_shared<const Values>(graph, slopes), places,
                size = values.size() * n](double t, const double* y, double* out) {
    thread_local std::vector<double> entries;
    entries.resize(places.size());
    (*at)(t, y, entries.data());
    std::fill(out, out + size, 0.);
    for (std::size_t k = 0; k < places.size(); ++k) out[places[k]] = entries[k];
  };
  return all;
}

}  // namespace odeum::formula
