// SPDX-License-Identifier: BSD-3-Clause
// Which of the runs that were made is to be made instead.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "odeum/why/inquiry.hpp"

namespace odeum::why {
const Run& farthest(const Inquiry& q) {
  // A fixed step goes past the end of a solution.
  const Run* best = q.adaptive() || q.others.empty() ? &q.run : &q.others.front();
  for (const Run& other : q.others)
    if (other.ends.back() > best->ends.back()) best = &other;
  return *best;
}

namespace {

/// Returns the error that is as exact: the run's own, or one that is too small to be told.
double as_exact(const Inquiry& q) {
  constexpr double negligible = 1e-3;  // of what was asked for
  return std::max({q.difference(q.run), q.known->doubt, negligible * wanted(q)});
}

/// Whether another run is what to do instead, the best first: it ends near the solution, and is
/// nearer to it or as near for less work; it keeps what was asked for at half of the work, or is
/// much nearer for little more; it alone keeps what was asked for, whatever it takes. Nothing is
/// said where the solution is not known.
enum class Worth { better, fair, dear, none };
Worth worth_of(const Inquiry& q, const Other& other) {
  using enum Worth;
  if (!other.ok()) return none;
  const double theirs = other.difference, ours = q.difference(q.run), want = wanted(q);
  // A shorter run, where none gets to the end.
  if (other.reached < q.run.request.stops.back())
    return !q.run.ok() || !(ours <= far_off) ? better : none;
  // Where no tolerance helps, one that ends near the solution does so by chance.
  if (std::isnan(theirs) || q.no_tolerance_helps()) return none;
  const double told = std::max(theirs, q.known->doubt);
  if (theirs > far_off)
    return q.run.ok() && theirs < 10 * far_off && told <= 0.1 * ours ? dear : none;
  if (!q.run.ok()) return better;
  if (other.error > std::max(1.5 * q.why.error, want)) return none;
  const double work = work_of(other.counters, q.c) / work_of(q.why.outcome.counters, q.c);
  const bool nearer = (ours > 10 * want && told < 0.3 * ours) ||
                      (work < 1.2 && told <= (ours > want ? 0.5 : 0.1) * ours);
  if (nearer || (theirs <= as_exact(q) && work < 0.8)) return better;
  // A fixed step does not ask for an error.
  const double enough = q.adaptive() ? want : std::max(3 * ours, 1e-9);
  if ((told <= enough && work < 0.5) || (told <= 0.1 * ours && work < 2)) return fair;
  return ours > want && told <= std::max(want, 0.3 * ours) && told < 0.5 * ours ? dear : none;
}

/// The last time up to which two runs, or a run and the truth, agree on the solution, of the size
/// that it has there.
double agreed_until(Inquiry& q, const Run& one, const Run& other) {
  constexpr std::size_t parts = 60, around = 1;
  constexpr double near = 1e-3;
  const double t0 = q.c.t0, end = q.run.request.stops.back();
  const std::size_t n = q.c.y0.size();
  const auto states = [&](const Run& run) {
    Request request = run.request;
    request.record_steps = false;
    request.over_stops = true;
    request.stops.clear();
    for (std::size_t k = 1; k <= parts; ++k)
      request.stops.push_back(t0 + (end - t0) * static_cast<double>(k) / parts);
    return q.make(q.c, run.solver, request, 0, 0.3).outcome.states;
  };
  const std::vector<double> first = states(one), second = states(other);
  std::vector<double> exact(n);
  double until = t0;
  for (std::size_t k = 0; k < std::min(first.size(), second.size()) / n; ++k) {
    const double t = t0 + (end - t0) * static_cast<double>(k + 1) / parts;
    const double* truth = second.data() + k * n;
    if (q.c.truth.closed_form && q.c.truth.at(t, exact.data())) truth = exact.data();
    for (std::size_t i = 0; i < n; ++i) {
      double size = 1e-12 * q.sizes[i];
      for (std::size_t j = k - std::min(k, around); j <= k; ++j)
        size = std::max(size, std::min(std::abs(first[j * n + i]), std::abs(second[j * n + i])));
      if (std::abs(first[k * n + i] - truth[i]) > near * size) return until;
    }
    until = t;
  }
  return until;
}

/// A shorter run, up to where the solution is known.
void try_shorter(Inquiry& q) {
  std::vector<const Run*> runs;
  if (q.disagree) {
    runs = {&q.disagree->first, &q.disagree->second};
  } else {
    // The two of the tightest tolerances that are not of one solver.
    std::vector<const Run*> all;
    for (const Run& each : q.others)
      if (each.ok() && each.request.mode == Mode::adaptive) all.push_back(&each);
    std::ranges::stable_sort(all, {},
                             [](const Run* run) { return run->request.tolerance.relative; });
    for (const Run* each : all)
      if (runs.size() < 2 && (runs.empty() || runs.front()->solver != each->solver))
        runs.push_back(each);
  }
  if (runs.size() < 2) return;
  const Run first = *runs[0], second = *runs[1];  // rows are added
  const double until = agreed_until(q, first, second), t0 = q.c.t0;
  constexpr double least = 0.05;
  if (!(until - t0 > least * (q.run.request.stops.back() - t0))) return;
  Request request = first.request;
  request.stops = {of_two_digits(until)};
  if (!(request.stops.back() > t0 && request.stops.back() <= until)) request.stops = {until};
  q.also(first.solver, request, 0.3);
  q.why.advice = fmt::format("up to t = {:.4g} {} and {} agree to a thousandth, and no farther",
                             request.stops.back(), first.solver,
                             q.c.truth.closed_form ? "the truth" : second.solver);
}

/// Equal steps that do not miss what is as short as that, by two methods.
void try_equal_steps(Inquiry& q, double length) {
  constexpr double parts = 25, most_steps = 5e6;
  Request request = q.run.request;
  request.mode = Mode::fixed;
  request.record_steps = false;
  const double steps = std::ceil(parts * (request.stops.back() - q.c.t0) / length);
  if (!(steps <= most_steps)) return;
  request.steps = nearest_multiple(steps, q.c.settings.steps_multiple);
  std::vector<std::size_t> made;
  for (const char* id : {"odeum/rk4", "odeum/adams_bashforth4"})
    if (q.c.entrants.find(id)->unfit.empty()) made.push_back(q.also(id, request, 0.3));
  if (q.known || made.size() < 2) return;
  const Run &one = q.others[made[0]], &other = q.others[made[1]];
  if (!one.ok() || !other.ok()) return;
  q.find_sizes(q.along(one));  // which those that missed it did not show
  if (!(q.apart(one, other) <= far_off)) return;
  q.known = Known{one.outcome.states, q.apart(one, other),
                  fmt::format("{} and {}", one.solver, other.solver)};
}

/// Steps that end there see a smooth right-hand side on either side.
void try_stops_at_kinks(Inquiry& q) {
  Request request = q.run.request;
  const double end = request.stops.back();
  request.stops.clear();
  for (const Kink& kink : q.kinks)
    if (kink.t > q.c.t0 && kink.t < end) request.stops.push_back(kink.t);
  request.stops.push_back(end);
  const Outcome parts = q.make(q.c, q.why.solver, request, 0, 0.3).outcome;
  if (parts.status == Status::ok &&
      parts.counters.rhs_evaluations < q.why.outcome.counters.rhs_evaluations)
    q.why.advice = fmt::format("with steps that end at the kinks the run takes {} evaluations",
                               parts.counters.rhs_evaluations);
}

}  // namespace

double wanted(const Inquiry& q) {
  return q.adaptive() ? q.run.request.tolerance.relative : usual_tolerance;
}

void try_as_exact(Inquiry& q) {
  if (!q.known || !q.run.ok() || q.no_tolerance_helps()) return;
  if (!(q.difference(q.run) <= 10 * wanted(q))) return;
  const double target = as_exact(q), own = work_of(q.why.outcome.counters, q.c);
  constexpr double clearly = 0.7, part = 0.4;  // of the run's work, and of its error
  // The error goes in proportion to the tolerance, and the work by the order.
  const auto ratio_of = [&](const Run& run) {
    return std::max(1e-6, part * target / std::max(q.difference(run), 1e-16));
  };
  const auto foreseen = [&](const Run& run) {
    constexpr double usual_order = 5;
    const double order = q.c.entrants.find(run.solver)->info.order;
    return work_of(run.outcome.counters, q.c) *
           std::pow(ratio_of(run), -1 / (std::isnan(order) ? usual_order : order));
  };
  std::set<std::string> tried;
  constexpr std::size_t most = 4;
  while (tried.size() < most && q.time_for_more(0.15)) {
    // The cheapest of the runs that are left is the next, as it is foreseen.
    const Run* next = nullptr;
    for (const Run& run : q.others)
      if (q.difference(run) <= far_off && run.request.mode == Mode::adaptive &&
          !tried.contains(run.solver) && (!next || foreseen(run) < foreseen(*next)))
        next = &run;
    if (!next || !(foreseen(*next) < clearly * own)) return;
    const std::string solver = next->solver;
    tried.insert(solver);
    constexpr int corrections = 2;
    for (int k = 0; k < corrections && next->ok() && !(q.difference(*next) <= target); ++k) {
      Request request = next->request;
      const double relative = of_two_digits(request.tolerance.relative * ratio_of(*next));
      if (relative < 1e-13) break;
      std::vector<double> absolute = request.tolerance.with_relative(relative).absolutes();
      std::ranges::transform(absolute, absolute.begin(), of_two_digits);
      request.tolerance = Tolerance(relative, absolute);
      next = &q.others[q.also(solver, request, 0.1)];
    }
  }
}

void choose(Inquiry& q) {
  for (std::size_t k = 0; k < q.others.size(); ++k)
    q.why.others[k].difference = q.difference(q.others[k]);
  q.why.better.reset();
  // Error first: as much as was asked for is enough, and then the work decides.
  const double end = q.run.request.stops.back();
  std::array<double, 4> least{infinity, infinity, infinity, infinity};
  for (std::size_t k = 0; k < q.why.others.size(); ++k) {
    const Other& other = q.why.others[k];
    Worth worth = worth_of(q, other);
    if (worth == Worth::none) continue;
    // The run with another absolute tolerance comes first where that is at fault.
    if (q.found(Cause::absolute) && other.id() != q.why.solver)
      worth = std::max(worth, Worth::fair);
    const bool whole = other.reached == end && other.difference <= far_off;
    const double error = other.difference > 10 * wanted(q) ? other.difference : 0;
    const std::array cost{whole ? 0.0 : 1.0, static_cast<double>(worth), error,
                          work_of(other.counters, q.c)};
    if (cost < least) least = cost, q.why.better = k;
  }
}

void try_settings(Inquiry& q) {
  Request request = q.run.request;
  request.record_steps = false;
  const double t0 = q.c.t0, end = request.stops.back();
  const auto worth = [&](Cause cause) { return q.found(cause) && q.left() > 0.1 * q.seconds; };
  if (worth(Cause::rounding)) {
    request.tolerance =
        q.run.request.tolerance.with_relative(std::max(1e-12, request.tolerance.relative));
    q.also(q.why.solver, request, 0.3);
  }
  if (worth(Cause::pulse)) try_equal_steps(q, q.pulse);
  if (worth(Cause::aliasing)) {
    try_equal_steps(q, q.period);
    for (const double part : {1e-2, 1e-4}) {
      request = q.run.request;
      request.record_steps = false;
      if (!q.adaptive() || !(part * request.tolerance.relative > 1e-13)) continue;
      request.tolerance =
          request.tolerance.with_relative(of_two_digits(part * request.tolerance.relative));
      q.also(q.why.solver, request, 0.2);
    }
  }
  if (worth(Cause::kink)) try_stops_at_kinks(q);
  const bool far = q.run.ok() && !(q.difference(q.run) <= far_off);
  if ((far || q.amplification > 1) && !q.found(Cause::sliding) && q.left() > 0.1 * q.seconds) {
    const auto near = [&](const Run& other) { return q.difference(other) <= far_off; };
    if (q.no_tolerance_helps() || std::ranges::none_of(q.others, near)) try_shorter(q);
  }
  for (const Finding& finding : q.why.findings) {
    if (finding.cause != Cause::sliding) continue;
    q.why.advice =
        "equations with a smooth law in place of the jump, as tanh(x/e) for sign(x), have "
        "a solution in the usual sense";
    // Equal steps cross the jump by their own length, and are rejected nowhere.
    constexpr double as_many_parts = 1e4;
    if (!q.known) try_equal_steps(q, (end - t0) / as_many_parts);
    if (q.known || !(finding.from > t0)) continue;
    request = q.run.request;
    request.record_steps = false;
    if (!q.adaptive()) continue;
    request.stops = {t0 + 0.99 * (finding.from - t0)};
    q.also(q.why.solver, request, 0.2);
  }
  for (const Finding& finding : q.why.findings)
    if (finding.cause == Cause::pole || finding.cause == Cause::singular ||
        finding.cause == Cause::growth || finding.cause == Cause::domain) {
      if (!(finding.from > t0)) continue;
      request = q.run.request;
      request.record_steps = false;
      request.stops = {t0 + 0.99 * (std::min(finding.from, end) - t0)};
      if (request.stops.front() > t0) q.also(q.why.solver, request, 0.3);
      break;
    }
}

}  // namespace odeum::why
