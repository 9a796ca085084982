// SPDX-License-Identifier: BSD-3-Clause
// How the problem itself makes errors grow: its fundamental matrix along the solution.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/why/inquiry.hpp"
#include "odeum/why/path.hpp"

namespace odeum::why {
namespace {

constexpr std::size_t intervals = 24, most_unknowns = 40;
constexpr double tolerance = 1e-10, perturbation = 1e-5;

/// Phi over an interval by differences of runs of a solver, of components over their sizes,
/// row-major; empty where a run fails.
std::vector<double> matrix_over(const Inquiry& q, const std::string& solver, const Moment& from,
                                double to) {
  const std::size_t n = from.y.size();
  Request request;
  request.mode = Mode::adaptive;
  std::vector<double> absolute, units;
  for (std::size_t i = 0; i < n; ++i) {
    units.push_back(q.sizes[i] > 0 ? q.sizes[i] : 1);
    absolute.push_back(tolerance * units[i]);
  }
  request.tolerance = Tolerance(tolerance, absolute);
  request.stops = {to};
  request.budget.evaluations = 200'000;
  request.budget.seconds = std::max(0.1, 0.1 * q.left());
  const auto end_from = [&](const std::vector<double>& y) {
    const Recording recording(q.c, from.t, y);
    const Outcome outcome = recording.solver(solver)->solve(request);
    return outcome.status == Status::ok ? outcome.states : std::vector<double>();
  };
  const std::vector<double> base = end_from(from.y);
  if (base.empty()) return {};
  std::vector<double> matrix(n * n);
  for (std::size_t j = 0; j < n; ++j) {
    std::vector<double> moved = from.y;
    moved[j] += perturbation * units[j];
    const std::vector<double> there = end_from(moved);
    if (there.empty()) return {};
    const double by = (moved[j] - from.y[j]) / units[j];
    for (std::size_t i = 0; i < n; ++i) matrix[i * n + j] = (there[i] - base[i]) / units[i] / by;
  }
  return matrix;
}

/// The states from which intervals begin: of the truth where that is a closed form, of a run that
/// ends near the solution, or else of the run itself.
std::vector<Moment> starts_along(const Inquiry& q) {
  const double end = q.run.ok() ? q.run.request.stops.back() : q.run.ends.back(), t0 = q.c.t0;
  const Run& run = q.trusted ? *q.trusted : q.disagree ? q.disagree->first : q.run;
  if (run.moments.size() < 2) return {};
  const Path path(q.c, run.moments);
  std::vector<Moment> states;
  for (std::size_t k = 0; k < intervals; ++k) {
    Moment at{.t = t0 + (end - t0) * static_cast<double>(k) / intervals, .y = q.c.y0};
    const bool known = k == 0 || (q.c.truth.closed_form && q.c.truth.at(at.t, at.y.data()));
    if (!known) at.y = path.state(at.t);
    states.push_back(std::move(at));
  }
  states.push_back({.t = end, .y = q.c.y0});
  return states;
}

}  // namespace

void look_at_amplification(Inquiry& q) {
  const std::size_t n = q.c.y0.size();
  const double off = q.difference(q.run);
  if (n > most_unknowns || off <= 10 * wanted(q) || q.found(Cause::sliding)) return;
  // Differences of runs across a jump are those of its crossings.
  if (std::ranges::any_of(q.kinks, &Kink::jump)) return;
  // The cheapest of the runs that came to the end.
  const Run* cheapest = nullptr;
  for (const Run& other : q.others)
    if (other.ok() && (!cheapest || work_of(other.outcome.counters, q.c) <
                                        work_of(cheapest->outcome.counters, q.c)))
      cheapest = &other;
  if (!cheapest) return;
  const std::vector<Moment> states = starts_along(q);
  // Phi from there to the end, over exp(scale).
  std::vector<double> phi;
  double scale = 0, most = -infinity, from = nan;
  for (std::size_t k = states.size() - 1; k-- > 0 && q.time_for_more(0.2);) {
    if (!is_finite(states[k].y.data(), n)) return;
    const std::vector<double> step = matrix_over(q, cheapest->solver, states[k], states[k + 1].t);
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
      norm = std::max(norm, row);
    }
    if (!(norm > 0)) return;
    for (double& entry : product) entry /= norm;
    phi = std::move(product);
    scale += std::log(norm);
    if (scale > most) most = scale, from = states[k].t;
  }
  if (!std::isfinite(most)) return;
  q.amplification = std::exp(std::min(most, 700.0));
  // It explains the error, or leaves nothing to be known.
  constexpr double large = 100, accumulated = 10;  // errors of many steps add up
  const bool explains =
      std::isnan(off) || accumulated * q.amplification * wanted(q) > 0.1 * std::min(off, 1.0);
  if (q.amplification < large || !explains) return;
  q.add(Cause::amplification, nan, from,
        fmt::format("the problem itself amplifies errors: one of a state at t = {:.4g} is e^{:.3g} "
                    "= {:.2g} times as large at the end, by its fundamental matrix",
                    from, most, q.amplification));
}

}  // namespace odeum::why
