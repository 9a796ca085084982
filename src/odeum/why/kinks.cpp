// SPDX-License-Identifier: BSD-3-Clause
// Where a right-hand side is not smooth along a run, and what that costs.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "odeum/why/inquiry.hpp"
#include "odeum/why/path.hpp"

namespace odeum::why {
namespace {

/// A smaller share of the evaluations is not worth a word.
constexpr double least_part = 0.01;

/// f along the path from one state to another, by the part of the time between them.
class Between {
 public:
  Between(const Case& c, const Moment& from, const Moment& to)
      : c_(c),
        from_(from),
        to_(to),
        f_from_(slope(c, from.t, from.y)),
        f_to_(slope(c, to.t, to.y)) {}
  double time(double s) const { return from_.t + s * (to_.t - from_.t); }
  /// f at the cubic of Hermite, a smooth path near the solution.
  std::vector<double> operator()(double s) const {
    const double h = to_.t - from_.t, a = s * s * (3 - 2 * s), b = s * (1 - s) * (1 - s),
                 d = s * s * (s - 1);
    std::vector<double> y(from_.y.size());
    for (std::size_t i = 0; i < y.size(); ++i)
      y[i] = from_.y[i] + a * (to_.y[i] - from_.y[i]) + h * (b * f_from_[i] + d * f_to_[i]);
    return slope(c_, time(s), y);
  }

 private:
  const Case& c_;
  const Moment &from_, &to_;
  std::vector<double> f_from_, f_to_;
};

/// The largest second difference of one component, and its ratio to the largest of those that are
/// not beside it.
struct Bend {
  double size = 0, stands_out = 0;
  std::size_t at = 1;
};
Bend bend_of(const std::vector<std::vector<double>>& values, std::size_t i) {
  Bend bend;
  const auto second = [&](std::size_t k) {
    return std::abs(values[k + 1][i] - 2 * values[k][i] + values[k - 1][i]);
  };
  for (std::size_t k = 1; k + 1 < values.size(); ++k)
    if (second(k) > bend.size) bend.size = second(k), bend.at = k;
  double other = 0;
  for (std::size_t k = 1; k + 1 < values.size(); ++k)
    if (k + 1 < bend.at || k > bend.at + 1) other = std::max(other, second(k));
  bend.stands_out = bend.size > 0 ? bend.size / std::max(other, 1e-300) : 0;
  return bend;
}

double size_of(const std::vector<std::vector<double>>& values, std::size_t i) {
  double size = 0;
  for (const std::vector<double>& value : values) size = std::max(size, std::abs(value[i]));
  return size;
}

/// The length of the step in which half of the time lies.
double usual_step(const Run& run) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < run.ends.size(); ++k) steps.push_back(run.ends[k] - run.ends[k - 1]);
  std::ranges::sort(steps);
  double sum = 0;
  for (const double h : steps)
    if (sum += h; sum >= 0.5 * (run.ends.back() - run.ends.front())) return h;
  return nan;
}

/// A jump less than `by` ahead that a path which has crossed it comes back to.
std::optional<Kink> jump_that_holds(const Case& c, const Moment& from, double by) {
  const auto jump = kink_between(c, from, ahead_of(c, from, by));
  if (!jump || !jump->jump) return {};
  const Moment past = ahead_of(c, from, jump->t - from.t + 0.05 * by);
  const auto again = kink_between(c, past, ahead_of(c, past, 0.5 * by));
  return again && again->jump ? jump : std::nullopt;
}

/// Where a solution stays at a jump, nearly all states of a run have it a few steps ahead, from one
/// on that has it within its next step. Those jumps; empty: it does not stay.
std::vector<Kink> jumps_it_stays_at(const Inquiry& q) {
  constexpr double few = 10, next = 0.5, nearly_all = 0.9;
  constexpr std::size_t least_states = 20, least_steps = 100, looks = 10;
  const std::vector<Moment>& moments = q.run.moments;
  const auto jump_ahead = [&](const Moment& from) -> std::optional<Kink> {
    const double by = few * q.run.step_at(from.t);
    if (!(by > 1e5 * epsilon * std::abs(from.t))) return {};
    return jump_that_holds(q.c, from, by);
  };
  // A run that stays at none shows it at a few states of its second half.
  if (moments.size() < least_states) return {};
  std::size_t seen = 0;
  for (std::size_t k = 0; k < looks; ++k)
    seen += jump_ahead(moments[moments.size() - 1 - k * moments.size() / (2 * looks)]).has_value();
  if (2 * seen < looks) return {};
  std::vector<Kink> jumps;
  std::size_t first = 0;
  for (std::size_t k = 0; k < moments.size() && q.left() > 0.5 * q.seconds; ++k) {
    const Moment& from = moments[k];
    const auto jump = jump_ahead(from);
    if (!jump || (jumps.empty() && jump->t - from.t > next * q.run.step_at(from.t))) continue;
    if (jumps.empty()) first = k;
    jumps.push_back(*jump);
  }
  const std::size_t since = moments.size() - first;
  const bool stays = since >= least_states &&
                     moments.back().step - moments[first].step >= least_steps &&
                     static_cast<double>(jumps.size()) >= nearly_all * static_cast<double>(since);
  return stays ? jumps : std::vector<Kink>();
}

/// Adds it where it takes a part of the evaluations, or is where the run ends.
bool add_sliding(Inquiry& q, const Kink& first, double until) {
  const std::vector<double>& times = q.run.trace.times;
  const auto since = std::ranges::count_if(
      times, [&](double t) { return t >= first.t && t <= until + 2 * q.run.step_at(until); });
  const double share = static_cast<double>(since) / static_cast<double>(times.size());
  const bool ends = until >= q.run.moments.back().t;
  if (share < least_part && !ends) return false;
  q.add(Cause::sliding, share, first.t,
        fmt::format("the solution stays where {}'s right-hand side jumps, from t = {:.6g} {}: both "
                    "sides lead there, and steps cross the jump again and again",
                    q.names[first.component], first.t,
                    ends ? "on" : fmt::format("to {:.6g}", until)));
  q.kinks = {first};
  return true;
}

/// The evaluations around kinks beyond those that the same time takes elsewhere, and the kink with
/// most of them.
std::pair<double, const Kink*> excess_of(const Run& run, const std::vector<Kink>& kinks,
                                         double wide) {
  std::vector<double> times = run.trace.times;
  std::ranges::sort(times);
  const auto before = [&](double t) {
    return static_cast<double>(std::ranges::lower_bound(times, t) - times.begin());
  };
  const double each = static_cast<double>(times.size()) /
                      static_cast<double>(run.steps() + run.outcome.counters.rejected_steps);
  double excess = 0, most = 0;
  const Kink* worst = &kinks.front();
  for (const Kink& kink : kinks) {
    const double own = std::max(0.0, before(kink.t + wide) - before(kink.t - wide) - 2 * each);
    excess += own;
    if (own > most) most = own, worst = &kink;
  }
  return {excess, worst};
}

/// Kinks of the conditions of a text, but for those in intervals with an event. A run that failed
/// may have stopped short of one.
Changed changes_between_events(const Inquiry& q, double wide) {
  const Run& run = q.run;
  Changed changed = kinks_of_conditions(q.c, q.conditions, run.moments, wide, !run.ok(), q.sizes);
  std::erase_if(changed.kinks, [&](const Kink& kink) {
    const auto to = std::ranges::lower_bound(run.moments, kink.t, {}, &Moment::t);
    return to != run.moments.begin() && to != run.moments.end() &&
           has_event_between(run, *(to - 1), *to);
  });
  return changed;
}

}  // namespace

std::optional<Kink> kink_between(const Case& c, const Moment& from, const Moment& to) {
  constexpr std::size_t parts = 8;
  constexpr int most_zooms = 9, needed = 4;
  constexpr double clear = 5;
  const Between f(c, from, to);
  double low = 0, high = 1;
  std::optional<std::size_t> component;
  std::vector<Bend> bends;
  for (int zoom = 0; zoom < most_zooms; ++zoom) {
    std::vector<std::vector<double>> at;
    for (std::size_t k = 0; k <= parts; ++k)
      at.push_back(f(low + (high - low) * static_cast<double>(k) / parts));
    for (const std::vector<double>& value : at)
      if (!is_finite(value.data(), value.size())) return {};
    if (!component) {
      double most = 0;
      for (std::size_t i = 0; i < from.y.size(); ++i)
        if (const double relative = bend_of(at, i).size / std::max(size_of(at, i), 1e-300);
            relative > most)
          most = relative, component = i;
      if (!component) return {};
    }
    const Bend bend = bend_of(at, *component);
    // The rounding of f, whose terms may be larger than it.
    if (bend.size < 1e6 * epsilon * size_of(at, *component)) break;
    bends.push_back(bend);
    const double part = (high - low) / parts;
    low += part * static_cast<double>(bend.at - 1);
    high = low + 2 * part;
  }
  if (bends.size() < needed) return {};
  for (std::size_t k = bends.size() - 2; k < bends.size(); ++k)
    if (bends[k].stands_out < clear) return {};
  // The bend falls with the square of the width where f is smooth, with the width at a kink, and
  // not at all at a jump; the width falls by four.
  const double power = std::log(bends[bends.size() - 4].size / bends.back().size) / std::log(64.0);
  // A pole of f bends ever more.
  if (power > 1.35 || power < -0.2) return {};
  return Kink{f.time(0.5 * (low + high)), *component, power < 0.35, bends.back().size,
              f.time(high) - f.time(low)};
}

bool has_event_between(const Run& run, const Moment& from, const Moment& to) {
  const auto& events = run.outcome.events;
  const auto next = std::ranges::lower_bound(events, from.t, {}, &EventMet::t);
  return next != events.end() && next->t <= to.t;
}

void look_for_kinks(Inquiry& q) {
  const Run& run = q.run;
  const double end = run.ends.back();
  double wide = usual_step(run);
  if (!(wide > 0)) wide = 1e-3 * (run.request.stops.back() - q.c.t0);  // it failed at the start
  q.kink_reach = wide;
  // A run that failed may have stopped short of a change.
  const Changed changed = changes_between_events(q, wide);
  if (changed.stays && !changed.kinks.empty() &&
      add_sliding(q, changed.kinks.back(), changed.until))
    return;
  if (q.conditions.count == 0 && !q.c.problem.events)
    if (const auto jumps = jumps_it_stays_at(q);
        !jumps.empty() && add_sliding(q, jumps.front(), run.moments.back().t))
      return;
  const bool ends = q.found(Cause::pole) || q.found(Cause::growth) || q.found(Cause::singular);
  const auto near_end = [&](double t) {
    return std::abs(end - t) < 1e-6 * std::max(1.0, std::abs(t));
  };
  for (const Kink& kink : changed.kinks)
    if (!(ends && near_end(kink.t))) q.kinks.push_back(kink);
  for (std::size_t k = 0; k + 1 < run.moments.size() && q.left() > 0.3 * q.seconds; ++k) {
    const Moment &from = run.moments[k], &to = run.moments[k + 1];
    // Less is the rounding of t.
    if (!(to.t - from.t > 1e5 * epsilon * std::abs(to.t))) continue;
    if (has_event_between(run, from, to)) continue;
    if (std::ranges::any_of(changed.kinks,
                            [&](const Kink& kink) { return kink.t >= from.t && kink.t <= to.t; }))
      continue;
    const auto kink = kink_between(q.c, from, to);
    if (kink && !(ends && near_end(kink->t))) q.kinks.push_back(*kink);
  }
  if (!run.ok() && !ends && changed.kinks.empty()) {
    // The run may have stopped short of one.
    const Moment ahead = ahead_of(q.c, run.moments.back(), wide);
    if (const auto kink = kink_between(q.c, run.moments.back(), ahead)) q.kinks.push_back(*kink);
  }
  std::ranges::sort(q.kinks, {}, &Kink::t);
  // Kinks that no error test sees, such as the last digit of a function, are left out.
  const Tolerance& tolerance = run.request.tolerance;
  std::erase_if(q.kinks, [&](const Kink& kink) {
    const std::size_t i = kink.component;
    return kink.effect(wide) < 0.1 * (tolerance.absolute(i) + tolerance.relative * q.sizes[i]);
  });
  if (q.kinks.empty()) return;
  const auto [excess, worst] = excess_of(run, q.kinks, wide);
  const double share = std::min(1.0, excess / static_cast<double>(run.trace.times.size()));
  if (share < least_part && (run.ok() || !near_end(worst->t))) {
    q.kinks.clear();
    return;
  }
  const std::size_t others = q.kinks.size() - 1;
  q.add(
      Cause::kink, share, worst->t,
      fmt::format(
          "{} of {}'s right-hand side {} at t = {:.8g}{}", worst->jump ? "the value" : "the slope",
          q.names[worst->component], worst->jump ? "jumps" : "has a kink", worst->t,
          others > 0 ? fmt::format(", as at {} other time{}", others, others > 1 ? "s" : "") : ""));
}

}  // namespace odeum::why
