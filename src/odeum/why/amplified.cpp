// SPDX-License-Identifier: BSD-3-Clause
// How the problem itself makes errors grow: its fundamental matrix along the solution.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "odeum/solvers/event_run.hpp"
#include "odeum/why/inquiry.hpp"

namespace odeum::why {
namespace {

constexpr std::size_t intervals = 24, most_unknowns = 40;
constexpr double tolerance = 1e-10, perturbation = 1e-5;

/// The flow of a solver to a tolerance relative to the sizes of the components.
class Flow {
 public:
  Flow(const Inquiry& q, std::string solver) : q_(q), solver_(std::move(solver)) {
    for (const double size : q.sizes) units_.push_back(size > 0 ? size : 1);
  }
  const std::vector<double>& units() const { return units_; }
  /// Empty where the run fails.
  std::vector<double> end(const Moment& from, double to, double tolerance) const {
    Request request;
    request.mode = Mode::adaptive;
    std::vector<double> absolute;
    for (const double unit : units_) absolute.push_back(tolerance * unit);
    request.tolerance = Tolerance(tolerance, absolute);
    request.stops = {to};
    request.budget.evaluations = 500'000;
    request.budget.seconds = std::max(0.1, 0.1 * q_.left());
    const Recording recording(q_.c, from.t, from.y);
    const Outcome outcome = recording.solver(solver_)->solve(request);
    return outcome.status == Status::ok ? outcome.states : std::vector<double>();
  }

 private:
  const Inquiry& q_;
  std::string solver_;
  std::vector<double> units_;
};

/// Phi over an interval by differences of runs, of components over their sizes, row-major; empty
/// where a run fails.
std::vector<double> matrix_over(const Flow& flow, const Moment& from, double to) {
  const std::size_t n = from.y.size();
  const std::vector<double> base = flow.end(from, to, tolerance);
  if (base.empty()) return {};
  std::vector<double> matrix(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    Moment moved = from;
    moved.y[j] += perturbation * flow.units()[j];
    const std::vector<double> there = flow.end(moved, to, tolerance);
    if (there.empty()) return {};
    const double by = (moved.y[j] - from.y[j]) / flow.units()[j];
    for (std::size_t i = 0; i < n; ++i)
      matrix[i * n + j] = (there[i] - base[i]) / flow.units()[i] / by;
  }
  return matrix;
}

/// What two runs to the end say of a growth of `direction`, of components over their sizes: errors
/// of matrices multiply in their product, as where each interval shears and none stretches. NaN
/// where the growth is too large for two runs.
double seen_by_two_runs(const Flow& flow, const Moment& from, double to,
                        const std::vector<double>& direction) {
  constexpr double tight = 1e-12, by = 1e-8, linear = 1e-2;
  Moment moved = from;
  for (std::size_t i = 0; i < direction.size(); ++i)
    moved.y[i] += (direction[i] < 0 ? -by : by) * flow.units()[i];
  const std::vector<double> base = flow.end(from, to, tight), there = flow.end(moved, to, tight);
  if (base.empty() || there.empty()) return nan;
  double most = 0;
  for (std::size_t i = 0; i < base.size(); ++i)
    most = std::max(most, std::abs(there[i] - base[i]) / flow.units()[i]);
  return most < linear ? most / by : nan;
}

/// The states from which intervals begin: of the truth where that is a closed form, or of one run
/// that stops there, which ends near the solution where one does. States between those of a run
/// would not be of one solution, and the product of their matrices would grow by itself.
std::vector<Moment> starts_along(const Inquiry& q) {
  const double end = q.run.ok() ? q.run.request.stops.back() : q.run.ends.back(), t0 = q.c.t0;
  const Run& run = q.trusted ? *q.trusted : q.disagree ? q.disagree->first : q.run;
  std::vector<Moment> states{{.t = t0, .y = q.c.y0}};
  Request request = run.request;
  request.record_steps = false;
  request.stops.clear();
  std::vector<double> events;
  for (const EventMet& event : run.outcome.events) events.push_back(event.t);
  for (std::size_t k = 1; k < intervals; ++k)
    request.stops.push_back(
        between_events(t0 + (end - t0) * static_cast<double>(k) / intervals, events, t0, end));
  std::ranges::sort(request.stops);
  request.stops.erase(std::unique(request.stops.begin(), request.stops.end()), request.stops.end());
  request.stops.push_back(end);
  for (const double t : request.stops) states.push_back({.t = t, .y = q.c.y0});
  const auto known = [&](Moment& at) {
    return q.c.truth.closed_form && q.c.truth.at(at.t, at.y.data());
  };
  if (std::all_of(states.begin() + 1, states.end(), known)) return states;
  if (run.request.mode == Mode::fixed) {
    request.steps = intervals * std::max<std::uint64_t>(1, request.steps / intervals);
    request.over_stops = true;
  }
  const Outcome outcome = q.make(q.c, run.solver, request, 0, 0.2).outcome;
  const std::size_t n = q.c.y0.size(), made = outcome.states.size() / n;
  if (outcome.status != Status::ok || made + 1 != states.size()) return {};
  for (std::size_t k = 0; k < made; ++k)
    std::copy_n(outcome.states.begin() + static_cast<std::ptrdiff_t>(k * n), n,
                states[k + 1].y.begin());
  return states;
}

/// The cheapest of the runs that came to the end; null: none did.
const Run* cheapest_to_the_end(const Inquiry& q) {
  const Run* cheapest = nullptr;
  for (const Run& other : q.others)
    if (other.ok() && (!cheapest || work_of(other.outcome.counters, q.c) <
                                        work_of(cheapest->outcome.counters, q.c)))
      cheapest = &other;
  return cheapest;
}

}  // namespace

void look_at_amplification(Inquiry& q) {
  const std::size_t n = q.c.y0.size();
  const double off = q.difference(q.run);
  if (n > most_unknowns || off <= 10 * wanted(q) || q.found(Cause::sliding)) return;
  // Differences of runs across a jump are those of its crossings.
  if (std::ranges::any_of(q.kinks, &Kink::jump)) return;
  const Run* const cheapest = cheapest_to_the_end(q);
  if (!cheapest) return;
  const std::vector<Moment> states = starts_along(q);
  if (states.empty()) return;
  // Phi from there to the end, over exp(scale).
  const Flow flow(q, cheapest->solver);
  std::vector<double> phi, direction, along;
  double scale = 0, most = -infinity;
  std::size_t from = 0;
  for (std::size_t k = states.size() - 1; k-- > 0 && q.time_for_more(0.2);) {
    if (!is_finite(states[k].y.data(), n)) return;
    const std::vector<double> step = matrix_over(flow, states[k], states[k + 1].t);
    if (step.empty() || !is_finite(step.data(), step.size())) return;
    std::vector<double> product = step;
    if (!phi.empty())
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
          product[i * n + j] = 0;
          for (std::size_t m = 0; m < n; ++m)
            product[i * n + j] += phi[i * n + m] * step[m * n + j];
        }
    double norm = 0;
    for (std::size_t i = 0; i < n; ++i) {
      double row = 0;
      for (std::size_t j = 0; j < n; ++j) row += std::abs(product[i * n + j]);
      if (!(row > norm)) continue;
      norm = row;
      const auto begin = product.begin() + static_cast<std::ptrdiff_t>(i * n);
      direction.assign(begin, begin + static_cast<std::ptrdiff_t>(n));
    }
    if (!(norm > 0)) return;
    for (double& entry : product) entry /= norm;
    phi = std::move(product);
    scale += std::log(norm);
    if (scale > most) most = scale, from = k, along = direction;
  }
  if (!std::isfinite(most)) return;
  const double seen = seen_by_two_runs(flow, states[from], states.back().t, along);
  if (seen < std::exp(most)) most = std::log(seen);
  q.amplification = std::exp(std::min(most, 700.0));
  // It explains the error, or leaves nothing to be known.
  constexpr double large = 100, accumulated = 10;  // errors of many steps add up
  const bool explains =
      std::isnan(off) || accumulated * q.amplification * wanted(q) > 0.1 * std::min(off, 1.0);
  if (q.amplification < large || !explains) return;
  q.add(Cause::amplification, nan, states[from].t,
        fmt::format("the problem itself amplifies errors: one of a state at t = {:.4g} is e^{:.3g} "
                    "= {:.2g} times as large at the end, by its fundamental matrix",
                    states[from].t, most, q.amplification));
}

}  // namespace odeum::why
