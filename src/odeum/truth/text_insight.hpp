// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <utility>
#include <vector>

#include "odeum/formula/text_ode.hpp"
#include "odeum/truth/inspector.hpp"

namespace odeum::truth {

/// Looks into steps by interval arithmetic on the equations, and on conditions that are positive.
/// `whole`: the text of which the equations are a mode.
class TextInsight final : public Insight {
 public:
  using Holds = std::function<Real(Real t, const Real* y)>;

  TextInsight(std::shared_ptr<const formula::TextOde> ode,
              std::shared_ptr<const formula::TextOde> whole,
              const std::vector<formula::Id>& conditions, Holds holds, Real t0, Real span)
      : ode_(std::move(ode)),
        whole_(std::move(whole)),
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
  State spread(Real t, Real h, const State& y, const State& next) override {
    const formula::Problem& problem = whole_->problem();
    return Inspector(problem.graph, problem.equations, {}, t, h).spread(t, h, y, next);
  }

 private:
  std::shared_ptr<const formula::TextOde> ode_, whole_;
  Holds holds_;
  Inspector inspector_;
  State slope_, next_slope_;
};

}  // namespace odeum::truth
