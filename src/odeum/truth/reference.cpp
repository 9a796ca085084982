// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "odeum/core/parallel.hpp"
#include "odeum/truth/families.hpp"
#include "odeum/truth/floors.hpp"
#include "odeum/truth/sizes.hpp"

namespace odeum::truth {
namespace {

constexpr int checks = 80;          // times looked at besides those asked for
constexpr Real unknown = 1e-6L;     // of the scale: beyond that nothing is known
constexpr Real few_digits = 1e-3L;  // of the scale: a larger error leaves nothing to compare with
constexpr double work_of_few = 3.2e9, work_of_some = 8e9, work_of_many = 6e9;  // 5 to 20 s
constexpr Real share = 0.4L;     // of what is left, for each of two runs
constexpr Real brief = 1e-12L;   // the tolerance at which families are compared
constexpr std::size_t few = 64;  // states; with more, each comparison takes seconds

class Search {
 public:
  Search(const System& system, const std::vector<double>& asked, const ErrorUnits& units,
         const TruthBounds& bounds)
      : system_(from_zero(system)), t0_(system.t0), units_(units), bounds_(bounds) {
    const Real span = asked.back() - t0_, beside = 1e-6L * span;
    const std::set<Real> stops(asked.begin(), asked.end());
    std::set<Real> all = stops;
    for (int k = 0; k + 1 < checks; ++k) {
      // Events fall on tenths. One beside a time asked for costs steps, and is the same in double.
      const Real t = t0_ + span * (k + (system.events ? 0.618L : 1)) / checks;
      const auto next = stops.lower_bound(t - beside);
      if (next == stops.end() || *next > t + beside) all.insert(t);
    }
    times_.assign(all.begin(), all.end());
    for (const Real t : times_) elapsed_.push_back(t - t0_);
    left_ = system_.states > few ? work_of_many : system_.states > 10 ? work_of_some : work_of_few;
    if (system_.states > few && system_.rounding > 0x1p-60L) left_ *= 5;  // compiled, in double
    found_ = static_cast<bool>(system_.mode_at);  // each part's steps are looked into
    for (Real& t : system_.switches)
      for (const Real at : elapsed_) t = std::abs(t - at) <= 0x1p-58L * at ? at : t;  // the same
  }

  Reference find() {
    choose();
    return reference(finest());
  }

 private:
  /// Begins with a tolerance in the middle, or a looser one where that is foreseen to be too dear,
  /// so that something is known soon, and goes to finer ones while they are affordable.
  Comparison finest() {
    const bool in_double = system_.rounding > 0x1p-60L, many = system_.states > few;
    std::vector<Real> ladder;
    if (in_double)
      ladder = {1e-7L, 1e-9L, 1e-11L, 1e-13L, 1e-15L};
    else
      ladder = {1e-8L, 1e-11L, 1e-14L, many ? 1e-16L : 2e-18L, many ? 2e-18L : 4e-19L};
    std::size_t at = in_double && many ? 1 : 2;
    while (at > 0 && foreseen(0, brief_work_, brief, ladder[at]) > share * left_) --at;
    // The second may be far dearer: a series steps over stiffness along a smooth solution.
    most_work_[1] = std::max(1e8, 30 * brief_work_);
    Comparison best = compare(ladder[at]);
    if (best.spent && family_.first != radau_run && system_.has_jacobian() &&
        !is_past(bounds_.until)) {
      const Family before = std::exchange(family_, implicit_family);
      second_tolerance_ = -1;
      Comparison other = compare(ladder[at]);
      if (is_better(other, best)) {
        best = std::move(other);
      } else {
        family_ = before;
        second_tolerance_ = -1;
      }
    }
    most_work_[1] = 1e300;
    if (best.spent && at > 0 && left_ > 0 && !is_past(bounds_.until)) {
      Comparison other = compare(ladder[0]);
      if (is_better(other, best)) best = std::move(other);
    }
    for (std::size_t k = at + 1; k < ladder.size() && !best.spent; ++k) {
      if (is_past(bounds_.until) || is_enough(best) ||
          !is_affordable(best, ladder[k - 1], ladder[k]))
        break;
      // The power of the tolerance gives three at most; steps that rounding makes short take more.
      if (many) most_work_ = {4 * best.a.work, 4 * best.b.work};
      Comparison other = compare(ladder[k]);
      const bool whole = best.known == times_.size(), better = is_better(other, best);
      const bool spent = other.spent;
      if (better) best = std::move(other);
      if (spent || (whole && !better)) break;
    }
    return best;
  }

  /// Below the rounding of double, which that of solvers of many states adds up to hundreds of
  /// times, or as exact as was asked for.
  bool is_enough(const Comparison& c) const {
    if (c.known < times_.size()) return false;
    const Real size = size_of(c);
    return c.worst <= (system_.states > few ? 1e-13L : 0x1p-60L) * size ||
           safety_of(system_) * c.worst <= bounds_.error;
  }

  /// Operations of a method to a tolerance, from those to another one.
  Real foreseen(std::size_t method, Real work, Real from, Real to) const {
    const Real finest = method == 0 ? 0 : family_.finest;
    return work *
           std::pow(std::max(from, finest) / std::max(to, finest), 1 / family_.orders[method]);
  }
  bool is_affordable(const Comparison& c, Real from, Real to) const {
    const Real work = foreseen(0, c.a.work, from, to) + foreseen(1, c.b.work, from, to);
    constexpr Real dear = 1e8L;  // for digits close to the rounding of double
    return work <= left_ && (work <= dear || c.worst > 1e-14L * size_of(c));
  }
  static bool is_better(const Comparison& a, const Comparison& b) {
    return a.known > b.known || (a.known == b.known && a.worst < b.worst);
  }
  Real size_of(const State& y) const { return largest_of(y, y, units_); }
  Real size_of(const Comparison& c) const {
    Real size = size_of(system_.y0);
    for (std::size_t k = 0; k < c.known; ++k) size = std::max(size, size_of(c.a.states[k]));
    return size;
  }

  /// On constants that rounding could have moved.
  Run run_moved() const {
    const Effort effort{.tolerance = 1e-13L,
                        .budget = left_ / 4,
                        .inspect = found_,
                        .disturb = !system_.mode_at || rounds_at_events(),
                        .until = bounds_.until};
    if (system_.mode_at) return run_across(family_.for_moved, system_, elapsed_, effort, true);
    System moved = system_;
    moved.rhs = system_.moved_rhs;
    moved.y0 = system_.moved_y0;
    return family_.for_moved(moved, elapsed_, effort);
  }
  Run run(Method method, const Effort& effort) const {
    return run_across(method, system_, elapsed_, effort, false);
  }

  Comparison compare(Real tolerance) {
    Comparison c;
    const Moment start = std::chrono::steady_clock::now();
    Effort effort{.tolerance = tolerance,
                  .budget = static_cast<double>(share * left_),
                  .inspect = found_ || tolerance > inspected_,
                  .until = bounds_.until};
    // Where `first` has missed nothing, and `second` agrees, that has missed nothing either.
    Effort of_second = effort;
    of_second.tolerance = std::max(tolerance, family_.finest);
    of_second.inspect = found_;
    of_second.budget = std::min(effort.budget, most_work_[1]);
    effort.budget = std::min(effort.budget, most_work_[0]);
    const bool again = of_second.tolerance != second_tolerance_;
    // Both at once, and with the first comparison the run on moved constants.
    const bool with_moved = (system_.moved_rhs || system_.mode_at) && !moved_;
    Run moved;
    parallel_for(3, system_.concurrent ? 3 : 1, [&](std::size_t run) {
      if (run == 0) c.a = this->run(family_.first, effort);
      if (run == 1 && again) second_ = this->run(family_.second, of_second);
      if (run == 2 && with_moved) moved = run_moved();
    });
    left_ -= c.a.work + (again ? second_.work : 0) + moved.work;
    if (with_moved) moved_ = std::move(moved);
    inspected_ = std::max(inspected_, tolerance);
    if (c.a.split && !found_) {
      found_ = of_second.inspect = true;
      second_ = this->run(family_.second, of_second);
      left_ -= second_.work;
      if (moved_ && !system_.mode_at) moved_ = run_moved();
    }
    second_tolerance_ = of_second.tolerance;
    c.b = second_;
    c.spent = c.a.work > effort.budget || c.b.work > of_second.budget || is_past(bounds_.until);
    c.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::size_t both = std::min(c.a.states.size(), c.b.states.size());
    Real size = size_of(system_.y0);
    while (c.known < both) {
      const State& y = c.a.states[c.known];
      State apart = difference_of(y, c.b.states[c.known]);
      const Real d = largest_of(apart, y, units_);
      size = std::max(size, size_of(y));
      if (!(d <= unknown * size)) break;
      c.worst = std::max(c.worst, d);
      c.apart.push_back(std::move(apart));
      ++c.known;
    }
    return c;
  }

  /// Explicit methods, unless they would take too long.
  void choose() {
    const auto mode =
        system_.mode_at ? system_.mode_at(0, system_.y0, elapsed_.back(), false) : nullptr;
    const bool series = system_.taylor || (mode && mode->taylor);
    family_ = series ? by_series : plain;
    const double affordable = std::min(left_ / 10, 2e8);
    constexpr double cheap = 1e7;  // no other family is tried for less
    Real farthest = 0;
    double work = affordable;
    // A problem that is too stiff for the series may be cheap enough for shorter steps, and one
    // that has none (a root at zero) may go on without.
    for (const Family& family : {by_series, plain, implicit_family}) {
      if ((family.first == taylor_run && !series) ||
          (family.first == radau_run && !system_.has_jacobian()))
        continue;
      const Run run =
          this->run(family.first, {.tolerance = brief, .budget = work, .until = bounds_.until});
      left_ -= run.work;
      const bool arrived = run.end.empty();
      if (run.reached < farthest || (run.reached == farthest && !arrived)) continue;
      farthest = run.reached;
      family_ = family;
      brief_work_ = run.work * static_cast<double>(elapsed_.back() / farthest);
      if (!arrived) continue;
      if (run.work <= cheap) return;
      work = run.work / 2;
    }
  }

  Reference reference(const Comparison& best) const {
    Reference r;
    r.methods = family_.words;
    r.disagreement = static_cast<double>(best.worst);
    r.known_until = static_cast<double>(t0_);
    State apart(system_.states, 0), largest(system_.states, 0);
    extend(largest, system_.y0);
    for (std::size_t k = 0; k < best.known; ++k) {
      const State& y = best.a.states[k];
      extend(apart, best.apart[k]);
      extend(largest, y);
      if (std::ranges::find(best.a.ambiguous, k) != best.a.ambiguous.end()) continue;
      const State floors = floors_of({system_, units_, moved_}, best, k, apart, largest);
      if (constants_decide_events(moved_, best, elapsed_, k) ||
          !(largest_of(floors, y, units_) <= few_digits * size_of(largest))) {
        r.end = fmt::format("from t = {:.6Lg} on, rounding leaves too few digits", times_[k]);
        break;
      }
      r.known_until = static_cast<double>(times_[k]);
      r.times.push_back(r.known_until);
      r.states.push_back(y);
      r.floors.emplace_back(floors.begin(), floors.end());
    }
    if (r.end.empty() && best.known < times_.size()) r.end = why(best);
    if (best.spent && best.known == std::min(best.a.states.size(), best.b.states.size()))
      r.spent_at = static_cast<double>(t0_ + std::min(best.a.reached, best.b.reached));
    r.seconds = best.seconds;
    r.is_explicit = family_.first != radau_run;
    const Real first = best.a.ends_at, second = best.b.ends_at, margin = 1e-6L * elapsed_.back();
    if (std::isfinite(first) && std::abs(first - second) <= margin)
      r.ends_at = static_cast<double>(t0_ + std::max(first, second) + margin);
    return r;
  }

  bool rounds_at_events() const { return system_.events && system_.events->in_double; }
  std::string why(const Comparison& best) const {
    if (best.known < std::min(best.a.states.size(), best.b.states.size()))
      return fmt::format(
          "at t = {:.6Lg} two methods agree on less than 1e-6 of the scale: chaos, or kinks",
          times_[best.known]);
    return best.a.states.size() <= best.b.states.size() ? best.a.end : best.b.end;
  }

  System system_;  ///< with the time since the start
  Real t0_;
  const ErrorUnits& units_;
  const TruthBounds bounds_;
  std::vector<Real> times_, elapsed_;  ///< the latter since the start
  Family family_{};
  /// Operations that may still be spent, of one or two nanoseconds each.
  double left_ = 0;
  double brief_work_ = 0;       ///< of `first` to the end at the tolerance `brief`, as foreseen
  Run second_;                  ///< the last of `second`
  Real second_tolerance_ = -1;  ///< at which it was made
  std::array<double, 2> most_work_{1e300, 1e300};  ///< of the two methods
  std::optional<Run> moved_;
  Real inspected_ = 0;  ///< the loosest tolerance at which steps of `first` were looked into
  bool found_ = false;  ///< something that the samples of steps had missed
};

}  // namespace

Reference compute_reference(const System& system, const std::vector<double>& times,
                            const ErrorUnits& units, const TruthBounds& bounds) {
  return Search(system, times, units, bounds).find();
}

}  // namespace odeum::truth
