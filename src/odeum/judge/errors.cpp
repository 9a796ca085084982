// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "odeum/core/numbers.hpp"

namespace odeum::judge {

namespace {

double error_of_component(const Case& c, std::size_t i, const double* y, const double* exact) {
  return std::abs(y[i] - exact[i]) / c.units.of(i, exact[i]);
}

}  // namespace

StopError over_stops(const std::vector<StopError>& errors) {
  StopError all = errors.back();
  all.error_max = 0;
  all.energy_error = std::isnan(errors.front().energy) ? nan : 0;
  double mean_square = 0;
  for (const StopError& error : errors) {
    all.error_max = std::max(all.error_max, error.error_max);
    mean_square += error.error_rms * error.error_rms / static_cast<double>(errors.size());
    if (!(error.energy_error <= all.energy_error)) all.energy_error = error.energy_error;
  }
  all.error_rms = std::sqrt(mean_square);
  return all;
}

std::vector<std::size_t> measured_components(const Case& c) {
  std::vector<std::size_t> measured = c.measured;
  if (measured.empty()) {
    measured.resize(c.y0.size());
    std::iota(measured.begin(), measured.end(), 0);
  }
  return measured;
}

Judge::Judge(const Case& c, std::vector<double> stops)
    : case_(c), stops_(std::move(stops)), truth_(stops_.size()), measured_(measured_components(c)) {
  const auto extend_scale = [&](const double* y) {
    double squares = 0;
    for (const std::size_t i : measured_) {
      const double size = y[i] / c.units.of(i, y[i]);
      squares += size * size;
    }
    scale_ = std::max(scale_, std::sqrt(squares / static_cast<double>(measured_.size())));
  };
  extend_scale(c.y0.data());
  if (!c.truth.largest.empty()) extend_scale(c.truth.largest.data());
  for (std::size_t k = 0; k < stops_.size(); ++k) {
    std::vector<double> exact(c.y0.size());
    if (!c.truth.at(stops_[k], exact.data())) continue;
    if (is_finite(exact.data(), exact.size())) {
      extend_scale(exact.data());
      if (c.energy) energy_scale_ = std::max(energy_scale_, std::abs(c.energy(exact.data())));
    } else {
      ends_ = true;
    }
    truth_[k] = std::move(exact);
  }
}

std::vector<StopError> Judge::errors(const Outcome& outcome) const {
  std::vector<StopError> errors;
  for (std::size_t k = 0; k < stops_.size(); ++k) {
    const double* const y = outcome.states.data() + k * case_.y0.size();
    StopError error{.time = stops_[k], .energy = case_.energy ? case_.energy(y) : nan};
    if (truth_[k].empty()) {
      error.error_max = error.error_rms = error.energy_error = nan;
    } else if (!is_finite(truth_[k].data(), truth_[k].size())) {
      error.error_max = error.error_rms = std::numeric_limits<double>::infinity();
      error.energy_error = nan;
    } else {
      double squares = 0;
      for (const std::size_t i : measured_) {
        const double difference = error_of_component(case_, i, y, truth_[k].data());
        squares += difference * difference;
      }
      error.error_max = error_of(case_, y, truth_[k].data());
      error.error_rms = std::sqrt(squares / static_cast<double>(measured_.size()));
      error.energy_error =
          case_.energy ? std::abs(error.energy - case_.energy(truth_[k].data())) / energy_scale_
                       : nan;
    }
    errors.push_back(error);
  }
  return errors;
}

std::size_t worst_component(const Case& c, const double* y, const double* exact) {
  std::size_t worst = c.measured.empty() ? 0 : c.measured.front();
  double largest = 0;
  const auto take = [&](std::size_t i) {
    const double error = error_of_component(c, i, y, exact);
    if (error <= largest || std::isnan(largest)) return;
    largest = error;
    worst = i;
  };
  if (c.measured.empty())
    for (std::size_t i = 0; i < c.y0.size(); ++i) take(i);
  for (const std::size_t i : c.measured) take(i);
  return worst;
}

double error_of(const Case& c, const double* y, const double* exact) {
  if (!c.measures_particles) return error_of_component(c, worst_component(c, y, exact), y, exact);
  double largest = 0;
  for (std::size_t k = 0; k + 2 < c.measured.size(); k += 3) {
    const std::size_t at = c.measured[k];  // x, and y and z after it
    const double distance =
        std::hypot(y[at] - exact[at], y[at + 1] - exact[at + 1], y[at + 2] - exact[at + 2]);
    if (!(distance <= largest)) largest = distance;
  }
  return largest;
}

std::string unit_text(const Case& c) {
  if (c.measures_particles) return "in m, of the particle that is farthest from its place";
  return c.units.scale.empty() ? "absolute" : "in the units of the scale";
}

double error_at(const Case& c, double time, const double* state) {
  Outcome outcome;
  outcome.record(time, state, c.y0.size());
  return Judge(c, {time}).errors(outcome).front().error_max;
}

}  // namespace odeum::judge
