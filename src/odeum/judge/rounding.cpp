// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <random>

#include "odeum/judge/amplification.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/methods/rk4.hpp"
#include "odeum/problem/shared.hpp"

namespace odeum::judge {
namespace {

constexpr double size_of_perturbation = 1e-8;  // far above rounding, far below nonlinear effects
constexpr std::uint64_t most_steps = 8192;

/// A type of its own, so that the method is compiled here without contraction.
struct Unwatched : SharedOde {
  using SharedOde::SharedOde;
};

/// The states at the stops, each state but the first multiplied by 1 + size x, |x| <= 1 at random.
Outcome run(const Case& c, const Request& request, double size, unsigned seed) {
  const FixedGrid grid(c.t0, request);
  const Unwatched problem(c.problem.view, nullptr);
  methods::rk4::Stepper<Unwatched> method(problem);
  std::mt19937 random(seed);
  const auto range = static_cast<double>(std::mt19937::max());
  std::vector<double> y = c.y0;
  Outcome outcome;
  std::size_t stop = 0;
  for (std::uint64_t i = 0; i < grid.steps(); ++i) {
    method.step(grid.t(i), grid.h(), y);
    for (double& x : y) x *= 1 + size * (2 * static_cast<double>(random()) / range - 1);
    if (stop < request.stops.size() && i + 1 == grid.index_of(stop))
      outcome.record(request.stops[stop++], y.data(), y.size());
  }
  return outcome;
}

}  // namespace

double perturbation_gain(const Case& c) {
  const Judge judge(c, c.stops);
  const double scale = judge.scale();
  Request request;
  request.stops = c.stops;
  const std::uint64_t multiple = c.settings.steps_multiple;
  const std::uint64_t wanted =
      std::clamp(most_steps, c.settings.coarsest_steps,
                 std::max(c.settings.coarsest_steps, c.settings.finest_steps));
  request.steps = std::max(wanted / multiple, std::uint64_t{1}) * multiple;
  if (!FixedGrid(c.t0, request).fits()) return scale;  // no fixed steps meet its stops
  const Outcome plain = run(c, request, 0, 0);
  for (const StopError& error : judge.errors(plain))
    if (!(error.error_rms <= 0.01 * scale)) return scale;
  const std::vector<std::size_t> measured = measured_components(c);
  double squares = 0;
  constexpr unsigned runs = 3;
  for (unsigned seed = 1; seed <= runs; ++seed) {
    const Outcome moved = run(c, request, size_of_perturbation, seed);
    for (std::size_t stop = 0; stop < c.stops.size(); ++stop)
      for (const std::size_t i : measured) {
        const std::size_t at = stop * c.y0.size() + i;
        const double unit = c.units.of(i, plain.states[at]);
        squares += std::pow((moved.states[at] - plain.states[at]) / unit, 2);
      }
  }
  const auto errors = static_cast<double>(runs * c.stops.size() * measured.size());
  return std::sqrt(squares / errors / static_cast<double>(request.steps)) / size_of_perturbation;
}

}  // namespace odeum::judge
