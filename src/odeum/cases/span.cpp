// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/span.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "odeum/cases/study_steps.hpp"
#include "odeum/cases/text_truth.hpp"
#include "odeum/truth/computed_truth.hpp"

namespace odeum::cases {

std::vector<double> stops_of(const Span& span, double t0, const std::vector<double>& own) {
  constexpr double most_frames = 20'000;
  constexpr std::size_t few = 4;
  const double end = std::isnan(span.until) ? own.back() : span.until, length = end - t0;
  if (!(length > 0) || !std::isfinite(length))
    throw std::invalid_argument(
        fmt::format("--until: got {}, expected a finite time after {}", end, t0));
  std::vector<double> stops;
  if (span.frame > 0) {
    const double count = std::round(length / span.frame);
    if (count > most_frames)
      throw std::invalid_argument(
          fmt::format("--frame: {:g} frames up to t = {:g}, expected {:g} "
                      "at most",
                      count, end, most_frames));
    if (count >= 1 && std::abs(length / span.frame - count) < 1e-9 * count)
      for (double k = 1; k < count; ++k) stops.push_back(t0 + k * length / count);
  } else {
    for (const double stop : own)
      if (stop < end) stops.push_back(stop);
    if (end != own.back() && stops.size() + 1 < few) {
      stops.clear();
      for (const int quarter : {1, 2, 3}) stops.push_back(t0 + length * quarter / 4);
    }
  }
  if (span.frame > 0 && stops.empty()) stops = own;
  if (stops.empty() || stops.back() != end) stops.push_back(end);
  return stops;
}

Case with_span(Case c, const Span& span, const TruthBounds& bounds) {
  c.stops = stops_of(span, c.t0, c.stops);
  c.asked_end = -infinity;
  c.settings.timed_stops.clear();
  c.settings.no_fixed_steps.clear();
  truth::know_truth(c, c.stops, bounds);
  std::vector<double> known, state(c.y0.size());
  for (const double stop : c.stops)
    if (c.truth.at(stop, state.data())) known.push_back(stop);
  cut_stops(c, known);
  choose_steps(c, c.nature.smooth, !known.empty());
  if (c.with_values)
    c.with_values = [inner = c.with_values, span](const std::vector<double>& values,
                                                  const TruthBounds& within) {
      return with_span(inner(values, within), span, within);
    };
  return c;
}

}  // namespace odeum::cases
