// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/text_system.hpp"

#include <cmath>
#include <map>
#include <mutex>
#include <set>
#include <utility>
#include <vector>

#include "odeum/formula/modes.hpp"
#include "odeum/linear/ordering.hpp"
#include "odeum/truth/inspector.hpp"

namespace odeum::truth {
namespace {

using formula::Id;
using formula::TextOde;

/// Product of its widths in the reverse Cuthill-McKee ordering.
double narrowest_band(const Sparsity& pattern) {
  const linear::Band band = linear::band_of(pattern, linear::reverse_cuthill_mckee(pattern));
  return static_cast<double>(band.lower * band.upper);
}

/// Numbers of few binary digits are exact.
Real moved(Real c) {
  constexpr Real few = 0x1p24L;
  const bool exact = c == 0 || std::ldexp(few, std::ilogb(c)) == 0 ||
                     std::remainder(c, std::ldexp(1 / few, std::ilogb(c))) == 0;
  return exact ? c : c * (1 + 0x1p-30L);
}

using Holds = std::function<Real(Real t, const Real* y)>;

/// By interval arithmetic on the equations, and on conditions that are positive.
class TextInsight : public Insight {
 public:
  TextInsight(std::shared_ptr<const TextOde> ode, const std::vector<Id>& conditions, Holds holds,
              Real t0, Real span)
      : ode_(std::move(ode)),
        holds_(std::move(holds)),
        inspector_(ode_->problem().graph, ode_->problem().equations, conditions, t0, span),
        slope_(ode_->size()),
        next_slope_(slope_) {}

  Inside look(Real t, Real h, const State& y, const State& next) override {
    ode_->rhs_extended(t, y.data(), slope_.data());
    ode_->rhs_extended(t + h, next.data(), next_slope_.data());
    Inside inside = inspector_.look(t, h, y, slope_, next, next_slope_);
    if (inside.kind == Inside::Kind::nothing && holds_ && !(holds_(t + h, next.data()) > 0))
      inside.kind = Inside::Kind::change;
    return inside;
  }
  bool rounding(Real t, const State& y, State& bound) override {
    inspector_.rounding(t, y, bound);
    return true;
  }

 private:
  std::shared_ptr<const TextOde> ode_;
  Holds holds_;
  Inspector inspector_;
  State slope_, next_slope_;
};

/// A text without kinks, and its derivatives.
System smooth_system(const std::shared_ptr<const TextOde>& ode) {
  const formula::Problem& problem = ode->problem();
  System system;
  system.states = ode->size();
  system.t0 = problem.t0;
  system.y0 = problem.y0;
  system.smooth = ode->analysis().structure.smooth;
  system.concurrent = true;
  system.rhs = [ode](Real t, const Real* y, Real* f) { ode->rhs_extended(t, y, f); };
  constexpr double widest_band = 200;  // a wider one takes too long
  if (ode->view().sparsity && narrowest_band(ode->sparsity()) <= widest_band) {
    system.sparsity = {ode, &ode->sparsity()};
    system.entries = [ode](Real t, const Real* y, Real* v) { ode->entries_extended(t, y, v); };
  } else if (ode->size() <= most_in_matrix) {
    system.jacobian = [ode](Real t, const Real* y, Real* j) { ode->jacobian_extended(t, y, j); };
  }
  system.work = static_cast<double>(problem.graph.needed(problem.equations).size());
  if (const auto& plan = ode->analysis().series) {
    const auto series =
        std::make_shared<formula::Series<Real>>(problem.graph, *plan, system.states);
    system.taylor = [series](Real t, const Real* y, int order, Real* c) {
      (*series)(t, y, order, c);
    };
  }
  return system;
}

/// The smooth parts of a text with kinks.
class Modes {
 public:
  explicit Modes(std::shared_ptr<const TextOde> ode) : ode_(std::move(ode)) {}

  std::shared_ptr<System> at(Real t, const State& y, Real span, bool is_moved) {
    const std::lock_guard lock(used_);
    formula::Signs signs = signs_at(t, y, is_moved);
    // A change of a condition changes the slope, and with it perhaps other conditions.
    constexpr int most_rounds = 40;
    for (int round = 0; round < most_rounds; ++round) {
      Part& part = part_of(signs, is_moved);
      bool settled = true;
      const Real after = span * 0x1p-40L;
      const State next = short_way(part, t, y, after);
      State values(part.mode.switches.size());
      (*part.conditions)(t + after, next.data(), values.data());
      for (std::size_t k = 0; k < values.size(); ++k) {
        int& sign = signs[part.mode.ids[k]];
        const int now = part.mode.sign(k, values[k]);
        settled = settled && now == part.mode.signs.at(part.mode.ids[k]);
        sign = now;
      }
      if (settled) return has_become_zero(part.mode, t) ? nullptr : system_of_part(part, t);
    }
    return nullptr;
  }

 private:
  struct Part {
    formula::Mode mode;
    std::shared_ptr<const TextOde> ode;
    std::shared_ptr<const formula::Evaluator<Real>> conditions;
    std::vector<Id> positive, zero;  ///< the conditions with the signs that they have here
  };

  /// Where a solution comes to rest at a change, other solutions may leave it.
  bool has_become_zero(const formula::Mode& mode, Real t) {
    bool has = false;
    for (const auto& [id, sign] : mode.signs) {
      if (sign != 0) continue;
      if (t == ode_->problem().t0) zero_.insert(id);
      has = has || !zero_.contains(id);
    }
    return has;
  }

  /// Of all conditions at a place, as far as they matter there.
  formula::Signs signs_at(Real t, const State& y, bool is_moved) {
    formula::Signs signs;
    for (std::size_t known = 0;;) {
      const formula::Mode mode = mode_with(signs, is_moved);
      const formula::Evaluator<Real> conditions(mode.problem.graph, mode.switches);
      State values(mode.switches.size());
      conditions(t, y.data(), values.data());
      for (std::size_t k = 0; k < values.size(); ++k) signs[mode.ids[k]] = mode.sign(k, values[k]);
      if (signs.size() == known) return signs;
      known = signs.size();
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
        if (mode.signs.at(mode.ids[k]) == 0)
          part.zero.push_back(mode.switches[k]);
        else
          part.positive.push_back(mode.held(k));
      }
      part.mode = mode;
      part.ode =
          std::make_shared<const TextOde>(std::move(mode.problem), TextOde::Code::interpreted);
      part.conditions = std::make_shared<const formula::Evaluator<Real>>(part.ode->problem().graph,
                                                                         part.mode.switches);
    }
    return at->second;
  }
  /// By Euler's method in a few steps, so that a condition of which only a higher derivative is not
  /// zero changes too.
  static State short_way(const Part& part, Real t, State y, Real after) {
    constexpr int steps = 4;
    State slope(y.size());
    for (int k = 0; k < steps; ++k) {
      part.ode->rhs_extended(t + after * k / steps, y.data(), slope.data());
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += after / steps * slope[i];
    }
    return y;
  }
  static std::shared_ptr<System> system_of_part(const Part& part, Real t) {
    auto system = std::make_shared<System>(smooth_system(part.ode));
    std::vector<Id> all = part.positive;
    all.insert(all.end(), part.zero.begin(), part.zero.end());
    const auto holds =
        std::make_shared<const formula::Evaluator<Real>>(part.ode->problem().graph, all);
    system->holds = [holds, positive = part.positive.size(), count = all.size()](Real at,
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
    system->insight = [ode = part.ode, positive = part.positive, holds = system->holds,
                       t](Real span) {
      return std::make_unique<TextInsight>(ode, positive, holds, t, span);
    };
    return system;
  }

  std::shared_ptr<const TextOde> ode_;
  std::mutex used_;
  std::map<std::pair<formula::Signs, bool>, Part> parts_;
  std::set<Id> zero_;  ///< from the start on
};

}  // namespace

System system_of(const std::shared_ptr<const TextOde>& ode) {
  System system = smooth_system(ode);
  const formula::Problem& problem = ode->problem();
  for (const Real y : problem.y0) system.moved_y0.push_back(moved(y));
  if (!system.smooth) {
    const auto modes = std::make_shared<Modes>(ode);
    system.mode_at = [modes](Real t, const State& y, Real span, bool is_moved) {
      return modes->at(t, y, span, is_moved);
    };
    return system;
  }
  system.insight = [ode, t0 = system.t0](Real span) {
    return std::make_unique<TextInsight>(ode, std::vector<Id>{}, nullptr, t0, span);
  };
  auto evaluator = std::make_shared<formula::Evaluator<Real>>(problem.graph, problem.equations);
  evaluator->perturb(moved);
  system.moved_rhs = [evaluator](Real t, const Real* y, Real* f) { (*evaluator)(t, y, f); };
  return system;
}

}  // namespace odeum::truth
