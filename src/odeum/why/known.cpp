// SPDX-License-Identifier: BSD-3-Clause
// What is known of the solution at the end: by the truth, or by two runs that agree.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "odeum/why/inquiry.hpp"

namespace odeum::why {
namespace {

/// Two runs agree to a part of the sizes that is well below what is said of a run.
constexpr double agreed = 0.25 * far_off;
/// How many runs to a tighter tolerance are made to find two that agree.
constexpr std::size_t most_tight = 6;

/// The same to a part of the tolerance, of each component by its own size.
Request tighter(const Inquiry& q, double part = 1e-2) {
  Request request = comparable(q);
  const double relative = of_two_digits(std::max(1e-13, part * request.tolerance.relative));
  constexpr std::size_t few = 16;  // a command names each
  if (q.sizes.size() > few) {
    request.tolerance = request.tolerance.with_relative(relative);
    return request;
  }
  std::vector<double> absolute;
  for (std::size_t i = 0; i < q.sizes.size(); ++i)
    absolute.push_back(
        q.sizes[i] > 0
            ? of_two_digits(std::min(relative * q.sizes[i], part * request.tolerance.absolute(i)))
            : part * request.tolerance.absolute(i));
  request.tolerance = Tolerance(relative, absolute);
  return request;
}

std::string family_of(const Inquiry& q, const std::string& solver) {
  return q.c.entrants.find(solver)->info.family;
}

/// The rows that came to the end, the nearest first where the end is known, else the cheapest.
std::vector<std::size_t> in_order(const Inquiry& q) {
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t k = 0; k < q.others.size(); ++k)
    if (q.others[k].ok())
      order.emplace_back(
          q.known ? q.difference(q.others[k]) : work_of(q.others[k].outcome.counters, q.c), k);
  std::ranges::sort(order);
  std::vector<std::size_t> rows;
  for (const auto& [key, k] : order) rows.push_back(k);
  return rows;
}

/// The truth at the end of the run; nothing where it is not known there.
std::optional<Known> by_truth(const Inquiry& q) {
  Known known{std::vector<double>(q.c.y0.size()), 0, "the truth"};
  const double end = q.run.request.stops.back();
  if (!q.c.truth.at || !q.c.truth.at(end, known.end.data())) return {};
  if (!is_finite(known.end.data(), known.end.size())) return {};  // the solution has ended
  return known;
}

/// A run along the solution whose end is known: one of the rows, or one to a tighter tolerance.
void follow(Inquiry& q) {
  std::optional<Run> nearest;
  std::set<std::string> families;
  for (const std::size_t k : in_order(q)) {
    const std::string solver = q.others[k].solver, family = family_of(q, solver);
    if (!families.insert(family).second || families.size() > 3 || !q.time_for_more(0.35)) continue;
    Run tight = q.make(q.c, solver, tighter(q), states_along(q), 0.3);
    if (tight.ok()) q.keep(tight);
    if (tight.ok() && (!nearest || q.difference(tight) < q.difference(*nearest)))
      nearest = std::move(tight);
    if (nearest && q.difference(*nearest) <= agreed) break;
  }
  const std::vector<std::size_t> rows = in_order(q);
  if (!rows.empty() && (!nearest || q.difference(*nearest) > agreed)) {
    Run along = q.along(q.others[rows.front()]);
    if (along.ok() && (!nearest || q.difference(along) < q.difference(*nearest)))
      nearest = std::move(along);
  }
  // Equal steps miss nothing that is as long as they are.
  for (const std::uint64_t steps : {20'000ULL, 500'000ULL}) {
    if ((nearest && q.difference(*nearest) <= far_off) || !q.time_for_more(0.35)) break;
    const Entrant* const rk4 = q.c.entrants.find("odeum/rk4");
    if (!rk4 || !rk4->unfit.empty()) break;
    Request request = q.run.request;
    request.mode = Mode::fixed;
    request.steps = nearest_multiple(static_cast<double>(steps), q.c.settings.steps_multiple);
    Run run = q.make(q.c, "odeum/rk4", request, states_along(q), 0.2);
    if (run.ok()) q.keep(run);
    if (run.ok() && (!nearest || q.difference(run) < q.difference(*nearest)))
      nearest = std::move(run);
  }
  if (nearest && q.difference(*nearest) <= far_off) q.trusted = std::move(nearest);
}

/// The two solvers of different families of which a tighter run is the cheapest, as it is foreseen
/// by their orders.
std::optional<std::pair<std::string, std::string>> cheapest_to_tighten(
    const Inquiry& q, const std::vector<Run>& runs) {
  std::vector<std::pair<double, std::string>> order;
  for (const Run& run : runs) {
    constexpr double usual_order = 5, part = 1e-2;
    const double claimed = q.c.entrants.find(run.solver)->info.order;
    order.emplace_back(work_of(run.outcome.counters, q.c) *
                           std::pow(part, -1 / (std::isnan(claimed) ? usual_order : claimed)),
                       run.solver);
  }
  std::ranges::sort(order);
  for (const auto& [work, solver] : order)
    if (family_of(q, solver) != family_of(q, order.front().second))
      return std::pair(order.front().second, solver);
  return {};
}

/// Looks for two runs of different families that agree, best to what was asked for.
void agree(Inquiry& q) {
  std::vector<Run> runs;
  const auto take = [&](Run run) {
    if (!run.ok() || has_unseen(q, run)) return;
    for (const Run& other : runs) {
      const double apart = q.apart(run, other);
      if (family_of(q, other.solver) == family_of(q, run.solver) || !(apart <= agreed) ||
          (q.known && apart >= q.known->doubt))
        continue;
      q.known = Known{{run.end(), run.end() + q.c.y0.size()},
                      apart,
                      fmt::format("{} and {}", other.solver, run.solver)};
      q.trusted = run;
    }
    runs.push_back(std::move(run));
  };
  const auto well = [&] { return q.known && q.known->doubt <= wanted(q); };
  for (const std::size_t k : in_order(q)) {
    if (runs.size() >= most_tight || well() || !q.time_for_more(0.35)) break;
    Run run = q.make(q.c, q.others[k].solver, tighter(q), states_along(q), 0.25);
    if (run.ok()) q.keep(run);
    take(std::move(run));
  }
  // Errors add up along many periods: two of other families once more, far tighter.
  const std::optional<std::pair<std::string, std::string>> two = cheapest_to_tighten(q, runs);
  for (const double part : {1e-4, 1e-6}) {
    if (q.known || !two || !(part * comparable(q).tolerance.relative > 1e-14)) break;
    for (const std::string& solver : {two->first, two->second}) {
      if (!q.time_for_more(0.35)) break;
      Run run = q.make(q.c, solver, tighter(q, part), states_along(q), 0.25);
      if (run.ok()) q.keep(run);
      take(std::move(run));
    }
  }
  if (q.known) return;
  // Two tight runs that do not agree say so; where fewer could be paid for, the others are taken.
  if (runs.size() >= 2) {
    q.disagree = std::pair(std::move(runs[runs.size() - 2]), std::move(runs.back()));
    return;
  }
  for (const std::size_t k : in_order(q)) {
    if (q.known || !q.time_for_more(0.25)) break;
    take(q.along(q.others[k]));
  }
}

}  // namespace

void find_known(Inquiry& q) {
  const std::vector<std::size_t> rows = in_order(q);
  if (!rows.empty()) q.find_sizes(q.along(q.others[rows.front()]));
  if (q.known = by_truth(q); q.known) {
    // All of them may have missed what makes a component grow.
    for (std::size_t i = 0; i < q.sizes.size(); ++i)
      if (q.sizes[i] == 0) q.sizes[i] = std::abs(q.known->end[i]);
    follow(q);
  } else {
    agree(q);
  }
  if (q.trusted) q.find_sizes(*q.trusted);
}

}  // namespace odeum::why
