// SPDX-License-Identifier: BSD-3-Clause
// What lies between the evaluations of a run: pulses, and periods shorter than its steps.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "odeum/why/inquiry.hpp"
#include "odeum/why/path.hpp"

namespace odeum::why {
namespace {

/// The time from one change of the equations to the next.
struct Interval {
  double from, to;
  std::size_t component;
};

/// What a run lets a component be off.
double allowed(const Inquiry& q, const Run& run, std::size_t i) {
  const Tolerance& tolerance = run.request.tolerance;
  return run.request.mode == Mode::adaptive
             ? tolerance.absolute(i) + tolerance.relative * q.sizes[i]
             : far_off * q.sizes[i];
}

/// The intervals within which a run has no evaluation, or after a kink none that shows that f is
/// another by a part that matters; `times` ascend.
std::vector<Interval> without_evaluations(const Inquiry& q, const Run& run, const Path& path,
                                          const std::vector<Kink>& kinks,
                                          const std::vector<double>& times) {
  std::vector<Interval> found;
  for (std::size_t k = 0; k + 1 < kinks.size(); ++k) {
    const double from = kinks[k].t, to = kinks[k + 1].t;
    const auto first = std::ranges::lower_bound(times, from),
               last = std::ranges::lower_bound(times, to);
    if (kinks[k].jump) {
      if (first == last) found.push_back({from, to, kinks[k].component});
      continue;
    }
    const std::vector<double> before = path.slope(from), after = path.slope(to);
    const auto deviation = [&](std::size_t i, double t) {
      return std::abs(path.slope(t)[i] - 0.5 * (before[i] + after[i]));
    };
    for (std::size_t i = 0; i < before.size(); ++i) {
      const double most = deviation(i, 0.5 * (from + to));
      if (!(most * (to - from) > 10 * allowed(q, run, i)) ||
          std::any_of(first, last, [&](double t) { return deviation(i, t) > 0.1 * most; }))
        continue;
      found.push_back({from, to, i});
      break;
    }
  }
  return found;
}

std::vector<double> ascending(std::vector<double> times) {
  std::ranges::sort(times);
  return times;
}

/// The evaluations of each step that was accepted, by the order in which they were made: those of
/// a trial beyond its end, which was rejected, come before.
std::vector<std::vector<double>> accepted_evaluations(const Run& run) {
  const std::vector<double>& times = run.trace.times;
  std::vector<std::size_t> step_of, last(run.steps(), times.size());
  for (std::size_t j = 0; j < times.size(); ++j) {
    const auto above = std::ranges::lower_bound(run.ends, times[j]);
    step_of.push_back(static_cast<std::size_t>(
        std::clamp<std::ptrdiff_t>(above - run.ends.begin(), 1, std::ssize(last)) - 1));
    last[step_of.back()] = j;
  }
  std::vector<std::vector<double>> found(run.steps());
  for (std::size_t k = 0; k < found.size(); ++k)
    for (std::size_t j = last[k] + 1; last[k] < times.size() && j-- > 0 && step_of[j] == k;)
      found[k].push_back(times[j]);
  return found;
}

/// A step of a run along the solution: f where the run evaluates it, and at many times.
class Step {
 public:
  Step(const Path& path, double from, double to, const std::vector<double>& evaluations,
       const std::vector<Moment>& known)
      : path_(path), from_(from), to_(to), seen_(evaluations) {
    constexpr double least = 32, evenly = 4000;  // in a step, and in all of them
    const double span = path.end() - path.start();
    const auto parts = static_cast<int>(std::max(least, evenly * (to - from) / span));
    for (int k = 0; k <= parts; ++k) times_.push_back(from + (to - from) * k / parts);
    for (const Moment& at : known)
      if (at.t > from && at.t < to) times_.push_back(at.t);
    std::ranges::sort(times_);
    for (const double t : times_) slopes_.push_back(path.slope(t));
  }

  /// The deviation from the straight line between the slopes at the ends.
  double deviation(std::size_t i, double t, double value) const {
    const double part = (t - from_) / (to_ - from_);
    return value - (slopes_.front()[i] + part * (slopes_.back()[i] - slopes_.front()[i]));
  }
  double largest(std::size_t i) const {
    double most = 0;
    for (std::size_t k = 0; k < times_.size(); ++k)
      most = std::max(most, std::abs(deviation(i, times_[k], slopes_[k][i])));
    return most;
  }
  bool sees(const Interval& at) const {
    return std::ranges::any_of(seen_, [&](double t) { return t >= at.from && t <= at.to; });
  }
  /// The interval in which the deviation is more than half of its largest.
  Interval pulse(std::size_t i) const {
    const double half = 0.5 * largest(i);
    Interval found{to_, from_, i};
    for (std::size_t k = 0; k < times_.size(); ++k) {
      if (std::abs(deviation(i, times_[k], slopes_[k][i])) < half) continue;
      found.from = std::min(found.from, times_[k > 0 ? k - 1 : 0]);
      found.to = std::max(found.to, times_[std::min(k + 1, times_.size() - 1)]);
    }
    return found;
  }
  /// How often it turns round, by a part of its range, and the directions at the ends.
  struct Turns {
    int count = 0, first = 0, last = 0;
  };
  Turns turns(std::size_t i) const {
    const double least = 0.2 * largest(i);
    int count = 0, direction = 0, first = 0;
    double extreme = slopes_.front()[i];
    for (const std::vector<double>& f : slopes_) {
      if (direction * (f[i] - extreme) > 0 || direction == 0) {
        if (direction == 0 && std::abs(f[i] - extreme) > least)
          first = direction = f[i] > extreme ? 1 : -1, extreme = f[i];
        else if (direction != 0)
          extreme = f[i];
      } else if (std::abs(f[i] - extreme) > least) {
        ++count;
        direction = -direction;
        extreme = f[i];
      }
    }
    return {count, first, direction};
  }

 private:
  const Path& path_;
  double from_, to_;
  const std::vector<double>& seen_;  ///< the evaluations
  std::vector<double> times_;
  std::vector<std::vector<double>> slopes_;
};

/// Adds the pulse where the run is near the solution before it, in the components that its
/// tolerance holds; else the run misses more than that.
void add_pulse(Inquiry& q, const Interval& unseen) {
  if (q.trusted && q.run.moments.size() > 1) {
    // A smooth pulse has begun before half of its height, and states between those of a run are
    // not those of the solution around it.
    const double early = unseen.from - 2 * (unseen.to - unseen.from);
    const std::vector<Moment>& known = q.trusted->moments;
    const auto after = std::ranges::upper_bound(known, early, {}, &Moment::t);
    const Moment& before = after == known.begin() ? known.front() : *(after - 1);
    const std::vector<double> own = Path(q.c, q.run.moments).state(before.t);
    for (std::size_t i = 0; i < own.size(); ++i)
      if (allowed(q, q.run, i) < q.sizes[i] &&
          !(std::abs(own[i] - before.y[i]) <= far_off * q.sizes[i]))
        return;
  }
  q.pulse = unseen.to - unseen.from;
  q.add(Cause::pulse, nan, unseen.from,
        fmt::format("the run steps over t = {:.6g} to {:.6g}, where {}'s right-hand side is "
                    "another: it has no evaluation there that shows it",
                    unseen.from, unseen.to, q.names[unseen.component]));
}

/// The range of component i of f at the ends of some steps before and after step k.
double range_around(const std::vector<std::vector<double>>& slopes, std::size_t k, std::size_t i) {
  constexpr std::size_t wide = 2;
  double low = infinity, high = -infinity;
  for (std::size_t j = k - std::min(k, wide); j < std::min(k + 2 + wide, slopes.size()); ++j) {
    low = std::min(low, slopes[j][i]);
    high = std::max(high, slopes[j][i]);
  }
  return high - low;
}

/// What is in the steps of a run along states that are nearer to the solution, or its own.
struct Inside {
  std::optional<Interval> pulse;
  double aliased = 0;  ///< the time of steps in which f turns round and back
  double turns = 0;    ///< of f a step, where all steps are equal
  double period = infinity, since = nan;
  std::size_t component = 0;
};
Inside look_into_steps(const Inquiry& q, const Run& run, const std::vector<Moment>& along) {
  constexpr std::size_t most_numbers = 60'000;
  Inside found;
  const std::size_t n = q.c.y0.size();
  if (run.steps() * n > most_numbers || run.steps() == 0 || along.size() < 2) return found;
  const Path path(q.c, along);
  const std::vector<std::vector<double>> times = accepted_evaluations(run);
  std::vector<int> turned(n), last(n);  // from one step to the next
  std::vector<std::vector<double>> at_ends;
  for (const double t : run.ends) at_ends.push_back(path.slope(t));
  for (std::size_t k = 0; k + 1 < run.ends.size() && q.time_for_more(0.2); ++k) {
    const double from = run.ends[k], to = run.ends[k + 1];
    const Step step(path, from, to, times[k], along);
    bool back = false;
    for (std::size_t i = 0; i < n; ++i) {
      const double most = step.largest(i), least = allowed(q, run, i);
      if (!(most * (to - from) > least) || !std::isfinite(most)) continue;
      const Interval at = step.pulse(i);
      // A method may evaluate f at the ends alone, from which it is known between them where it
      // changes as much from one to the next.
      const bool matters =
          most * (at.to - at.from) > 10 * least && most > 2 * range_around(at_ends, k, i);
      if (!found.pulse && matters && !step.sees(at)) found.pulse = at;
      const auto [count, first, direction] = step.turns(i);
      if (count == 0) continue;
      turned[i] += count + (first * last[i] < 0 ? 1 : 0);
      last[i] = direction;
      if (std::isnan(found.since)) found.since = from, found.component = i;
      if (count < 2) continue;
      if (!back) found.component = i;
      back = true;
      found.period = std::min(found.period, 2 * (to - from) / count);
    }
    if (back) found.aliased += to - from;
  }
  if (run.request.mode != Mode::fixed) return found;
  found.turns = *std::ranges::max_element(turned) / static_cast<double>(run.steps());
  found.period = std::min(found.period, 2 * (run.ends.back() - run.ends.front()) /
                                            (found.turns * static_cast<double>(run.steps())));
  return found;
}

}  // namespace

bool has_unseen(const Inquiry& q, const Run& run) {
  if (!run.outcome.events.empty()) return false;  // no smooth path joins its states
  const double wide = (run.ends.back() - run.ends.front()) / 100;
  const Changed changed = kinks_of_conditions(q.c, q.conditions, run.moments, wide, false, q.sizes);
  const Path path(q.c, run.moments);
  return !without_evaluations(q, run, path, changed.kinks, ascending(run.trace.times)).empty() ||
         look_into_steps(q, run, run.moments).pulse;
}

void look_for_unseen(Inquiry& q) {
  if (!q.run.outcome.events.empty()) return;
  // Where nobody ends near the solution, all may have missed the same.
  const Run& along = q.trusted ? *q.trusted : q.run;
  if (q.trusted && !(q.difference(q.run) > std::min(10 * wanted(q), far_off))) return;
  const Changed changed =
      kinks_of_conditions(q.c, q.conditions, along.moments, q.run.step_at(q.c.t0), false, q.sizes);
  const std::vector<Interval> unseen = without_evaluations(
      q, q.run, Path(q.c, along.moments), changed.kinks, ascending(q.run.trace.times));
  constexpr std::size_t few = 5;
  if (!unseen.empty() && unseen.size() < few) return add_pulse(q, unseen.front());
  const Inside inside = look_into_steps(q, q.run, along.moments);
  // Equal steps as long as the period have two turns each, one of them at an end.
  constexpr double least_part = 0.25, nearly_two = 1.8;
  // Steps beyond the edge of the region make the motion that turns, where they lead; what decays
  // at once after a change is not a pulse.
  const bool beyond = !q.adaptive() && std::ranges::any_of(q.samples, [](const Sample& s) {
    return s.used > 1 && s.used < infinity;
  });
  if (beyond && !q.trusted) return;
  if (inside.aliased > least_part * (q.run.ends.back() - q.c.t0) || inside.turns > nearly_two) {
    q.period = inside.period;
    q.add(Cause::aliasing, nan, inside.since,
          fmt::format("{}'s right-hand side turns round and back within single steps, some {:.3g} "
                      "long, from t = {:.4g} on: its period is near {:.2g}, and few evaluations of "
                      "a step do not show it",
                      q.names[inside.component], q.run.step_at(inside.since), inside.since,
                      inside.period));
  } else if (inside.pulse && !beyond) {
    add_pulse(q, *inside.pulse);
  }
}

}  // namespace odeum::why
