// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "odeum/core/outcome.hpp"
#include "odeum/core/request.hpp"

namespace odeum {

/// The request of a run for the part of it from t to `end`, which becomes a stop.
inline Request part_of(Request request, double t, double end) {
  std::erase_if(request.stops, [&](double stop) { return stop <= t || stop > end; });
  if (request.stops.empty() || request.stops.back() < end) request.stops.push_back(end);
  return request;
}

/// Adds the part up to `end` to what was made of a run with these stops, and gives y the state
/// there; false where the part failed.
inline bool add_part(Outcome& all, Outcome part, const std::vector<double>& stops, double end,
                     std::vector<double>& y) {
  const std::size_t n = y.size();
  const bool ok = part.status == Status::ok;
  all.counters += part.counters;
  all.step_ends.insert(all.step_ends.end(), part.step_ends.begin(), part.step_ends.end());
  if (all.detail.empty() || !ok) all.detail = std::move(part.detail);
  all.status = part.status;
  if (std::isfinite(part.t)) all.t = part.t;
  if (ok) y.assign(part.states.end() - static_cast<std::ptrdiff_t>(n), part.states.end());
  // A state that is not at a stop does not belong to the request's states.
  if (ok && !std::ranges::binary_search(stops, end)) part.states.resize(part.states.size() - n);
  all.states.insert(all.states.end(), part.states.begin(), part.states.end());
  return ok;
}

}  // namespace odeum
