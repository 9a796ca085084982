// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/event_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "odeum/kernel/dense_output.hpp"
#include "odeum/solvers/event_progress.hpp"

namespace odeum {
namespace {

using Found = EventFinder::Found;

class EventRun : EventProgress {
 public:
  EventRun(const ErasedContest& contest, const Request& request, const SegmentRun& segment)
      : EventProgress(contest, request),
        segment_(segment),
        fixed_(request.mode == Mode::fixed),
        grid_(contest.t0, request),
        finder_(events_, y_.size()) {}

  Outcome operator()() {
    if (const std::string why = refusal(grid_); !why.empty()) return refused(why);
    happen({});
    finder_.begin({}, *course_, {});
    std::vector<Switch> cuts;
    if (contest_.switches && !fixed_) cuts = contest_.switches(t_, end_);
    double first = -Piece::unbounded;
    auto cut = cuts.begin();
    while (go_on_) {
      const double switched = cut == cuts.end() ? Piece::unbounded : cut->t,
                   by_clock = course_->next();
      const double next = std::min(switched, by_clock), end = at_stop(std::min(next, end_));
      const PartRun run = [&, first, last = cut == cuts.end() ? Piece::unbounded : cut->before](
                              double t0, const std::vector<double>& y0, const Request& request) {
        return segment_(first, last, t0, y0, request);
      };
      if (t_ < end) fixed_ ? advance_fixed(run, end) : advance(run, end);
      if (!go_on_) break;
      if (t_ < end) continue;  // for an event, after which another may come sooner
      if (next > end_ && !same_time(next, end_)) break;
      if (same_time(switched, next)) first = cut++->after;
      if (!same_time(by_clock, next)) continue;
      happen({});
      finder_.begin({}, *course_, {});
    }
    return std::move(all_);
  }

 private:
  /// To a tolerance, up to the next event or `end`.
  void advance(const PartRun& run, double end) {
    // After an event the next may be near, and what lies far behind it is computed in vain.
    double ahead = end;
    if (last_gap_ > 0) ahead = std::min(end, t_ + std::max(4 * last_gap_, 1e-6 * (end_ - t_)));
    const std::vector<ZeroSearch> begun = finder_.searches();
    for (;; ahead = std::min(end, t_ + 8 * (ahead - t_))) {
      finder_.restore(begun);
      Request request = part_to(ahead, 0);
      request.record_steps = true;
      Outcome outcome = tried(run, y_, t_, request);
      if (const Found found = look_between(run, ahead, outcome))
        return arrive(found, [&] { take(tried(run, y_, t_, part_to(found.t, 0)), found.t); });
      if (!go_on_) return;
      if (outcome.status == Status::ok && ahead < end) continue;
      if (!request_.record_steps) outcome.step_ends.clear();
      return take(std::move(outcome), ahead);
    }
  }
  template <class Way>
  void arrive(const Found& found, Way&& way) {
    if (found.t > t_) way();
    if (!go_on_) return;
    std::vector<double> before;
    if (!events_.modal) before = y_;  // others have no residue at the zeros of those before
    happen_at(finder_.crossings(found));
    finder_.begin(found, *course_, before);
  }

  /// Looks into the steps of a run, whose states are asked of another one.
  Found look_between(const PartRun& run, double ahead, const Outcome& outcome) {
    if (events_.senses.empty() && !events_.steps) return {};
    const std::vector<double> ends = ends_of(outcome, ahead);
    Request request = request_;
    request.record_steps = false;
    request.over_stops = true;
    request.stops.clear();
    for (std::size_t k = 1; k < ends.size(); ++k)
      for (std::size_t node = 1; node <= detail::zero_degree; ++node)
        if (const double t = node_of(ends, k, node);
            t > (request.stops.empty() ? t_ : request.stops.back()))
          request.stops.push_back(t);
    if (request.stops.empty()) return {};
    limit_within(request, outcome);
    const Outcome within = tried(run, y_, t_, request);
    const std::size_t n = y_.size(), reached = within.states.size() / n;
    const auto state_at = [&](double t) -> const double* {
      if (t <= t_) return y_.data();
      const auto place = static_cast<std::size_t>(std::ranges::lower_bound(request.stops, t) -
                                                  request.stops.begin());
      return place < reached ? within.states.data() + place * n : nullptr;
    };
    std::vector<const double*> states(detail::zero_degree + 1);
    for (std::size_t k = 1; k < ends.size(); ++k) {
      for (std::size_t node = 0; node < states.size(); ++node)
        states[node] = state_at(node_of(ends, k, node));
      if (std::ranges::find(states, nullptr) != states.end()) {
        if (outcome.status == Status::ok) fail_unseen(within);
        return {};
      }
      const StepPolynomial polynomial(ends[k - 1], ends[k], states, n);
      if (const Found found = look(ends[k - 1], ends[k], polynomial, states.back())) return found;
    }
    return {};
  }
  static double node_of(const std::vector<double>& ends, std::size_t k, std::size_t node) {
    if (node == detail::zero_degree) return ends[k];
    return ends[k - 1] + detail::zero_nodes[node] * (ends[k] - ends[k - 1]);
  }
  /// The ends of the steps that were made, of neighbours together where there are very many. A
  /// library that does not tell them has as many equal parts.
  std::vector<double> ends_of(const Outcome& outcome, double ahead) const {
    const std::size_t most = std::max<std::size_t>(16, 2'000'000 / y_.size());
    std::vector<double> ends{t_}, made = outcome.step_ends;
    const double reached = outcome.status == Status::ok ? ahead : outcome.t;
    const auto count = static_cast<std::size_t>(outcome.counters.steps);
    if (made.empty() && reached > t_)
      for (std::size_t k = 1, parts = std::clamp<std::size_t>(count, 1, most); k <= parts; ++k)
        made.push_back(k == parts ? reached
                                  : t_ + (reached - t_) * static_cast<double>(k) /
                                             static_cast<double>(parts));
    const std::size_t together = 1 + made.size() / most;
    for (std::size_t k = 0; k < made.size(); ++k)
      if (made[k] > ends.back() && (k % together == 0 || k + 1 == made.size()))
        ends.push_back(made[k]);
    return ends;
  }

  /// In equal steps, up to the next event or `end`; in one shorter step where t_ or `end` is not on
  /// the grid.
  void advance_fixed(const PartRun& run, double end) {
    const double h = grid_.h(), off = 1e-9 * h;
    const auto index = [&](double t) { return (t - contest_.t0) / h; };
    const auto i = static_cast<std::uint64_t>(std::max(0.0, std::ceil(index(t_ - off))));
    const bool on_grid = std::abs(grid_.t(i) - t_) <= off;
    const auto last = static_cast<std::uint64_t>(std::max(0.0, std::floor(index(end + off))));
    if (!on_grid || last <= i)
      return step_fixed(run, at_stop(std::min(end, grid_.t(on_grid ? i + 1 : i))));
    const std::vector<ZeroSearch> begun = finder_.searches();
    for (std::uint64_t count = 16;; count *= 4) {
      count = std::min(count, last - i);
      finder_.restore(begun);
      const auto time = [&](std::uint64_t k) { return k == 0 ? t_ : at_stop(grid_.t(i + k)); };
      Request all = part_to(time(count), count);
      all.stops.clear();
      for (std::uint64_t k = 1; k <= count; ++k) all.stops.push_back(time(k));
      const Outcome outcome = tried(run, y_, t_, all);
      const std::size_t n = y_.size(), reached = outcome.states.size() / n;
      std::vector<double> y = y_;
      for (std::uint64_t k = 0; k < reached; ++k) {
        const auto at = outcome.states.begin() + static_cast<std::ptrdiff_t>(k * n);
        const std::vector<double> next(at, at + static_cast<std::ptrdiff_t>(n));
        const double from = time(k);
        if (const Found found = look_in_step(run, from, y, time(k + 1), next))
          return arrive(found, [&] {
            if (k > 0) take(tried(run, y_, t_, part_to(from, k)), from);
            if (go_on_ && found.t > t_) take(tried(run, y_, t_, part_to(found.t, 1)), found.t);
          });
        y = next;
      }
      if (outcome.status == Status::ok && count < last - i) continue;
      return take(tried(run, y_, t_, part_to(time(count), count)), time(count));
    }
  }
  void step_fixed(const PartRun& run, double end) {
    Outcome outcome = tried(run, y_, t_, part_to(end, 1));
    if (outcome.status == Status::ok)
      if (const Found found = look_in_step(run, t_, y_, end, outcome.states))
        return arrive(found, [&] { take(tried(run, y_, t_, part_to(found.t, 1)), found.t); });
    take(std::move(outcome), end);
  }
  /// Looks into a step, then at its end, where the state is y.
  template <class StateAt>
  Found look(double a, double b, const StateAt& state, const double* y) {
    if (const Found found = finder_.look(a, b, state)) return on_stop(found);
    if (!completes(b, y)) return {};
    return {.t = at_stop(b), .functions = {}, .of_step = true};
  }
  /// Looks into a step on Hermite's cubic, and where that has an event on states that are those of
  /// one step to each time.
  Found look_in_step(const PartRun& run, double a, const std::vector<double>& before, double b,
                     const std::vector<double>& after) {
    if (events_.senses.empty() && !events_.steps) return {};
    std::vector<double> f0(y_.size()), f1(f0), inner(f0);
    contest_.view.rhs(contest_.view.problem, a, before.data(), f0.data());
    contest_.view.rhs(contest_.view.problem, b, after.data(), f1.data());
    const std::vector<ZeroSearch> begun = finder_.searches();
    const auto by_cubic = [&](double t, double* y) {
      cubic_hermite((t - a) / (b - a), b - a, before, f0, after, f1, inner);
      std::ranges::copy(inner, y);
      return true;
    };
    const Found seen = look(a, b, by_cubic, after.data());
    if (!seen || seen.of_step) return seen;
    finder_.restore(begun);
    const auto by_one_step = [&](double t, double* y) {
      if (t == a || t == b) return std::ranges::copy(t == a ? before : after, y), true;
      Request one = part_to(t, 1);
      one.stops = {t};
      const Outcome outcome = tried(run, before, a, one);
      if (outcome.status == Status::ok) std::ranges::copy(outcome.states, y);
      return outcome.status == Status::ok;
    };
    return look(a, b, by_one_step, after.data());
  }
  /// An event on a stop is at the stop, whatever rounding says, which then has the state after it.
  Found on_stop(Found found) const {
    if (found) found.t = at_stop(found.t);
    return found;
  }

  const SegmentRun& segment_;
  bool fixed_;
  FixedGrid grid_;
  EventFinder finder_;
};

}  // namespace

double without_end_since(const std::vector<double>& times, double span) {
  constexpr std::size_t many = 32;
  constexpr double little = 1e-9;
  if (times.size() <= many) return std::numeric_limits<double>::quiet_NaN();
  const double since = times[times.size() - 1 - many];
  return times.back() - since > little * span ? std::numeric_limits<double>::quiet_NaN() : since;
}

double between_events(double t, const std::vector<double>& times, double begin, double end) {
  const auto after = std::ranges::upper_bound(times, t);
  const double low = after == times.begin() ? begin : *std::prev(after),
               high = after == times.end() ? end : *after, quarter = (high - low) / 4;
  const bool near =
      (after != times.begin() && t < low + quarter) || (after != times.end() && t > high - quarter);
  return near ? low + 2 * quarter : t;
}

Outcome run_with_events(const ErasedContest& contest, const Request& request,
                        const SegmentRun& segment) {
  return EventRun(contest, request, segment)();
}

}  // namespace odeum
