// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/limits/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "odeum/core/parallel.hpp"
#include "odeum/judge/stability_search.hpp"
#include "odeum/linear/dense_limit.hpp"
#include "odeum/studies/foreseen.hpp"
#include "odeum/studies/spectrum.hpp"

namespace odeum::study {
namespace {

constexpr std::uint64_t most_steps = 1 << 17;
constexpr double longest_window = 20'000;  ///< times the largest |eigenvalue|
/// The multiplications of dense matrices in one run: a second or two, foreseen from a run of half
/// as many steps.
constexpr double most_multiplications = 1e9;
/// One run of a large system takes no longer, since a limit takes up to thirty runs, and an engine
/// that looks for contacts may take milliseconds a step without any evaluation.
constexpr double most_seconds = 5;

/// A case and the window over which it is run, with the size of its solution and the spectrum along
/// it.
struct StiffWindow : SpectrumAlong {
  const Case& c;
  double length;

  explicit StiffWindow(const Case& each) : c(each), length(c.stops.back() - c.t0) {
    // The horizon, halved until the largest eigenvalue within it allows it.
    while (follow() && std::abs(largest) * length > longest_window) length /= 2;
    if (!reason.empty()) length = nan;
  }

 private:
  bool follow() {
    static_cast<SpectrumAlong&>(*this) = spectrum_along(c, length);
    return reason.empty();
  }
};

/// The limit of stability along the ray of an eigenvalue, as a multiple of 1 / |eigenvalue|; NaN
/// without a theory.
double limit_along(const SolverInfo& info, const std::complex<double>& z) {
  const bool undamped = std::abs(z.real()) <= 1e-9 * std::abs(z);
  const double re = undamped ? 0 : z.real() / std::abs(z), im = z.imag() / std::abs(z);
  std::function<double(double)> amplification;
  if (info.amplification)
    amplification = [&](double x) { return info.amplification(x * re, x * im); };
  else if (undamped)
    amplification = info.oscillator_amplification;
  if (!amplification) return nan;
  return judge::find_limit([&](double x) {
           return judge::Growth{std::log(amplification(x)), judge::growth_rounding};
         })
      .limit;
}

/// The smallest of the steps that the eigenvalues allow, and the one that limits it. Small
/// eigenvalues never do and are left out.
void predict(const StiffWindow& window, const SolverInfo& info, LargestStep& row) {
  std::map<double, double> by_angle;  // most eigenvalues are real or close in angle
  for (const std::complex<double>& z : window.eigenvalues) {
    if (std::abs(z) < 0.05 * std::abs(window.largest)) continue;
    const double angle = std::round(std::arg(z) * 1e4);
    const auto [place, is_new] = by_angle.try_emplace(angle, 0);
    if (is_new) place->second = limit_along(info, z);
    const double step = place->second / std::abs(z);
    if (!(step >= row.predicted_step)) row.predicted_step = step, row.eigenvalue = z;
    if (std::isnan(step)) break;
  }
  if (std::isnan(row.predicted_step)) row.eigenvalue = window.largest;
}

/// Why a run is not bounded.
struct Failure {
  std::string status, detail;
};

/// The costs of the runs so far.
struct Costs {
  double multiplications_a_step = 0;  ///< of the last run that ended, for dense factors
  Foreseen foreseen = {};             ///< of a large system
};

/// None where it is bounded. A run that takes too much is not begun.
std::optional<Failure> failure_of(const StiffWindow& window, const Entrant& entrant,
                                  std::uint64_t steps, Costs& costs) {
  if (interrupted) throw Interrupted();
  if (static_cast<double>(steps) * costs.multiplications_a_step > most_multiplications)
    return Failure{to_string(Status::over_budget),
                   fmt::format("{} steps take more than {:.0e} multiplications for the factors of "
                               "dense matrices",
                               steps, most_multiplications)};
  Request request;
  request.steps = steps;
  for (int k = 1; k <= 4; ++k) request.stops.push_back(window.c.t0 + window.length * k / 4);
  // A large system, whose linear solvers count their products, has some seconds as foreseen. Any
  // other has what steps that converge may take: iterations of all stages, and at steps as long as
  // these a dozen Jacobians by differences (a hanging chain with radau_iia9: 700 evaluations a
  // step).
  const std::size_t n = window.sizes.size();
  request.budget.evaluations = n > dense_dimension_limit ? window.c.settings.evaluation_budget
                                                         : (256 + 12 * n) * steps + 1'000;
  if (n > dense_dimension_limit) request.budget.seconds = most_seconds;
  if (const std::string excess = costs.foreseen.excess(request); !excess.empty())
    return Failure{to_string(Status::over_budget), excess};
  const double start = thread_seconds();
  const Outcome outcome = entrant.solve(request);
  const auto jacobians = static_cast<double>(outcome.counters.jacobian_evaluations);
  if (n > dense_dimension_limit)
    costs.foreseen.add(request, outcome.counters.work, 1e9 * (thread_seconds() - start));
  else if (outcome.status == Status::ok)
    costs.multiplications_a_step =
        jacobians * std::pow(static_cast<double>(n), 3) / static_cast<double>(steps);
  if (outcome.status != Status::ok) return Failure{to_string(outcome.status), outcome.detail};
  for (std::size_t i = 0; i < outcome.states.size(); ++i)
    if (std::abs(outcome.states[i]) > 10 * window.sizes[i % n])
      return Failure{"ok", fmt::format("component {} grows to {:.3g}", i % n, outcome.states[i])};
  return std::nullopt;
}

LargestStep measure(const StiffWindow& window, const Entrant& entrant) {
  auto row = named_row<LargestStep>(window.c, entrant.info);
  if (!entrant.unfit.empty()) return not_applicable(row, entrant.unfit);
  if (!entrant.info.fixed) return not_applicable(row, "chooses its own steps only");
  if (!window.reason.empty()) return not_applicable(row, window.reason);
  predict(window, entrant.info, row);
  row.window = window.length;
  Failure failure;  // the last one
  Costs costs;
  const std::uint64_t fewest = fewest_bounded_steps(
      [&](std::uint64_t steps) {
        const std::optional<Failure> found = failure_of(window, entrant, steps, costs);
        if (found) failure = *found;
        return !found;
      },
      most_steps);
  row.status = to_string(Status::ok);
  if (fewest == 0) {
    row.status = failure.status == row.status ? to_string(Status::non_finite) : failure.status;
    row.detail = fmt::format("not bounded in {} steps: {}", most_steps, failure.detail);
    return row;
  }
  row.largest_stable_step = window.length / static_cast<double>(fewest);
  row.detail = fewest == 4
                   ? "bounded at the largest step tried"
                   : "beyond: " + (failure.detail.empty() ? failure.status : failure.detail);
  return row;
}

}  // namespace

std::uint64_t fewest_bounded_steps(const std::function<bool(std::uint64_t)>& is_bounded,
                                   std::uint64_t most) {
  std::uint64_t steps = 4;
  bool now = is_bounded(steps);
  for (;; steps *= 2) {
    const bool finer = 2 * steps <= most ? is_bounded(2 * steps) : now;
    if (now && finer) break;
    now = finer;
    if (2 * steps >= most) return 0;
  }
  if (steps == 4) return steps;
  std::uint64_t low = steps / 2, high = steps;
  while (high - low > std::max<std::uint64_t>(4, high / 256)) {
    const std::uint64_t middle = (low + high) / 8 * 4;
    (is_bounded(middle) ? high : low) = middle;
  }
  return high;
}

LimitsResult measure_limits(const Options& options, const Runner& runner) {
  std::vector<const Case*> cases;
  for (const Case* c : select_cases(options.cases))
    if (!options.cases.empty() || c->nature.stiff) cases.push_back(c);
  std::map<const Case*, std::optional<StiffWindow>> windows;
  for (const Case* c : cases) windows[c];
  parallel_for(cases.size(), runner.jobs(),
               [&](std::size_t i) { windows.at(cases[i]).emplace(*cases[i]); });
  return runner.run("limits", select_pairs(cases, options.solvers), key_of, [&](const Pair& pair) {
    return LimitsResult{{measure(*windows.at(pair.c), *pair.entrant)}};
  });
}

}  // namespace odeum::study
