// SPDX-License-Identifier: BSD-3-Clause
// One run on each case.
#include <algorithm>
#include <cmath>
#include <numeric>

#include "odeum/advise/search.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"

namespace odeum::advise {

double Trial::state_error() const { return parts[worst()].error; }

double Trial::energy_error() const {
  double largest = nan;
  for (const Part& part : parts)
    if (!(part.energy_error <= largest)) largest = part.energy_error;
  return largest;
}

std::size_t Trial::worst() const {
  const auto larger = [](const Part& a, const Part& b) { return a.error < b.error; };
  return static_cast<std::size_t>(std::ranges::max_element(parts, larger) - parts.begin());
}

Search::Search(const std::vector<const Case*>& cases, const Wishes& wishes, std::uint64_t frames)
    : c_(*cases.front()),
      wishes_(wishes),
      multiple_(frames > 0 ? std::lcm(frames, c_.settings.steps_multiple)
                           : c_.settings.steps_multiple),
      seconds_(wishes.seconds > 0 ? wishes.seconds : 20),
      before_(std::min(seconds_since(wishes.start), process_seconds() - wishes.used_at_start)),
      clock_(wishes.clock) {
  // One frame would foresee little.
  first_ = c_.stops[frames > 0 || c_.measures_particles ? (c_.stops.size() - 1) / 4 : 0];
  for (const Case* c : cases)
    stages_.push_back({c,
                       {*c, c->stops},
                       {*c, {first_}},
                       {*c, {c->stops.back()}},
                       c->energy ? c->energy(c->y0.data()) : nan});
}

double Search::left() const { return seconds_ - std::min(before_, 0.5 * seconds_); }

bool Search::late(double share) const { return clock_.spent() > share * left(); }

double Search::part_of(To to) const {
  return to == To::first ? (first_ - c_.t0) / (c_.stops.back() - c_.t0) : 1;
}

Request Search::request_for(const Stage& stage, const Candidate& candidate, double fineness,
                            To to) const {
  const Case& c = *stage.c;
  Request request;
  request.mode = candidate.mode;
  request.stops = to == To::first ? std::vector<double>{first_}
                  : to == To::end ? std::vector<double>{c.stops.back()}
                                  : c.stops;
  request.over_stops = to == To::inside;
  if (candidate.mode == Mode::adaptive)
    set_tolerance(request, c, 1 / fineness);
  else
    request.steps =
        std::max(1ULL, static_cast<unsigned long long>(std::llround(fineness * part_of(to))));
  // A run that may be the answer has its time also where the seconds are over.
  const double remains = std::max(0.01, left() - clock_.spent());
  // Budgets are of wall time, which other programs stretch.
  request.budget.seconds = std::isfinite(best_ns_)
                               ? clock_.crowding() * std::max(2e-3, patience_ * 1e-9 * best_ns_)
                               : std::min(remains, clock_.crowding() * cap_seconds_);
  // The time of one that was found is about known, also where the seconds are over.
  if (candidate.found)
    request.budget.seconds = std::max(request.budget.seconds, 0.05 + 4e-9 * candidate.found->ns);
  return request;
}

/// The energy's largest distance from that at the start, over a run to the horizon with the same
/// steps or tolerance; infinite where that run fails.
double Search::drift_to_horizon(const Stage& stage, const Entrant& entrant,
                                const Part& part) const {
  constexpr int looks = 16;
  const Case& c = *stage.c;
  const double longer = (wishes_.horizon - c.t0) / (c.stops.back() - c.t0);
  Request request = part.request;
  request.stops.clear();
  for (int k = 1; k <= looks; ++k)
    request.stops.push_back(c.t0 + (wishes_.horizon - c.t0) * k / looks);
  if (request.mode == Mode::fixed)
    request.steps = static_cast<std::uint64_t>(
        looks * std::llround(longer / looks * static_cast<double>(request.steps)));
  request.budget.seconds =
      std::min(longer * request.budget.seconds, std::max(0.01, seconds_ - clock_.spent()));
  const Outcome outcome = entrant.solve(request);
  if (outcome.status != Status::ok) return infinity;
  double drift = 0;
  for (int k = 0; k < looks; ++k) {
    const double* y = outcome.states.data() + static_cast<std::size_t>(k) * c.y0.size();
    const double each = std::abs(c.energy(y) / stage.first_energy - 1);
    if (!(each <= drift)) drift = each;
  }
  return drift;
}

Status Search::run_on(const Stage& stage, const Entrant& entrant, Part& part, To to) const {
  const double start = clock_.used();
  const Outcome outcome = entrant.solve(part.request);
  part.take(*stage.c, entrant.info, part.request, outcome);
  part.ns = std::max(1.0, 1e9 * (clock_.used() - start) -
                              4.0 * static_cast<double>(outcome.counters.rhs_evaluations));
  if (outcome.status != Status::ok) return outcome.status;
  part.take_errors(stage.judge(to).errors(outcome));
  if (wishes_.horizon > 0 && to == To::all && part.error <= wishes_.error &&
      part.energy_error <= wishes_.energy)
    if (const double drift = drift_to_horizon(stage, entrant, part); !(drift <= part.energy_error))
      part.energy_error = drift;
  return outcome.status;
}

/// The largest error of the parts, or of their energies in proportion to what is asked of these.
void Search::take_errors(Trial& trial) const {
  trial.error = 0;
  for (const Part& part : trial.parts) {
    if (!(part.error <= trial.error)) trial.error = part.error;
    const double by_energy = part.energy_error * wishes_.error / wishes_.energy;
    if (wishes_.energy > 0 && !(by_energy <= trial.error)) trial.error = by_energy;
  }
}

Trial Search::run(const Candidate& candidate, double fineness, To to) const {
  if (interrupted) throw Interrupted();
  Trial trial;
  trial.fineness = fineness;
  for (std::size_t k = 0; k < stages_.size() && trial.status == Status::ok; ++k) {
    Part part;
    part.request = request_for(stages_[k], candidate, fineness, to);
    trial.status = run_on(stages_[k], *candidate.on[k], part, to);
    trial.ns += part.ns;
    trial.parts.push_back(std::move(part));
  }
  trial.ns /= static_cast<double>(trial.parts.size());
  if (trial.status == Status::ok) take_errors(trial);
  return trial;
}

double Search::bare_ns(const Candidate& candidate, const Trial& trial) const {
  double sum = 0;
  for (std::size_t k = 0; k < trial.parts.size(); ++k) {
    Request request = trial.parts[k].request;
    request.budget.watched = false;
    Status status = Status::ok;
    sum += clock_.of([&] { status = candidate.on[k]->solve(request).status; }, trial.parts[k].ns);
    if (status != Status::ok) return infinity;
  }
  return sum / static_cast<double>(trial.parts.size());
}

Trial Search::command_run(const Candidate& candidate, double fineness) const {
  Trial made = run(candidate, fineness, To::end);
  if (made.status != Status::ok) return made;
  // Output may end a peer's steps, so that its states inside are those of a run apart.
  const Trial inside = run(candidate, fineness, To::inside);
  made.status = inside.status;
  for (std::size_t k = 0; k < made.parts.size() && made.status == Status::ok; ++k) {
    Part& part = made.parts[k];
    part.end_error = part.error;
    if (!(inside.parts[k].error <= part.error)) part.error = inside.parts[k].error;
    if (!(inside.parts[k].energy_error <= part.energy_error))
      part.energy_error = inside.parts[k].energy_error;
  }
  made.error = nan;
  if (made.status == Status::ok) take_errors(made);
  return made;
}

Trial Search::as_command(const Candidate& candidate) const {
  Trial made = command_run(candidate, candidate.found->fineness);
  if (wishes_.time_ns > 0 || candidate.mode == Mode::fixed) return made;
  constexpr int most_tries = 3;
  constexpr double hopeless = 30;
  constexpr std::uint64_t dearer = 2;
  for (int k = 0; k < most_tries && made.status == Status::ok && !made.reaches(wishes_.error);
       ++k) {
    const double off = made.error / wishes_.error;
    if (!(off < hopeless) || late(0.95)) break;
    const double finer = in_range(
        candidate, made.fineness * std::max(1.2, std::pow(1.2 * off, 1 / candidate.slope())));
    if (finer == made.fineness) break;
    Trial next = command_run(candidate, finer);
    if (next.counters().work > dearer * candidate.found->counters().work) break;
    made = std::move(next);
  }
  return made;
}

}  // namespace odeum::advise
