// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace odeum::scene {
namespace {

/// Times of a run: whole steps where the step is fixed, so that every solve has a whole number.
class Clock {
 public:
  explicit Clock(const RunSetting& setting)
      : setting_(setting), fixed_(setting.mode == Mode::fixed) {}

  double step() const { return setting_.until / static_cast<double>(setting_.steps); }
  /// Fixed step: the index of the step after which an event at t takes effect; else unused.
  std::uint64_t index(double t) const {
    const double exact = t / step();
    const double near = std::round(exact);
    return static_cast<std::uint64_t>(
        std::abs(exact - near) < 1e-9 * (1 + near) ? near : std::ceil(exact));
  }
  double moment(double t) const { return fixed_ ? time_of(index(t)) : t; }
  double frame_moment(double t) const {
    return fixed_ ? time_of(static_cast<std::uint64_t>(std::llround(t / step()))) : t;
  }
  double time_of(std::uint64_t i) const {
    return i >= setting_.steps ? setting_.until : static_cast<double>(i) * step();
  }

  /// The request for a solve from `begin` on, with times relative to it.
  Request request(double begin, const std::vector<double>& stops, double seconds_left) const {
    Request request;
    request.mode = setting_.mode;
    request.tolerance = setting_.tolerance;
    request.over_stops = true;  // frames do not limit the steps
    request.budget = setting_.budget;
    request.budget.seconds = seconds_left;
    for (const double stop : stops) request.stops.push_back(stop - begin);
    if (fixed_) {
      const std::uint64_t first = index(begin);
      request.steps = index(stops.back()) - first;
      for (std::size_t k = 0; k < stops.size() && first > 0; ++k)
        request.stops[k] = static_cast<double>(index(stops[k]) - first) * step();
    }
    return request;
  }

 private:
  const RunSetting& setting_;
  bool fixed_;
};

class Run {
 public:
  Run(const Scene& scene, const RunSetting& setting, const Solve& solve)
      : now_(scene), setting_(setting), solve_(solve), clock_(setting) {
    now_.emitters.clear();
    for (std::size_t i = 0; i < now_.particles.size(); ++i) ids_.push_back(i);
    next_id_ = ids_.size();
    for (const EmittedParticle& one : emitted_particles(scene.emitters, setting.until)) {
      births_[clock_.moment(one.birth)].push_back(one);
      if (const double death = clock_.moment(std::min(one.death, 2 * setting.until));
          death < setting.until)
        births_.try_emplace(death);  // the run is split there
    }
    for (std::uint64_t k = 1;; ++k) {
      const double due = static_cast<double>(k) * setting.frame_interval;
      if (!(due < setting.until * (1 - 1e-9))) break;
      const double t = clock_.frame_moment(due);
      if (t > 0 && t < setting.until && (frames_due_.empty() || t > frames_due_.back()))
        frames_due_.push_back(t);
    }
    frames_due_.push_back(setting.until);
    if (!scene.surfaces.empty()) surfaces_.emplace(scene);
  }

  RunResult operator()() {
    double t = 0;
    if (births_.contains(0)) change_population(0);
    problem_ = std::make_shared<const SceneProblem>(now_);
    keep_frame(0, problem_->start().data());
    while (t < setting_.until && result_.status == Status::ok) {
      const auto next = births_.upper_bound(t);
      const double end =
          next == births_.end() ? setting_.until : std::min(next->first, setting_.until);
      advance(t, end);
      t = end;
      if (t < setting_.until && result_.status == Status::ok) {
        change_population(t);
        problem_ = std::make_shared<const SceneProblem>(now_);
      }
    }
    return std::move(result_);
  }

 private:
  void keep_frame(double t, const double* y) {
    Frame frame{.t = t, .ids = ids_, .y = {y, y + problem_->size()}};
    frame.kinetic = problem_->kinetic(y);
    frame.potential = problem_->potential(y);
    frame.momentum = problem_->momentum(y);
    frame.angular_momentum = problem_->angular_momentum(y);
    result_.frames.push_back(std::move(frame));
    result_.t = t;
  }

  /// The ends of steps, or of so many that the states are not too many to keep; where a tolerance
  /// is asked, times that are closer than frames.
  std::vector<double> watched_times(double begin, double end) {
    constexpr double most_numbers = 3e7;
    constexpr std::uint64_t a_frame = 8;
    const auto most = static_cast<std::uint64_t>(
        most_numbers / static_cast<double>(problem_->size()) * (end - begin) / setting_.until);
    const bool fixed = setting_.mode == Mode::fixed;
    const std::uint64_t first = fixed ? clock_.index(begin) : 0;
    const std::uint64_t count =
        fixed ? clock_.index(end) - first
              : a_frame *
                    static_cast<std::uint64_t>(std::ceil((end - begin) / setting_.frame_interval));
    const std::uint64_t each = 1 + count / std::max<std::uint64_t>(most, 1);
    std::vector<double> times;
    for (std::uint64_t i = each; i < count; i += each)
      times.push_back(fixed ? clock_.time_of(first + i)
                            : begin + (end - begin) * static_cast<double>(i) /
                                          static_cast<double>(count));
    result_.contacts.apart =
        static_cast<double>(each) *
        (fixed ? clock_.step() : (end - begin) / static_cast<double>(std::max(count, each)));
    return times;
  }

  void watch(double t, const double* before, const double* y) {
    Contacts& contacts = result_.contacts;
    if (Touching touching = touching_at(*surfaces_, y); touching.deepest > contacts.deepest.deepest)
      contacts.deepest = touching, contacts.deepest_at = t;
    const auto passed = passed_between(*surfaces_, before, y);
    if (!passed.empty() && contacts.passed == 0)
      contacts.first_passed = t, contacts.first_pair = passed.front();
    contacts.passed += passed.size();
  }

  void advance(double begin, double end) {
    std::vector<double> frames;
    for (; next_frame_ < frames_due_.size() && frames_due_[next_frame_] <= end; ++next_frame_)
      frames.push_back(frames_due_[next_frame_]);
    const std::size_t n = problem_->size();
    if (n == 0) {  // no particles: advance time
      for (const double t : frames) keep_frame(t, nullptr);
      return;
    }
    std::vector<double> stops = surfaces_ ? watched_times(begin, end) : std::vector<double>{};
    stops.insert(stops.end(), frames.begin(), frames.end());
    stops.push_back(end);
    std::ranges::sort(stops);
    stops.erase(std::unique(stops.begin(), stops.end()), stops.end());
    const double spent =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
    const Outcome outcome =
        solve_(problem_, clock_.request(begin, stops, setting_.budget.seconds - spent));
    ++result_.solves;
    result_.counters += outcome.counters;
    const double* before = problem_->start().data();
    for (std::size_t k = 0; k < stops.size() && (k + 1) * n <= outcome.states.size(); ++k) {
      const double* const y = outcome.states.data() + k * n;
      if (std::ranges::binary_search(frames, stops[k])) keep_frame(stops[k], y);
      if (surfaces_) watch(stops[k], std::exchange(before, y), y);
    }
    if (outcome.status != Status::ok) {
      result_.status = outcome.status;
      result_.detail = outcome.detail;
      if (std::isfinite(outcome.t)) result_.t = begin + outcome.t;
      if (begin > 0) result_.detail += " (counted from t = " + std::to_string(begin) + ")";
      return;
    }
    result_.t = end;
    const double* const y = outcome.states.data() + (stops.size() - 1) * n;
    for (std::size_t i = 0; i < now_.particles.size(); ++i)
      for (std::size_t d = 0; d < 3; ++d) {
        now_.particles[i].position[d] = y[3 * i + d];
        now_.particles[i].velocity[d] = y[n / 2 + 3 * i + d];
      }
  }

  // Deaths before births. Particles listed in the scene stay: springs refer to them.
  void change_population(double t) {
    const std::size_t listed = now_.particles.size() - lives_until_.size();
    std::size_t kept = listed;
    for (std::size_t k = 0; k < lives_until_.size(); ++k) {
      if (lives_until_[k] <= t) {
        ++result_.deaths;
        continue;
      }
      now_.particles[kept] = now_.particles[listed + k];
      ids_[kept] = ids_[listed + k];
      lives_until_[kept - listed] = lives_until_[k];
      ++kept;
    }
    now_.particles.resize(kept);
    ids_.resize(kept);
    lives_until_.resize(kept - listed);
    for (const EmittedParticle& one : births_.at(t)) {
      now_.particles.push_back(one.particle);
      ids_.push_back(next_id_++);
      lives_until_.push_back(clock_.moment(std::min(one.death, 2 * setting_.until)));
      ++result_.births;
    }
  }

  Scene now_;  ///< with the particles that exist, in their present state
  const RunSetting& setting_;
  const Solve& solve_;
  Clock clock_;
  std::map<double, std::vector<EmittedParticle>> births_;  ///< and, empty, the times of deaths
  std::vector<double> frames_due_;
  std::size_t next_frame_ = 0, next_id_ = 0;
  std::vector<std::size_t> ids_;
  std::vector<double> lives_until_;  ///< of the emitted particles, which are last
  std::shared_ptr<const SceneProblem> problem_;
  std::optional<Surfaces> surfaces_;  ///< of the scene at its start; emitted particles are on none
  RunResult result_;
  std::chrono::steady_clock::time_point started_ = std::chrono::steady_clock::now();
};

}  // namespace

RunResult run_scene(const Scene& scene, const RunSetting& setting, const Solve& solve) {
  return Run(scene, setting, solve)();
}

double frame_interval(const Scene& scene, double until) {
  constexpr double most_numbers = 2e8;  // of 8 bytes each
  const double interval =
      scene.frame_interval.value_or(std::clamp(1.0 / 60, until / 1000, until / 100));
  const double frames = until / interval + 1;
  auto particles = static_cast<double>(scene.particles.size());
  for (const Emitter& emitter : scene.emitters) {
    if (!(emitter.rate * until < 1e6))
      throw std::length_error(fmt::format(
          "emitters: rate {} for {} s is more than a million particles", emitter.rate, until));
    particles += emitter.rate * std::min(emitter.lifetime, until) + 1;
  }
  if (!(frames * 6 * std::max(1.0, particles) < most_numbers))
    throw std::length_error(
        fmt::format("output.every: {} frames of {} particles are too many to keep; "
                    "expected at most {:g} numbers in all",
                    std::floor(frames), std::floor(particles), most_numbers));
  return interval;
}

}  // namespace odeum::scene
