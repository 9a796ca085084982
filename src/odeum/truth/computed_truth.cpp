// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/computed_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "odeum/problem/shared.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {
namespace {

System case_system(const Case& c) {
  System system;
  system.states = c.y0.size();
  system.t0 = c.t0;
  system.y0 = c.extended->y0;
  system.rhs = c.extended->f;
  system.smooth = c.nature.highest_order > 2;  // its derivative does not jump
  system.work = 10 * static_cast<double>(system.states);
  const SharedOde problem(c.problem.view, c.problem.keep_alive);
  if (problem.offers_jacobian() && system.states <= most_in_matrix)
    system.jacobian =
        widened(system.states, system.states * system.states,
                [problem](double t, const double* y, double* j) { problem.jacobian(t, y, j); });
  return system;
}

/// What tells the problem from others in the cache: its parameters, and values of its right-hand
/// side, since the code of a built-in case is not at hand.
std::string content_of(const Case& c) {
  std::string content = fmt::format("truth between the stops of {}", c.id);
  for (const Parameter& parameter : c.parameters)
    content += fmt::format(" {}={}", parameter.name, parameter.value);
  State y = c.extended->y0, f(y.size());
  for (int k = 0; k < 4; ++k) {
    const Real t = c.t0 + (c.stops.back() - c.t0) * k / 4;
    c.extended->f(t, y.data(), f.data());
    content += fmt::format("\n{:.21Lg}", t);
    for (std::size_t i = 0; i < y.size(); ++i)
      content += fmt::format(" {:.21Lg} {:.21Lg}", y[i], f[i]);
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] += (1 + std::abs(y[i])) *
              static_cast<Real>((7 * i + 3 * static_cast<std::size_t>(k)) % 11) / 97;
  }
  return content;
}

}  // namespace

Truth truth_at(const Case& c, const std::vector<double>& times, const TruthBounds& bounds) {
  std::vector<double> state(c.y0.size());
  const bool known =
      std::ranges::all_of(times, [&](double t) { return c.truth.at(t, state.data()); });
  if (known || !c.extended || c.problem.events) return c.truth;
  const Reference reference =
      *kept_or_computed(content_of(c), state.size(), times, c.units, bounds,
                        [&] { return compute_reference(case_system(c), times, c.units, bounds); });

  const auto states = std::make_shared<std::map<double, std::vector<double>>>();
  Truth truth = c.truth;
  truth.floors.resize(state.size());
  for (std::size_t i = 0; i < state.size(); ++i) truth.floors[i] = c.floor_of(i);
  for (std::size_t k = 0; k < reference.times.size(); ++k) {
    if (!std::ranges::binary_search(times, reference.times[k])) continue;
    const State& y = reference.states[k];
    (*states)[reference.times[k]].assign(y.begin(), y.end());
    for (std::size_t i = 0; i < y.size(); ++i) {
      const auto size = static_cast<double>(std::abs(y[i]));
      const double floor = reference.floors[k][i] + 0x1p-53 * size;
      truth.floors[i] = std::max(truth.floors[i], floor);
      truth.floor = std::max(truth.floor, floor / c.units.of(i, size));
    }
  }
  truth.at = [own = c.truth.at, states](double t, double* y) {
    if (own(t, y)) return true;
    const auto found = states->find(t);
    if (found == states->end()) return false;
    std::ranges::copy(found->second, y);
    return true;
  };
  const bool has_own = c.truth.at(c.stops.back(), state.data());
  truth.source = has_own ? c.truth.source + "; between its times " : "";
  if (states->empty()) {
    truth.source += fmt::format("nothing by {}: {}", reference.methods, reference.end);
    return truth;
  }
  truth.source += fmt::format("a reference computed by {}, which agree to {:.1e}",
                              reference.methods, reference.disagreement);
  if (!reference.end.empty())
    truth.source += fmt::format(", up to t = {:.6g}: {}", reference.known_until, reference.end);
  return truth;
}

void know_truth(Case& c, const std::vector<double>& times, const TruthBounds& bounds) {
  std::vector<double> state(c.y0.size());
  if (!c.truth.at || !c.truth.at(times.back(), state.data())) c.truth = truth_at(c, times, bounds);
}

}  // namespace odeum::truth
