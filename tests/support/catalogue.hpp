// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <span>
#include <stdexcept>
#include <string>

#include "odeum/cases/catalogue.hpp"

namespace odeum::tests {

/// The case of that id; throws where there is none.
inline const Case& find_case(const std::string& id) { return known_case(id); }

/// A case's entrant of that solver id; throws where there is none.
inline const Entrant& find_entrant(const Case& c, const std::string& id) {
  if (const Entrant* const entrant = c.entrants.find(id)) return *entrant;
  throw std::runtime_error("no solver " + id + " on " + c.id);
}

inline Request fixed_request(std::uint64_t steps, std::vector<double> stops) {
  Request request;
  request.mode = Mode::fixed;
  request.steps = steps;
  request.stops = std::move(stops);
  return request;
}

inline Request adaptive_request(double tolerance, std::vector<double> stops) {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = tolerance;
  request.stops = std::move(stops);
  return request;
}

/// The state at stop number `stop` of an outcome, `dimension` doubles.
inline std::span<const double> state_at(const Outcome& outcome, std::size_t stop,
                                        std::size_t dimension) {
  return std::span(outcome.states).subspan(stop * dimension, dimension);
}

}  // namespace odeum::tests
