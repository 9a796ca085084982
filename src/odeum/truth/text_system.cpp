// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/text_system.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include "odeum/formula/modes.hpp"
#include "odeum/formula/switch_times.hpp"
#include "odeum/truth/smooth_text.hpp"
#include "odeum/truth/text_happenings.hpp"
#include "odeum/truth/text_insight.hpp"

namespace odeum::truth {
namespace {

using formula::Id;
using formula::TextOde;

/// At a switch that a text names its rounded time may lie on the other side, where an expression
/// that holds on this one has no value, as a/s in `if(s > 0, exp(-a/s), 0)`.
void keep_between(Real from, Real to, System& system) {
  const auto keep = [from, to](auto& function) {
    if (function)
      function = [function, from, to](Real t, const Real* y, auto... more) {
        return function(std::clamp(t, from, to), y, more...);
      };
  };
  keep(system.rhs);
  keep(system.jacobian);
  keep(system.entries);
  keep(system.taylor);
}

/// The smooth parts of a text with kinks. Steps end at the switches that the text names, so that
/// their conditions need not be looked at within steps.
class Modes {
 public:
  Modes(std::shared_ptr<const TextOde> ode, formula::SwitchTimes named)
      : ode_(std::move(ode)), named_(std::move(named)) {}

  std::shared_ptr<System> at(Real t, const State& y, Real span, bool is_moved) {
    const std::lock_guard lock(used_);
    const Real rounding = 64 * std::numeric_limits<Real>::epsilon() * std::abs(t);
    const auto later = std::ranges::upper_bound(named_.times, t + rounding);
    const Real left = (later == named_.times.end() ? end() : *later) - t;
    middle_ = t + left / 2;
    // A condition of which only a higher derivative is not zero changes after a while; what changes
    // back within that while is found by a shorter one.
    Part* chosen = nullptr;
    for (const Real part : {0x1p-40L, 0x1p-50L}) {
      const Real after = std::min(span * part, left / 4);
      Part* const found = settled(t, y, after, is_moved);
      if (chosen && (!found || found == chosen || !differ(*found, *chosen, t, y, span * 0x1p-40L)))
        break;
      chosen = found;
      if (!chosen) break;
    }
    if (!chosen || has_become_zero(chosen->mode, t)) return nullptr;
    auto system =
        system_of_part(*chosen, t, sides_of(*chosen, t, y, std::min(span * 0x1p-40L, left / 4)));
    constexpr Real none = std::numeric_limits<Real>::infinity(), aside = 1 - 0x1p-60L;
    const bool begins = later != named_.times.begin() && t - *std::prev(later) <= rounding;
    keep_between(begins ? t + rounding / 8 : -none,
                 later == named_.times.end() ? none : t + left * aside, *system);
    return system;
  }

 private:
  struct Part {
    std::vector<std::array<Id, 2>> events;  ///< the expressions, and the same negated
    formula::Mode mode;
    std::shared_ptr<const TextOde> ode;
    std::shared_ptr<const formula::Evaluator<Real>> conditions;
    std::vector<Id> positive, zero;  ///< the conditions with the signs that they have here
  };

  /// The part whose conditions hold a while after t; null: there is none.
  Part* settled(Real t, const State& y, Real after, bool is_moved) {
    formula::Signs signs = signs_at(t, y, is_moved);
    // A change of a condition changes the slope, and with it perhaps other conditions.
    constexpr int most_rounds = 40;
    for (int round = 0; round < most_rounds; ++round) {
      Part& part = part_of(signs, is_moved);
      bool holds = true;
      const State next = short_way(part, t, y, after);
      State values(part.mode.switches.size());
      (*part.conditions)(t + after, next.data(), values.data());
      for (std::size_t k = 0; k < values.size(); ++k) {
        const Id id = part.mode.ids[k];
        if (named_.nodes.contains(id)) continue;
        const int now = part.mode.sign(k, values[k]);
        holds = holds && now == part.mode.signs.at(id);
        signs[id] = now;
      }
      if (holds) return &part;
    }
    return nullptr;
  }

  /// Whether it matters which of the parts holds for a while.
  static bool differ(const Part& a, const Part& b, Real t, const State& y, Real while_) {
    constexpr Real little = 1e-16L;
    State f(y.size()), g(y.size());
    a.ode->rhs_extended(t, y.data(), f.data());
    b.ode->rhs_extended(t, y.data(), g.data());
    Real size = 0, apart = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
      size = std::max(size, std::abs(y[i]));
      apart = std::max(apart, std::abs(f[i] - g[i]));
    }
    return !(apart * while_ <= little * (size > 0 ? size : 1));
  }

  /// Where a solution comes to rest at a change, other solutions may leave it.
  bool has_become_zero(const formula::Mode& mode, Real t) {
    bool has = false;
    for (const auto& [id, sign] : mode.signs) {
      if (sign != 0 || named_.nodes.contains(id)) continue;
      if (t == ode_->problem().t0) zero_.insert(id);
      has = has || !zero_.contains(id);
    }
    return has;
  }

  /// The signs of all conditions at a place, as far as they matter there. The signs of some select
  /// what others compare, as in abs(u) < 1, so that all are computed until none changes.
  formula::Signs signs_at(Real t, const State& y, bool is_moved) {
    formula::Signs signs;
    for (;;) {
      const formula::Signs before = signs;
      const formula::Mode mode = mode_with(signs, is_moved);
      const formula::Evaluator<Real> conditions(mode.problem.graph, mode.switches);
      State values(mode.switches.size()), named(mode.switches.size());
      conditions(t, y.data(), values.data());
      conditions(middle_, y.data(), named.data());
      for (std::size_t k = 0; k < values.size(); ++k) {
        const Real value = named_.nodes.contains(mode.ids[k]) ? named[k] : values[k];
        signs[mode.ids[k]] = mode.sign(k, value);
      }
      if (signs == before) return signs;
    }
  }
  formula::Mode mode_with(const formula::Signs& signs, bool is_moved) const {
    return formula::mode_of(ode_->problem(), signs,
                            [is_moved](long double c) { return is_moved ? moved(c) : c; });
  }
  Part& part_of(const formula::Signs& signs, bool is_moved) {
    formula::Mode mode = mode_with(signs, is_moved);
    const auto [at, added] = parts_.try_emplace({mode.signs, is_moved});
    if (added) {
      Part& part = at->second;
      for (std::size_t k = 0; k < mode.switches.size(); ++k) {
        if (named_.nodes.contains(mode.ids[k])) continue;
        if (mode.signs.at(mode.ids[k]) == 0)
          part.zero.push_back(mode.switches[k]);
        else
          part.positive.push_back(mode.held(k));
      }
      for (const Id event : mode.events)
        part.events.push_back({event, mode.problem.graph.make(formula::Op::negate, event)});
      part.mode = mode;
      part.ode =
          std::make_shared<const TextOde>(std::move(mode.problem), TextOde::Code::interpreted);
      part.conditions = std::make_shared<const formula::Evaluator<Real>>(part.ode->problem().graph,
                                                                         part.mode.switches);
    }
    return at->second;
  }
  /// Four steps of Euler's method change what only a higher derivative moves, too.
  static State short_way(const Part& part, Real t, State y, Real after) {
    constexpr int steps = 4;
    State slope(y.size());
    for (int k = 0; k < steps; ++k) {
      part.ode->rhs_extended(t + after * k / steps, y.data(), slope.data());
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += after / steps * slope[i];
    }
    return y;
  }
  /// The signs of the expressions of events a while after t.
  static std::vector<int> sides_of(const Part& part, Real t, const State& y, Real after) {
    State values(part.events.size());
    const State next = short_way(part, t, y, after);
    formula::Evaluator<Real>(part.ode->problem().graph, part.mode.events)(t + after, next.data(),
                                                                          values.data());
    std::vector<int> sides;
    for (const Real value : values)
      sides.push_back(static_cast<int>(value > 0) - static_cast<int>(value < 0));
    return sides;
  }
  std::shared_ptr<System> system_of_part(const Part& part, Real t, std::vector<int> sides) const {
    auto system = std::make_shared<System>(smooth_system(part.ode));
    system->work *= 5;  // interpreted
    std::vector<Id> positive = part.positive, zero = part.zero;
    for (std::size_t k = 0; k < sides.size(); ++k)
      sides[k] == 0 ? zero.push_back(part.events[k][0])
                    : positive.push_back(part.events[k][sides[k] > 0 ? 0 : 1]);
    system->sides = std::move(sides);
    std::vector<Id> all = positive;
    all.insert(all.end(), zero.begin(), zero.end());
    system->whole_rhs = [ode = ode_](Real at, const Real* y, Real* f) {
      ode->rhs_extended(at, y, f);
    };
    const auto holds =
        std::make_shared<const formula::Evaluator<Real>>(part.ode->problem().graph, all);
    system->holds = [holds, positive = positive.size(), count = all.size()](Real at,
                                                                            const Real* y) {
      State values(count);
      (*holds)(at, y, values.data());
      Real least = 1;
      for (std::size_t k = 0; k < count; ++k)
        least = std::min(least, k < positive     ? values[k]
                                : values[k] == 0 ? 1
                                                 : -std::abs(values[k]));
      return least;
    };
    system->insight = [ode = part.ode, whole = ode_, positive, holds = system->holds,
                       t](Real span) {
      return std::make_unique<TextInsight>(ode, whole, positive, holds, t, span);
    };
    return system;
  }
  Real end() const { return ode_->problem().stops.back(); }

  std::shared_ptr<const TextOde> ode_;
  formula::SwitchTimes named_;
  std::mutex used_;
  Real middle_ = 0;  ///< of the time up to the next named switch
  std::map<std::pair<formula::Signs, bool>, Part> parts_;
  std::set<Id> zero_;  ///< from the start on
};

}  // namespace

System system_of(const std::shared_ptr<const TextOde>& ode) {
  System system = smooth_system(ode);
  const formula::Problem& problem = ode->problem();
  for (const Real y : problem.y0) system.moved_y0.push_back(moved(y));
  if (!system.smooth || !problem.events.empty()) {
    system.smooth = false;
    formula::SwitchTimes named = formula::switch_times(problem, problem.stops.back());
    system.switches = named.times;
    add_happenings(problem, system);
    const auto modes = std::make_shared<Modes>(ode, std::move(named));
    system.mode_at = [modes](Real t, const State& y, Real span, bool is_moved) {
      return modes->at(t, y, span, is_moved);
    };
    return system;
  }
  system.insight = [ode, t0 = system.t0](Real span) {
    return std::make_unique<TextInsight>(ode, ode, std::vector<Id>{}, nullptr, t0, span);
  };
  auto evaluator = std::make_shared<formula::Evaluator<Real>>(problem.graph, problem.equations);
  evaluator->perturb(moved);
  system.moved_rhs = [evaluator](Real t, const Real* y, Real* f) { (*evaluator)(t, y, f); };
  return system;
}

}  // namespace odeum::truth
