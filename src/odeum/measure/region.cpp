// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <numbers>

#include "odeum/cases/catalogue.hpp"
#include "odeum/measure/growth_meter.hpp"
#include "odeum/measure/local.hpp"

namespace odeum::measure {
namespace {

constexpr double first_distance = 1e-2, least_distance = 1e-5, last_distance = 1e3, ratio = 1.2,
                 width = 1.005;

}  // namespace

Region::Region(const std::string& solver) : solver_(solver) {
  for (const auto& [id, oscillator] :
       {std::pair{"dahlquist_complex", false}, std::pair{"damped_oscillator_underdamped", true},
        std::pair{"damped_oscillator_undamped", true}}) {
    probe_ = known_case(id).probe();
    entrant_ = probe_.entrants.find(solver);
    oscillator_ = oscillator;
    if (entrant_ && entrant_->unfit.empty() && entrant_->info.fixed) return;
  }
  entrant_ = nullptr;
}

judge::Growth Region::at(std::complex<double> z) const {
  GrowthMeter meter(probe_, *entrant_, oscillator_, region_length);
  // A solver of undamped oscillators ignores the second number.
  return oscillator_ ? meter.measure(std::abs(z), -z.real() / std::abs(z))
                     : meter.measure(z.real(), z.imag());
}

double Region::growth(std::complex<double> z) const {
  return entrant_ && z != 0.0 ? at(z).log_per_step : nan;
}

double Region::measure(std::complex<double> direction) const {
  const auto grows = [&](double x) { return at(x * direction).grows(); };
  double inside = 0, outside = first_distance;
  while (grows(outside)) {
    // A method that grows everywhere on the axis does so below rounding near zero.
    const bool on_axis = std::abs(direction.real()) < 1e-6;
    if (on_axis || outside < least_distance) return 0;
    outside /= ratio;
  }
  while (!grows(outside)) {
    inside = outside;
    outside *= ratio;
    if (outside > last_distance) return infinity;
  }
  while (outside > width * inside) {
    const double middle = std::sqrt(inside * outside);
    (grows(middle) ? outside : inside) = middle;
  }
  return inside;
}

double Region::edge(std::complex<double> lambda) {
  if (!entrant_ || lambda == 0.0) return nan;
  if (oscillator_ && lambda.real() > 1e-6 * std::abs(lambda)) return nan;
  // Near the imaginary axis the edge of some methods is in proportion to the distance from it.
  constexpr double half_degrees = 360 / std::numbers::pi_v<double>, on_axis = 1e-6,
                   of_a_ratio = 100;
  const double tilt = -lambda.real() / std::abs(lambda);
  long key = std::lround(half_degrees * std::abs(std::arg(lambda)));
  double angle = static_cast<double>(key) / half_degrees;
  if (std::abs(tilt) < on_axis) {
    key = std::numeric_limits<long>::min();
    angle = 0.5 * std::numbers::pi_v<double>;
  } else if (tilt > 0 && tilt < 0.1) {
    key = std::lround(of_a_ratio * std::log(tilt));
    angle = std::numbers::pi_v<double> - std::acos(std::exp(static_cast<double>(key) / of_a_ratio));
  }
  const auto [at, fresh] = known_.try_emplace(key, nan);
  if (fresh) at->second = measure(std::polar(1.0, angle));
  return at->second;
}

}  // namespace odeum::measure
