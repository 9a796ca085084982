// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "odeum/control/adaptive.hpp"
#include "odeum/control/slope_range.hpp"
#include "odeum/kernel/components.hpp"
#include "odeum/kernel/extrapolated_euler.hpp"
#include "odeum/kernel/inner_nodes.hpp"
#include "odeum/kernel/quick_power.hpp"

namespace odeum {

/// Chooses step and column of an adaptive run by the work per unit step (IV.9; Solving ODEs I,
/// II.9): column `target`, the one before where that meets the tolerance, the one after where
/// necessary.
template <Ode P>
class ExtrapolatedEulerControl {
 public:
  ExtrapolatedEulerControl(const P& problem, const Tolerance& tolerance)
      : problem_(problem),
        table_(problem),
        scale_(make_state(problem)),
        error_scale_(tolerance, scale_) {
    target_ = std::clamp(static_cast<std::size_t>(1.5 - 0.6 * std::log10(tolerance.relative)),
                         std::size_t{2}, last - 1);
    // In units of one evaluation with its solve; a factorisation counts as two.
    const auto substeps = [](std::size_t j) {
      return static_cast<double>(ExtrapolatedEulerTable<P>::substeps(j));
    };
    work_[0] = 3 + substeps(0) + 2;
    for (std::size_t j = 1; j < columns; ++j) work_[j] = work_[j - 1] + substeps(j) + 2;
  }

  Decision operator()(double t, double h, const State<P>& y, State<P>& y_new) {
    if (moved_) {
      table_.linearise(t, y);
      moved_ = false;
    }
    each_component(y, [&](std::size_t n) { scale_[n] = 1 / error_scale_(n, std::abs(y[n])); });
    used_ = 0;
    begin_trial(problem_);
    double error = 0, before = 0;
    for (std::size_t j = 0; j <= std::min(target_ + 1, last); ++j) {
      double contraction = 0;
      if (!table_.add_row(j, t, h, y, contraction) || !(contraction <= 1)) return unusable(h);
      if (j == 0) continue;
      error = difference(j);
      if (!std::isfinite(error) || (j > 1 && error > before && error > 1)) return unusable(h);
      before = std::max(4 * error, 1.0);
      used_ = j;
      const double factor =
          0.94 * quick_power(0.65 / std::max(error, 1e-12), 1.0 / static_cast<double>(j + 1));
      step_[j] = h * std::clamp(factor, 0.1, 8.0);
      cost_[j] = work_[j] / step_[j];
      if (error <= 1 && (j + 1 >= target_ || first_)) break;
      // The remaining columns cannot reach the tolerance.
      const auto n = static_cast<double>(ExtrapolatedEulerTable<P>::substeps(target_));
      if (j + 1 == target_ && error > 4 * n * (n + 1)) break;
      if (j == target_ && error > 2 * (n + 1)) break;
    }
    y_new = table_.column(used_);
    if (error <= 1 && !has_ends(problem_, t, h, y, y_new, error_scale_, table_)) return unusable(h);
    return error <= 1 ? accept(h) : reject(h);
  }

  /// Interpolation with steps aside to its nodes by the column of the step made. Without slopes: f
  /// magnifies the errors of stiff components.
  Status between(const StepMade<State<P>>& step, double time, State<P>& y) {
    if (!nodes_.hold(step.t, step.h) && !fill_nodes(step)) {
      step.by_line(time, y);
      return Status::newton_failed;
    }
    nodes_.by_states(step.share(time), y);
    return Status::ok;
  }

 private:
  bool fill_nodes(const StepMade<State<P>>& step) {
    // Column k, from 0, has order k + 1. A polynomial of degree k would keep that over a whole run,
    // but be three times as far off as the ends of the steps on Robertson's reactions.
    nodes_.begin(step.t, step.h, static_cast<int>(used_), step.before);
    const std::size_t end = nodes_.size() - 1;
    nodes_.state(0) = step.before;
    nodes_.state(end) = step.after;
    table_.linearise(step.t, step.before);
    double contraction = 0;
    for (std::size_t k = 1; k < end; ++k) {
      for (std::size_t j = 0; j <= used_; ++j)
        if (!table_.add_row(j, step.t, nodes_.share(k) * step.h, step.before, contraction))
          return false;
      nodes_.state(k) = table_.column(used_);
    }
    nodes_.filled();
    return true;
  }

  static constexpr std::size_t columns = ExtrapolatedEulerTable<P>::max_columns, last = columns - 1;

  Decision unusable(double h) {
    rejected_ = true;
    return {false, h / 4};
  }
  Decision reject(double h) {
    target_ = std::min({target_, used_, last - 1});
    if (target_ > 2 && cost_[target_ - 1] < 0.7 * cost_[target_]) --target_;
    target_ = std::max(target_, std::size_t{1});
    rejected_ = true;
    return {false, std::min(step_[target_], 0.8 * h)};
  }
  Decision accept(double h) {
    first_ = false;
    moved_ = true;
    const std::size_t k = used_;
    std::size_t best = k;
    if (k >= 2 && cost_[k - 1] < 0.7 * cost_[k])
      best = k - 1;
    else if (k == 1 || cost_[k] < 0.9 * cost_[k - 1])
      best = std::min(k + 1, last - 1);
    if (std::exchange(rejected_, false)) {
      target_ = std::max(std::min(best, k), std::size_t{1});
      return {true, std::min(h, step_[target_])};
    }
    target_ = std::max(best, std::size_t{2});
    return {true, best <= k ? step_[best] : step_[k] * work_[best] / work_[k]};
  }

  double difference(std::size_t j) const {
    double sum = 0;
    const State<P>&a = table_.column(j), &b = table_.column(j - 1);
    each_component(a, [&](std::size_t n) {
      const double scaled = (a[n] - b[n]) * scale_[n];
      sum += scaled * scaled;
    });
    return std::sqrt(sum / static_cast<double>(a.size()));
  }

  const P& problem_;
  ExtrapolatedEulerTable<P> table_;
  State<P> scale_;
  ErrorScale<State<P>> error_scale_;
  InnerNodes<State<P>> nodes_;
  std::size_t target_ = 2, used_ = 0;  ///< columns, from 0
  bool first_ = true, rejected_ = false, moved_ = true;
  std::array<double, columns> work_{}, step_{}, cost_{};
};

}  // namespace odeum
