// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/measure/growth_meter.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>

#include "odeum/cases/catalogue.hpp"

namespace odeum::measure {
namespace {

constexpr std::uint64_t window = 16;    // states at the end of a run from which growth is measured
constexpr std::uint64_t recorded = 64;  // runs up to this length are recorded completely
constexpr double clear_noise = 1e-7;    // growth known to this accuracy needs no longer run

/// The growth of a solution that decays and stays small, from its start to that point; none
/// otherwise.
std::optional<judge::Growth> decay(std::span<const judge::PlaneState> states, double below) {
  const double start = judge::length(states[0]);
  std::size_t dead = 1;
  while (dead < states.size() && !(judge::length(states[dead]) < below * start)) ++dead;
  if (dead == states.size()) return std::nullopt;
  for (std::size_t k = dead; k < states.size(); ++k)
    if (!(judge::length(states[k]) < 1e3 * below * start)) return std::nullopt;  // it grew again
  const double left =
      std::max(judge::length(states[dead]) / start, std::numeric_limits<double>::min());
  return judge::Growth{std::log(left) / static_cast<double>(dead), 0};
}

}  // namespace

const Case& case_with_plane(const std::string& plane) {
  for (const Case& c : all_cases())
    if (c.plane == plane) return c;
  throw std::logic_error("no case has the plane " + plane);
}

GrowthMeter::GrowthMeter(const Probe& probe, const Entrant& entrant, bool oscillator,
                         RunLength length)
    : probe_(probe),
      entrant_(entrant),
      oscillator_(oscillator),
      length_(length),
      decayed_below_(entrant.info.family == "multistep" ? 1e-250 : 1e-9) {
  // Ten times the cost of the most expensive solvers (extrapolation, slow iterations).
  request_.budget.evaluations = 20'000'000;
}

std::string GrowthMeter::failure() const {
  const std::string status = to_string(status_);
  if (detail_.empty()) return status;
  return detail_.rfind(status, 0) == 0 ? detail_ : status + ", " + detail_;
}

bool GrowthMeter::run(std::uint64_t steps, double scale) {
  const std::uint64_t first = steps <= recorded ? 1 : steps - window;
  request_.steps = steps;
  request_.stops.clear();
  for (std::uint64_t k = first; k <= steps; ++k) request_.stops.push_back(static_cast<double>(k));
  const Outcome outcome = entrant_.solve(request_);
  status_ = outcome.status;
  detail_ = outcome.detail;
  if (status_ != Status::ok) return false;
  states_.clear();
  if (first == 1) states_.push_back({oscillator_ ? scale : 1, 0});
  for (std::size_t k = 0; k + 1 < outcome.states.size(); k += 2)
    states_.push_back({outcome.states[k] * scale, outcome.states[k + 1]});
  return true;
}

judge::Growth GrowthMeter::measure(double first, double second) {
  probe_.place(first, second);
  const double scale = oscillator_ && first != 0 ? first : 1;
  judge::Growth growth;
  for (std::uint64_t steps = length_.first_steps;; steps *= 4) {
    if (!run(steps, scale)) {
      // Overflow is growth; any other failure gives no result.
      if (status_ == Status::non_finite) return {std::numeric_limits<double>::infinity(), 0};
      return {};
    }
    if (steps <= recorded)
      if (const auto decayed = decay(states_, decayed_below_)) return *decayed;
    const std::span<const judge::PlaneState> all = states_;
    if (judge::length(all.back()) < 1e-280)
      return {std::log(1e-280) / static_cast<double>(steps), 0};
    growth = judge::dominant_growth(
        all.last(std::min<std::size_t>(window + 1, all.size())),
        oscillator_ ? judge::Coefficients::real : judge::Coefficients::complex);
    // An implicit stage solves with a matrix of condition |z|, which amplifies rounding as much.
    growth.noise = std::max(growth.noise, judge::growth_rounding * std::hypot(first, second));
    if (growth.noise <= clear_noise || std::abs(growth.log_per_step) > 10 * growth.noise)
      return growth;
    if (steps * 4 > length_.last_steps) {
      // No one or two roots dominate yet: the mean over the run, in which beats change the length
      // by a factor of the order of 10 at most.
      const double mean = std::log(judge::length(all.back()) / scale) / static_cast<double>(steps);
      return {mean, std::log(10.0) / static_cast<double>(steps)};
    }
  }
}

}  // namespace odeum::measure
