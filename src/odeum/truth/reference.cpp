// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>

#include "odeum/core/parallel.hpp"
#include "odeum/truth/sizes.hpp"

namespace odeum::truth {
namespace {

constexpr int checks = 80;           // times looked at besides those asked for
constexpr Real unknown = 1e-6L;      // of the scale: beyond that nothing is known
constexpr Real least = 0x1p-62L;     // of the scale: rounding of extended precision itself
constexpr Real moved_by = 0x1p-30L;  // see System::moved_rhs
constexpr std::size_t few = 64;      // states; with more, each comparison takes seconds

/// Two methods that share no formula.
struct Family {
  Method first, second;
  const char* words;
  Method for_moved;  ///< the cheaper one of those without a series
  Real finest;       ///< tolerance below which `second` does the same
};

/// Two runs and how they differ.
struct Comparison {
  Run a, b;
  bool spent = false;        ///< one of them ended for the work that it took
  std::vector<State> apart;  ///< by time and component, as far as both came
  Real worst = 0;            ///< of those that are known
  std::size_t known = 0;     ///< times at which they agree
};

class Search {
 public:
  Search(const System& system, const std::vector<double>& asked, const ErrorUnits& units)
      : system_(system), units_(units) {
    const Real end = asked.back(), span = end - system.t0;
    const std::set<Real> stops(asked.begin(), asked.end());
    std::set<Real> all = stops;
    for (int k = 1; k < checks; ++k) {
      // One beside a time asked for would cost steps for nothing, and is the same time in double.
      const Real t = system.t0 + span * k / checks, beside = 1e-6L * span;
      const auto next = stops.lower_bound(t - beside);
      if (next == stops.end() || *next > t + beside) all.insert(t);
    }
    times_.assign(all.begin(), all.end());
  }

  Reference find() {
    choose();
    const bool in_double = system_.rounding > 0x1p-60L;
    if (in_double || until_ == Moment::max()) return reference(finest(in_double));
    // Something is known where the seconds do not suffice for more, which is not moved by this.
    const Comparison loose = compare(1e-14L);
    moved_.reset();
    second_tolerance_ = -1;
    inspected_ = 0;
    found_ = false;
    const Comparison best = finest(in_double);
    return reference(best.known < loose.known ? loose : best);
  }

 private:
  Comparison finest(bool in_double) {
    if (system_.states > few) return finest_of_many(in_double);
    std::vector<Real> ladder =
        in_double ? std::vector<Real>{1e-11L, 1e-13L, 1e-15L} : std::vector<Real>{2e-18L, 4e-19L};
    Comparison best = compare(ladder.front());
    const bool whole = best.known == times_.size();
    // Looser ones where that costs too much, or where rounding adds up in the many steps.
    if (!in_double && (whole ? best.worst > 1e-13L * size_of(best) : best.spent))
      ladder = {2e-18L, 1e-16L, 1e-14L};
    if (in_double && best.spent) ladder = {1e-11L, 1e-9L, 1e-7L};
    // The same steps again where stability limits them, not the tolerance.
    const bool limited = best.a.work < 1.3 * brief_work_;
    if (!in_double && whole && limited && best.worst <= 1e-15L * size_of(best)) return best;
    for (std::size_t k = 1; k < ladder.size() && !is_past(until_); ++k) {
      // Far below the rounding of double.
      if (best.known == times_.size() && best.worst <= 0x1p-60L * size_of(best)) break;
      Comparison other = compare(ladder[k]);
      if (is_better(other, best)) best = std::move(other);
    }
    return best;
  }

  static bool is_better(const Comparison& a, const Comparison& b) {
    return a.known > b.known || (a.known == b.known && a.worst < b.worst);
  }

  /// Begins in the middle and goes to finer tolerances while they are expected to be affordable.
  Comparison finest_of_many(bool in_double) {
    using Ladder = std::vector<Real>;
    const Ladder finer = in_double ? Ladder{1e-11L, 1e-13L, 1e-15L} : Ladder{1e-16L, 2e-18L},
                 looser = in_double ? Ladder{1e-7L} : Ladder{1e-12L, 1e-9L};
    const Real middle = in_double ? 1e-9L : 1e-14L;
    Comparison best = compare(middle);
    if (best.spent) {
      // The work falls as the tolerance's ninth root; the loosest is tried at any rate.
      const auto both = std::min(best.a.states.size(), best.b.states.size());
      const Real share = static_cast<Real>(both) / static_cast<Real>(times_.size());
      for (const Real tolerance : looser) {
        const bool fits = std::pow(middle / tolerance, 1.0L / 9) <= share;
        if (!fits && tolerance != looser.back()) continue;
        Comparison other = compare(tolerance);
        if (is_better(other, best)) best = std::move(other);
        if (!best.spent || is_past(until_)) break;
      }
      return best;
    }
    for (const Real tolerance : finer) {
      // Solvers compute in double, whose rounding adds up to as much.
      if (best.worst <= 1e-13L * size_of(best) || is_past(until_)) break;
      most_work_ = {3 * best.a.work, 3 * best.b.work};  // the power of the tolerance gives 1.7
      Comparison other = compare(tolerance);
      const bool spent = other.spent;
      if (is_better(other, best)) best = std::move(other);
      if (spent) break;  // by steps that rounding makes short
    }
    return best;
  }

  Real size_of(const State& y) const { return largest_of(y, y, units_); }
  Real size_of(const Comparison& c) const {
    Real size = size_of(system_.y0);
    for (std::size_t k = 0; k < c.known; ++k) size = std::max(size, size_of(c.a.states[k]));
    return size;
  }

  /// On constants that rounding could have moved.
  Run run_moved() const {
    const Effort effort{.tolerance = 1e-13L, .inspect = found_, .until = until_};
    if (system_.mode_at) return run_across(family_.for_moved, system_, times_, effort, true);
    System moved = system_;
    moved.rhs = system_.moved_rhs;
    moved.y0 = system_.moved_y0;
    return family_.for_moved(moved, times_, effort);
  }
  Run run(Method method, const Effort& effort) const {
    return run_across(method, system_, times_, effort, false);
  }

  Comparison compare(Real tolerance) {
    Comparison c;
    Effort effort{
        .tolerance = tolerance, .inspect = found_ || tolerance > inspected_, .until = until_};
    // An operation of compiled double arithmetic takes a fifth of one of extended precision.
    const bool quick = system_.rounding > 0x1p-60L && system_.smooth;
    if (system_.states > few) effort.budget *= quick ? 16 : 4;
    // Where `first` has missed nothing, and `second` agrees, that has missed nothing either.
    Effort of_second{.tolerance = std::max(tolerance, family_.finest),
                     .budget = std::min(effort.budget, most_work_[1]),
                     .inspect = found_,
                     .until = until_};
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
    if (with_moved) moved_ = std::move(moved);
    inspected_ = std::max(inspected_, tolerance);
    if (c.a.split && !found_) {
      found_ = of_second.inspect = true;
      second_ = this->run(family_.second, of_second);
      if (moved_) moved_ = run_moved();
    }
    second_tolerance_ = of_second.tolerance;
    c.b = second_;
    c.spent = c.a.work > effort.budget || c.b.work > of_second.budget;
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
        system_.mode_at ? system_.mode_at(system_.t0, system_.y0, times_.back() - system_.t0, false)
                        : nullptr;
    const bool series = system_.taylor || (mode && mode->taylor);
    const Family plain{verner_run, extrapolation_run,
                       "Verner's pair 9(8) and Gragg's extrapolation", verner_run, 0};
    // The weights of extrapolation amplify rounding: where there is a series, it is not needed.
    const Family by_series{taylor_run, verner_run, "Taylor's series and Verner's pair 9(8)",
                           verner_run, 0};
    const Family implicit_family{radau_run, implicit_extrapolation_run,
                                 "Radau IIA of order 13 and the extrapolated implicit Euler method",
                                 radau_run, finest_implicit_extrapolation};
    family_ = series ? by_series : plain;
    const Effort brief{.tolerance = 1e-12L, .budget = 3e8, .until = until_};
    std::size_t farthest = 0;
    // A problem that is too stiff for the series may be cheap enough for shorter steps, and one
    // that has none (a root at zero) may go on without.
    for (const Family& family : {by_series, plain, implicit_family}) {
      if ((family.first == taylor_run && !series) ||
          (family.first == radau_run && !system_.has_jacobian()))
        continue;
      const Run run = this->run(family.first, brief);
      if (run.states.size() > farthest) {
        farthest = run.states.size();
        family_ = family;
      }
      if (run.end.empty()) {
        // The order of a series is too high to tell what limits its steps.
        if (family.first != taylor_run) brief_work_ = run.work;
        return;
      }
    }
  }

  Reference reference(const Comparison& best) const {
    Reference r;
    r.methods = family_.words;
    r.disagreement = static_cast<double>(best.worst);
    // Rounding of constants is one error with one sign, which two methods share.
    // The disagreement of two methods can be small by chance at one time, and errors of both can
    // have the same sign; where there are kinks, each misses them alike.
    const Real safety = system_.smooth ? 10 : 100;
    const std::size_t n = system_.states;
    State apart(n, 0), largest(n, 0);
    extend(largest, system_.y0);
    for (std::size_t k = 0; k < best.known; ++k) {
      const State& y = best.a.states[k];
      extend(apart, best.apart[k]);
      extend(largest, y);
      State constants(n, 0);
      if (moved_ && k < moved_->states.size()) constants = difference_of(y, moved_->states[k]);
      r.known_until = static_cast<double>(times_[k]);
      r.times.push_back(r.known_until);
      r.states.push_back(y);
      std::vector<double>& floors = r.floors.emplace_back(n);
      for (std::size_t i = 0; i < n; ++i)
        floors[i] = static_cast<double>(
            safety * apart[i] + 10 * constants[i] / moved_by * 0x1p-64L + least * largest[i]);
    }
    if (best.known < times_.size()) r.end = why(best);
    const Real first = best.a.ends_at, second = best.b.ends_at;
    const Real margin = 1e-6L * (times_.back() - system_.t0);
    if (std::isfinite(first) && std::abs(first - second) <= margin)
      r.ends_at = static_cast<double>(std::max(first, second) + margin);
    return r;
  }

  std::string why(const Comparison& best) const {
    const std::size_t both = std::min(best.a.states.size(), best.b.states.size());
    if (best.known < both)
      return fmt::format(
          "at t = {:.6Lg} two methods agree on less than 1e-6 of the scale: chaos, or kinks",
          times_[best.known]);
    return best.a.states.size() <= best.b.states.size() ? best.a.end : best.b.end;
  }

  const System& system_;
  const ErrorUnits& units_;
  const Moment until_ = Deadline::in_force();
  std::vector<Real> times_;
  Family family_{};
  double brief_work_ = 0;       ///< of `first` at a loose tolerance; 0: not known
  Run second_;                  ///< the last of `second`
  Real second_tolerance_ = -1;  ///< at which it was made
  std::array<double, 2> most_work_{1e300, 1e300};  ///< of the two methods
  std::optional<Run> moved_;
  Real inspected_ = 0;  ///< the loosest tolerance at which steps of `first` were looked into
  bool found_ = false;  ///< something that the samples of steps had missed
};

}  // namespace

Reference compute_reference(const System& system, const std::vector<double>& times,
                            const ErrorUnits& units) {
  return Search(system, times, units).find();
}

}  // namespace odeum::truth
