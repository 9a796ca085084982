// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/errors.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "odeum/core/numbers.hpp"

namespace odeum::judge {

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
      const double size = y[i] / c.scale_of(i);
      squares += size * size;
    }
    scale_ = std::max(scale_, std::sqrt(squares / static_cast<double>(measured_.size())));
  };
  extend_scale(c.y0.data());
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
        const double difference = std::abs(y[i] - truth_[k][i]) / case_.scale_of(i);
        error.error_max = std::max(error.error_max, difference);
        squares += difference * difference;
      }
      error.error_rms = std::sqrt(squares / static_cast<double>(measured_.size()));
      error.energy_error =
          case_.energy ? std::abs(error.energy - case_.energy(truth_[k].data())) / energy_scale_
                       : nan;
    }
    errors.push_back(error);
  }
  return errors;
}

double error_at(const Case& c, double time, const double* state) {
  Outcome outcome;
  outcome.record(time, state, c.y0.size());
  return Judge(c, {time}).errors(outcome).front().error_max;
}

}  // namespace odeum::judge
