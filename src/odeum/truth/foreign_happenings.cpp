// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/foreign_happenings.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "odeum/solvers/own_methods.hpp"
#include "odeum/solvers/pieces.hpp"
#include "odeum/truth/foreign_reference.hpp"

namespace odeum::truth {
namespace {

using Rhs = std::function<void(Real t, const Real* y, Real* f)>;
using Holds = std::function<Real(Real t, const Real* y)>;
/// The functions of the events.
using Values = std::function<State(Real t, const State& y)>;

std::vector<double> in_double(const Real* y, std::size_t n) { return {y, y + n}; }

/// Events in double on states of extended precision: what they leave alone keeps its digits.
class WidenedCourse final : public EventCourseOf<Real> {
 public:
  /// `moved`: the part of itself by which the state after an event is moved.
  WidenedCourse(std::unique_ptr<EventCourse> inner, Rhs rhs, Values values, Real moved)
      : inner_(std::move(inner)), rhs_(std::move(rhs)), values_(std::move(values)), moved_(moved) {}

  std::string happen(Real t, const std::vector<Crossing>& crossings, State& y,
                     const Ahead& /*ahead*/) override {
    const std::vector<double> before = in_double(y.data(), y.size());
    const State exactly = y;
    std::vector<double> after = before;
    std::string fault = inner_->happen(static_cast<double>(t), crossings, after, {});
    for (std::size_t i = 0; i < y.size(); ++i)
      if (after[i] != before[i]) y[i] = after[i];
    done_.clear();
    if (inner_->done().empty()) return fault;
    if (moved_ > 0) move(t, y);
    for (const auto& done : inner_->done()) done_.push_back({done.event, exactly, y});
    return fault;
  }
  const std::vector<Done>& done() const override { return done_; }
  bool has_stopped() const override { return inner_->has_stopped(); }
  Real next() const override { return inner_->next(); }
  int side(std::size_t function) const override { return inner_->side(function); }

 private:
  /// As rounding of the state and of the event's time would, as far as no function changes its
  /// sign.
  void move(Real t, State& y) {
    State slope(y.size());
    rhs_(t, y.data(), slope.data());
    for (const Real share : {1, 0}) {
      State there = y;
      for (std::size_t i = 0; i < y.size(); ++i)
        there[i] += moved_ * (share * std::abs(y[i]) + std::abs(t) * slope[i]);
      const State values = values_(t, there);
      bool same = true;
      for (std::size_t k = 0; k < values.size(); ++k)
        same = same && (side(k) == 0 || (values[k] > 0) == (side(k) > 0));
      if (!same) continue;
      y = there;
      return;
    }
  }

  std::unique_ptr<EventCourse> inner_;
  Rhs rhs_;
  Values values_;
  Real moved_;
  std::vector<Done> done_;
};

/// Notes the first time at which a course asks for an event at the end of a step.
class NotingCourse final : public EventCourse {
 public:
  NotingCourse(std::unique_ptr<EventCourse> inner, double& first)
      : inner_(std::move(inner)), first_(first) {}

  std::string happen(double t, const std::vector<Crossing>& crossings, State& y,
                     const Ahead& ahead) override {
    return inner_->happen(t, crossings, y, ahead);
  }
  const std::vector<Done>& done() const override { return inner_->done(); }
  bool has_stopped() const override { return inner_->has_stopped(); }
  double next() const override { return inner_->next(); }
  int side(std::size_t function) const override { return inner_->side(function); }
  bool completes(double t, const double* y) override {
    const bool asks = inner_->completes(t, y);
    if (asks) first_ = std::min(first_, t);
    return asks;
  }

 private:
  std::unique_ptr<EventCourse> inner_;
  double& first_;
};

/// Looks into steps at as many places of the cubic through both ends as they have spacings, for
/// what `holds` says and for what the inner insight sees.
class HybridInsight final : public Insight {
 public:
  HybridInsight(Rhs rhs, Holds holds, std::unique_ptr<Insight> inner, Real spacing)
      : rhs_(std::move(rhs)),
        holds_(std::move(holds)),
        inner_(std::move(inner)),
        spacing_(spacing) {}

  Inside look(Real t, Real h, const State& y, const State& next) override {
    constexpr std::size_t fewest = 16;
    const std::size_t count = std::max(fewest, static_cast<std::size_t>(std::ceil(h / spacing_)));
    const std::size_t n = y.size();
    f_.resize(n), g_.resize(n), at_.resize(n), tube_.resize(n);
    rhs_(t, y.data(), f_.data());
    rhs_(t + h, next.data(), g_.data());
    // The cubic's error is the next term, some fraction of the term before.
    for (std::size_t i = 0; i < n; ++i)
      tube_[i] = 0.1L * std::abs(h * (f_[i] + g_[i]) / 2 - (next[i] - y[i]));
    const auto part = [&](std::size_t k) {
      return static_cast<Real>(k) / static_cast<Real>(count);
    };
    Real lowest = std::numeric_limits<Real>::infinity();
    std::size_t lowest_at = 0;
    for (std::size_t k = 1; k <= count; ++k) {
      const Real held = held_at(t, h, part(k), y, next, 0);
      if (!(held > 0)) return {Inside::Kind::change, part(k - 1), part(k)};
      if (k < count && held < lowest) lowest = held, lowest_at = k;
    }
    for (const Real side : {-1.0L, 1.0L})
      if (!(held_at(t, h, part(lowest_at), y, next, side) > 0))
        return {Inside::Kind::hidden, part(lowest_at - 1), part(lowest_at + 1)};
    return inner_ ? inner_->look(t, h, y, next) : Inside{};
  }

 private:
  /// On the cubic, or at one side of the tube around it.
  Real held_at(Real t, Real h, Real s, const State& y, const State& next, Real side) {
    const Real risen = s * s * (3 - 2 * s), from = s * (1 - s) * (1 - s), to = s * s * (s - 1);
    const Real wide = side * 16 * s * s * (1 - s) * (1 - s);
    for (std::size_t i = 0; i < y.size(); ++i)
      at_[i] = s == 1 ? next[i]
                      : y[i] + risen * (next[i] - y[i]) + h * (from * f_[i] + to * g_[i]) +
                            wide * tube_[i];
    return holds_(t + s * h, at_.data());
  }

  Rhs rhs_;
  Holds holds_;
  std::unique_ptr<Insight> inner_;
  Real spacing_;
  State f_, g_, at_, tube_;
};

/// Positive while each value keeps its side: that of positive values, or that of all others; one
/// that rests at zero has none.
Real held(const State& values, const std::vector<int>& sides) {
  Real least = 1;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const Real v = values[k];
    least = std::min(least, sides[k] > 0    ? v
                            : sides[k] == 0 ? (v == 0 ? 1 : -std::abs(v))
                            : v == 0        ? 1
                                            : -v);
  }
  return least;
}

std::vector<int> sides_at(const System& base, const Values& values_at, Real t, const State& y,
                          Real span) {
  const State values = values_at(t, y);
  State slope(y.size()), later = y;
  base.rhs(t, y.data(), slope.data());
  const Real way = 1e-9L * span;
  for (std::size_t i = 0; i < y.size(); ++i) later[i] += way * slope[i];
  const State next = values_at(t + way, later);
  std::vector<int> sides;
  for (std::size_t k = 0; k < values.size(); ++k)
    sides.push_back(values[k] > 0 ? 1 : values[k] < 0 || next[k] != 0 ? -1 : 0);
  return sides;
}

}  // namespace

void add_happenings(const foreign::ProblemCallbacks& given, System& system) {
  for (const Switch& at : given.switches)
    if (at.t > system.t0) system.switches.push_back(at.t);
  if (!given.events && system.switches.empty()) return;
  const auto base = std::make_shared<const System>(system);
  const std::size_t functions = given.events ? given.events->senses.size() : 0;
  const Values values_at = [events = given.events, functions](Real t, const State& y) {
    std::vector<double> values(functions);
    if (functions > 0)
      events->functions(static_cast<double>(t), in_double(y.data(), y.size()).data(),
                        values.data());
    return State(values.begin(), values.end());
  };
  system.smooth = false;
  system.moved_y0 = system.y0;
  if (given.events) {
    auto all = std::make_shared<Happenings>();
    all->senses.assign(functions, 0);
    all->in_double = true;
    all->values = [values_at, n = system.states](Real t, const Real* y, Real* values, bool) {
      std::ranges::copy(values_at(t, State(y, y + n)), values);
    };
    all->course = [events = given.events, rhs = system.rhs, values_at](bool is_moved) {
      return std::make_unique<WidenedCourse>(events->course(false), rhs, values_at,
                                             is_moved ? moved_by : 0);
    };
    system.events = std::move(all);
  }
  system.mode_at = [base, values_at, functions](Real t, const State& y, Real span, bool) {
    auto mode = std::make_shared<System>(*base);
    if (functions == 0) return mode;
    mode->sides = sides_at(*base, values_at, t, y, span);
    mode->holds = [values_at, sides = mode->sides, states = mode->states](Real at,
                                                                          const Real* there) {
      const State state(there, there + states);
      return held(values_at(at, state), sides);
    };
    mode->insight = [base, holds = mode->holds](Real whole) {
      return std::make_unique<HybridInsight>(base->rhs, holds, base->insight(whole),
                                             shortest_seen * whole);
    };
    return mode;
  };
}

double first_event_of_step(const foreign::ProblemCallbacks& given, const OdeView& view) {
  constexpr double tolerance = 1e-6;
  constexpr std::uint64_t most = 1'000'000;
  double first = std::numeric_limits<double>::infinity();
  if (!given.events || !given.events->steps) return first;
  const odeum_problem& p = given.functions;
  auto events = std::make_shared<Events>(*given.events);
  events->course = [inner = given.events, &first](bool resumed) {
    return std::make_unique<NotingCourse>(inner->course(resumed), first);
  };
  ErasedContest contest;
  contest.view = view;
  contest.t0 = p.t0;
  contest.y0 = std::make_shared<const std::vector<double>>(p.y0, p.y0 + p.dimension);
  contest.events = std::move(events);
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = tolerance;
  request.stops.assign(p.stops, p.stops + p.stop_count);
  request.budget.evaluations = most;
  enrolled(own_solver("dormand_prince54"), contest).solve(request);
  return first;
}

}  // namespace odeum::truth
