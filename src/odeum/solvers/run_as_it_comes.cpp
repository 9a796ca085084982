// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstdint>
#include <utility>

#include "odeum/solvers/event_progress.hpp"
#include "odeum/solvers/event_run.hpp"

namespace odeum {
namespace {

class RunAsItComes : EventProgress {
 public:
  RunAsItComes(const ErasedContest& contest, const Request& request, const PartRun& run)
      : EventProgress(contest, request), run_(run), grid_(contest.t0, request) {}

  Outcome operator()() {
    if (const std::string why = refusal(grid_); !why.empty()) return refused(why);
    happen({});
    begin();
    while (go_on_ && t_ < end_) {
      const std::vector<EventCourse::Crossing> crossings =
          request_.mode == Mode::fixed ? advance_fixed() : advance();
      if (!go_on_ || !happens(t_, crossings)) continue;
      happen_at(crossings);
      begin();
    }
    return std::move(all_);
  }

 private:
  using Crossings = std::vector<EventCourse::Crossing>;

  /// The signs after what happened, those of conditions as these have them.
  void begin() {
    signs_ = signs_at(t_, y_.data());
    for (std::size_t k = events_.of_events; k < signs_.size(); ++k)
      if (const int side = course_->side(k); side != 0) signs_[k] = side;
  }
  bool is_due(double t) const { return course_->next() <= t || same_time(course_->next(), t); }
  bool happens(double t, const Crossings& crossings) const {
    return asked_ || !crossings.empty() || is_due(t);
  }
  /// What changed its sign up to the end of a step.
  Crossings crossings_at(double t, const double* y) {
    Crossings all;
    asked_ = completes(t, y);
    const std::vector<int> now = signs_at(t, y);
    for (std::size_t k = 0; k < now.size(); ++k) {
      const int before = signs_[k];
      if (now[k] == 0) continue;
      signs_[k] = now[k];
      const bool counts =
          k >= events_.of_events || events_.senses[k] == 0 || events_.senses[k] == now[k];
      if (before != 0 && before != now[k] && counts) all.push_back({k, now[k]});
    }
    return all;
  }

  /// In steps of the grid, up to the end of the first at which something happens.
  Crossings advance_fixed() {
    const std::uint64_t left = grid_.steps() - made_;
    const std::vector<int> signs = signs_;
    const auto go_to = [&](std::uint64_t count) {
      take(tried(run_, y_, t_, part_to(time(count), count)), time(count));
      made_ += count;
    };
    for (std::uint64_t count = 16;; count *= 4) {
      count = std::min(count, left);
      signs_ = signs;
      Request all = part_to(time(count), count);
      all.stops.clear();
      for (std::uint64_t k = 1; k <= count; ++k) all.stops.push_back(time(k));
      const Outcome outcome = tried(run_, y_, t_, all);
      const std::size_t n = y_.size(), reached = outcome.states.size() / n;
      for (std::uint64_t k = 1; k <= reached; ++k) {
        Crossings found = crossings_at(time(k), outcome.states.data() + (k - 1) * n);
        if (!happens(time(k), found)) continue;
        go_to(k);
        return found;
      }
      if (outcome.status == Status::ok && count < left) continue;
      go_to(count);
      return {};
    }
  }
  double time(std::uint64_t k) const { return k == 0 ? t_ : at_stop(grid_.t(made_ + k)); }

  /// To a tolerance, up to the end of the first step at which something happens.
  Crossings advance() {
    // The step that a run ends with is shorter than its own: the last of those looked at is not.
    double ahead = last_gap_ > 0 ? std::min(end_, t_ + 4 * last_gap_) : end_;
    const std::vector<int> signs = signs_;
    for (;; ahead = std::min(end_, t_ + 8 * (ahead - t_))) {
      signs_ = signs;
      Request request = part_to(ahead, 0);
      request.record_steps = true;
      Outcome outcome = tried(run_, y_, t_, request);
      request.record_steps = false;
      request.over_stops = true;
      request.stops = outcome.step_ends;
      if (ahead < end_ && !request.stops.empty()) request.stops.pop_back();
      if (!request.stops.empty()) {
        limit_within(request, outcome);
        const Outcome within = tried(run_, y_, t_, request);
        const std::size_t n = y_.size(), reached = within.states.size() / n;
        for (std::size_t k = 0; k < reached; ++k) {
          const double t = at_stop(request.stops[k]);
          Crossings found = crossings_at(t, within.states.data() + k * n);
          if (!happens(t, found)) continue;
          take(tried(run_, y_, t_, part_to(t, 0)), t);
          return found;
        }
        if (outcome.status == Status::ok && reached < request.stops.size()) {
          fail_unseen(within);
          return {};
        }
      }
      if (outcome.status == Status::ok && outcome.step_ends.empty()) {
        fail(Status::refused, "its library does not say where steps end");
        return {};
      }
      if (outcome.status == Status::ok && ahead < end_) continue;
      if (!request_.record_steps) outcome.step_ends.clear();
      take(std::move(outcome), end_);
      return {};
    }
  }

  const PartRun& run_;
  FixedGrid grid_;
  std::uint64_t made_ = 0;  ///< steps of the grid
  std::vector<int> signs_;
  bool asked_ = false;  ///< for an event, at the end of the step looked at last
};

}  // namespace

Outcome run_as_it_comes(const ErasedContest& contest, const Request& request, const PartRun& run) {
  return RunAsItComes(contest, request, run)();
}

}  // namespace odeum
