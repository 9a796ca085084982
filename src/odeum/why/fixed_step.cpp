// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "odeum/why/inquiry.hpp"
#include "odeum/why/path.hpp"

namespace odeum::why {
namespace {

/// How large the run's own states became over those of the solution.
double blown_up(const Inquiry& q) {
  double most = 0;
  for (const Moment& at : q.run.moments)
    for (std::size_t i = 0; i < at.y.size(); ++i)
      if (q.sizes[i] > 0) {
        const double each = std::abs(at.y[i]) / q.sizes[i];
        if (!(each <= most)) most = each;
      }
  return q.run.ok() ? most : infinity;
}

/// The row of a run with steps inside of the edge, unless that takes too many.
std::optional<std::size_t> run_inside(Inquiry& q) {
  double used = 0;
  for (const Sample& s : q.samples)
    if (s.used < infinity) used = std::max(used, s.used);
  constexpr double most_steps_made = 5e6;
  const double steps = std::ceil(static_cast<double>(q.run.request.steps) * used * 1.05);
  if (!(used > 1) || steps > most_steps_made) return {};
  Request request = q.run.request;
  request.steps = static_cast<std::uint64_t>(steps);
  return q.also(q.why.solver, request, 0.3);
}

/// Whether steps inside of the edge make it good.
bool steps_inside_help(const Inquiry& q, const std::optional<std::size_t>& row) {
  if (!row) return true;
  const Run& inside = q.others[*row];
  // Too long a run has at least come past where this one ended.
  if (inside.outcome.status == Status::over_budget)
    return !q.run.ok() && inside.ends.back() > q.run.ends.back();
  return q.difference(inside) < 0.1 * q.difference(q.run);
}

}  // namespace

void look_at_edge(Inquiry& q) {
  // Finds where a step first leaves the region, and for how much of the time.
  const Sample* first = nullptr;
  const Sample* worst = nullptr;
  double outside = 0, all = 0;
  for (const Sample& s : q.samples) {
    all += s.weight;
    // Without any step that is stable, what each step makes of the energy says more.
    if (!(s.used > 1) || (s.used == infinity && q.found(Cause::energy))) continue;
    outside += s.weight;
    if (!first) first = &s;
    if (!worst || s.used > worst->used) worst = &s;
  }
  if (!first) return;
  const double decays = std::abs(worst->binding.real());
  const double step = worst->at.h;
  std::string text = fmt::format(
      "{} {} at {:.3g} per unit of time, ", q.name_of(worst->spectrum.component),
      decays > 0.5 * std::abs(worst->binding) ? "decays" : "oscillates", std::abs(worst->binding));
  text += worst->used < infinity
              ? fmt::format("a step of {:.3g} is {:.3g} times what is stable ({:.3g})", step,
                            worst->used, step / worst->used)
              : "where no step of this method is stable";
  q.add(Cause::stability, outside / all, first->at.t, text);
}

namespace {

/// Whether steps inside of the edge of what decays are still too coarse for the rest of the motion.
void look_inside_the_edge(Inquiry& q, const std::size_t row) {
  const double off = q.difference(q.others[row]);
  const bool decays = std::ranges::any_of(q.samples, [](const Sample& s) {
    return s.used > 1 && std::abs(s.binding.real()) > 0.5 * std::abs(s.binding);
  });
  if (!q.found(Cause::stability) || !decays || q.found(Cause::energy) || q.found(Cause::aliasing) ||
      !(off > far_off && off < infinity))
    return;
  constexpr std::uint64_t times = 4;
  Request finer = q.others[row].request;
  finer.steps *= times;
  const double there = q.difference(q.others[q.also(q.why.solver, finer, 0.3)]);
  if (!(there < 0.5 * off)) return;
  q.add(Cause::too_coarse, nan, q.c.t0,
        fmt::format("inside of the edge the steps are still too coarse for the rest: {} of them "
                    "end {:.2g} of the solution's size away, {} times as many {:.2g}",
                    finer.steps / times, off, times, there));
}

/// Whether the method multiplies what decays by more than 1, and far enough to explain the error.
bool feeds_what_decays(const Inquiry& q, double off) {
  double by_method = 0, by_problem = 0;
  for (const Sample& s : q.samples) {
    if (!(s.used > 1) || !(s.binding.real() < -1e-6 * std::abs(s.binding))) continue;
    by_method += s.weight * q.region.growth(s.at.h * s.binding);
    by_problem += s.weight * s.at.h * s.binding.real();
  }
  return by_method > 0.1 &&
         std::exp(std::min(by_method, 700.0)) - std::exp(by_problem) > 0.2 * std::min(off, 1.0);
}

/// Whether a step many times as long is as exact, or as exact as is usual where this one was not
/// paid for.
void look_for_fineness(Inquiry& q) {
  if (!q.known) return;
  constexpr std::uint64_t times = 10, least_steps = 10;
  const double enough =
      std::max({q.run.ok() ? 3 * q.difference(q.run) : usual_tolerance, 1e-9, q.known->doubt});
  // What all such steps miss hides the error of the rest: then it ends where this one does.
  const bool missed = q.found(Cause::pulse);
  const auto as_good = [&](const Run& other) {
    return missed ? other.ok() && q.apart(other, q.run) <= usual_tolerance
                  : q.difference(other) <= enough;
  };
  Request coarser = q.run.request;
  std::optional<std::size_t> found;
  while (coarser.steps > times * least_steps && q.time_for_more(0.1)) {
    coarser.steps /= times;
    const std::size_t k = q.also(q.why.solver, coarser, 0.2);
    const bool unpaid = q.others[k].outcome.status == Status::over_budget;
    if (!unpaid && !as_good(q.others[k])) break;
    if (!unpaid) found = k;
  }
  if (!found || !q.others[*found].ok()) return;
  const double longer = static_cast<double>(q.run.request.steps) /
                        static_cast<double>(q.others[*found].request.steps);
  if (missed) {
    q.add(Cause::too_fine, nan, q.c.t0,
          fmt::format("beside that, the step is far finer than the rest needs: one {:.3g} times as "
                      "long ends within {:.2g} of this one",
                      longer, usual_tolerance));
    return;
  }
  q.add(Cause::too_fine, 1, q.c.t0,
        fmt::format("the step is far finer than its error needs: one {:.3g} times as long ends "
                    "{:.2g} of the solution's size away{}",
                    longer, q.difference(q.others[*found]),
                    q.run.ok() ? fmt::format(", this one {:.2g}", q.difference(q.run))
                               : ", and this one was not at the end in the time it had"));
}

}  // namespace

/// Kinks and jumps of the equations within steps of one length take the order of the method: its
/// error falls as the step, or as its square, where it is claimed to fall faster.
void look_for_lost_order(Inquiry& q) {
  const double claimed = q.c.entrants.find(q.why.solver)->info.order, off = q.difference(q.run);
  constexpr double least_claimed = 1.5, lost = 0.6, lost_of_many = 1.2;
  if (!(claimed >= least_claimed) || q.conditions.count == 0) return;
  const double step = step_of(q.run.request, q.c.t0);
  const Run& along = q.trusted ? *q.trusted : q.run;
  std::vector<Kink> kinks =
      kinks_of_conditions(q.c, q.conditions, along.moments, step, false, q.sizes).kinks;
  // A kink between two steps takes nothing.
  std::erase_if(kinks, [&](const Kink& kink) {
    const double part = std::remainder((kink.t - q.c.t0) / step, 1.0);
    return std::abs(part) < 1e-9 || !(kink.t < q.run.request.stops.back());
  });
  if (kinks.empty()) return;
  // Two refinements: a kink lies elsewhere in each step.
  constexpr std::uint64_t times = 32, most_steps = 2'000'000;
  Request finer = q.run.request;
  finer.steps *= times;
  if (finer.steps > most_steps) return;
  const double there = q.difference(q.others[q.also(q.why.solver, finer, 0.3)]);
  const double order = std::log(off / there) / std::log(static_cast<double>(times));
  if (!(there > 0) || !(order < claimed - (claimed < 3 ? lost : lost_of_many)) || !(order > 0.3))
    return;
  q.add(
      Cause::kink, nan, kinks.front().t,
      fmt::format("{} of {}'s right-hand side {} at t = {:.8g}{}, inside of a step: {} times the "
                  "steps have {:.2g} of the error, order {:.2g}, where {} has {:g}",
                  kinks.front().jump ? "the value" : "the slope", q.names[kinks.front().component],
                  kinks.front().jump ? "jumps" : "has a kink", kinks.front().t,
                  kinks.size() > 1 ? fmt::format(", as at {} more", kinks.size() - 1) : "", times,
                  there / off, order, q.why.solver, claimed));
}

void look_at_fixed_step(Inquiry& q) {
  const double step =
      q.run.ends.size() > 1 ? q.run.ends[1] - q.run.ends[0] : step_of(q.run.request, q.c.t0);
  for (Sample& s : q.samples)
    if (s.used > 1) s.cause = Cause::stability;
  if (!q.samples.empty()) make_segments(q);
  const double off = q.difference(q.run), size = blown_up(q);
  if (q.run.outcome.status == Status::over_budget) return look_for_fineness(q);
  if (off <= far_off) {
    // Steps beyond the edge need not blow up where f bends back; a small error may be theirs, or
    // that of a kink.
    if (off > std::max(usual_tolerance, 10 * q.known->doubt)) {
      if (steps_inside_help(q, run_inside(q))) look_at_edge(q);
      if (q.why.findings.empty()) look_for_lost_order(q);
    }
    if (q.why.findings.empty()) look_for_fineness(q);
    return;
  }
  if (q.run.ok()) look_for_kinks(q);
  if (q.run.ok() && !q.found(Cause::sliding)) look_for_unseen(q);
  if (q.found(Cause::pulse)) look_for_fineness(q);
  if (std::isnan(off)) return look_at_amplification(q);
  look_at_energy(q, step, off);
  const auto inside = size < 3 ? std::nullopt : run_inside(q);
  if (size < 3 ? feeds_what_decays(q, off) : steps_inside_help(q, inside)) look_at_edge(q);
  if (inside) look_inside_the_edge(q, *inside);
  if (q.run.outcome.status == Status::newton_failed)
    q.add(Cause::newton, nan, q.run.ends.back(),
          fmt::format("the equations of a step of {:.3g} are not solved at t = {:.6g}", step,
                      q.run.ends.back()));
  if (q.why.findings.empty() && q.run.ok()) look_for_lost_order(q);
  if (q.why.findings.empty()) look_at_amplification(q);
  if (!q.why.findings.empty()) return;
  // Not unstable: does the error fall with the step as that of a coarse one does?
  Request finer = q.run.request;
  double ratio = 0;
  constexpr int most_parts = 4;  // of four times the steps each
  constexpr std::uint64_t most_steps_made = 1'000'000;
  for (int part = 0; part < most_parts && !(ratio > 2) && finer.steps < most_steps_made; ++part) {
    finer.steps *= 4;
    ratio = off / q.difference(q.others[q.also(q.why.solver, finer, 0.3)]);
  }
  if (!(ratio > 2)) return;
  const std::uint64_t times = finer.steps / q.run.request.steps;
  // A Jacobian whose eigenvectors are far from orthogonal has such runs.
  if (size > 10 && ratio > 100) {
    q.add(Cause::stability, 1, q.c.t0,
          fmt::format("the states grow to {:.2g} times the size of the solution, and not with {} "
                      "times the steps, although a step times each eigenvalue is in the region",
                      size, times));
    return;
  }
  double rate = 0;
  for (const Sample& s : q.samples) rate = std::max(rate, s.rate);
  q.add(Cause::too_coarse, 1, q.c.t0,
        fmt::format("the solution changes at up to {:.3g} per unit of time, {:.3g} of its size in "
                    "a step; {} times the steps have {:.2g} of the error",
                    rate, rate * step, times, 1 / ratio));
}

}  // namespace odeum::why
