// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "odeum/control/adaptive.hpp"
#include "odeum/kernel/extrapolation.hpp"
#include "odeum/kernel/inner_nodes.hpp"
#include "odeum/kernel/quick_power.hpp"

namespace odeum {

/// Order and step control of an extrapolation table (Hairer, Norsett, Wanner, Solving ODEs I,
/// II.9): the wanted line k is where the work per unit step W_k = A_k / H_k is least. A step is
/// accepted at line k - 1, k or k + 1; two monitors reject it early where convergence by then
/// cannot be expected. Lines are counted from 0 here, so that line k has order 2 (k + 1).
template <int Lines>
class OrderAndStepControl {
 public:
  explicit OrderAndStepControl(double tolerance)
      : wanted_(within(static_cast<int>(0.5 - 0.6 * std::log10(tolerance)))) {}
  int wanted() const { return wanted_; }

  /// Goes through the lines from 1 on: `error_of(line)` computes one and returns its scaled error.
  /// Afterwards `line()` is the last one computed. The errors of lines well before the wanted one
  /// decide nothing and are ignored.
  template <class ErrorOf>
  Decision attempt(double h, ErrorOf&& error_of) {
    for (line_ = 1;; ++line_) {
      double error = error_of(line_);
      if (!std::isfinite(error)) return {false, h / 4};
      if (!looks_at(line_)) continue;
      error = error_[at(line_)] = bounded_below(error);
      // The error of line j goes as h^(2 j + 1); (9.16) and the bounds of ODEX.
      const double least = least_factor[at(line_)];
      const double factor = 0.94 * quick_power(0.65 / std::max(error, 1e-16), 1. / (2 * line_ + 1));
      step_[at(line_)] = h * std::clamp(factor, least / 4, 1 / least);
      if (line_ < wanted_ - 1) continue;
      if (error <= 1) return accept(h);
      if (line_ == wanted_ + 1 || error > monitor()) return reject();
    }
  }
  int line() const { return line_; }
  bool looks_at(int line) const { return line >= wanted_ - 3; }

 private:
  static constexpr std::size_t at(int line) { return static_cast<std::size_t>(line); }
  /// An estimate may pass through zero. It is taken to fall by at most ten times what it fell by
  /// from the line before the last to the last one: where lines converge that leaves it as it is.
  double bounded_below(double error) const {
    if (line_ < 3 || !looks_at(line_ - 2)) return error;
    const double last = error_[at(line_ - 1)], before = error_[at(line_ - 2)];
    return std::max(error, 0.1 * last * std::min(1.0, last / before));
  }
  static int within(int line) { return std::clamp(line, 2, Lines - 2); }
  /// W_j < 0.9 W_k. Line 0 has no error estimate.
  bool cheaper(int j, int k) const {
    return j >= 1 && work[at(j)] / step_[at(j)] < 0.9 * work[at(k)] / step_[at(k)];
  }
  /// A larger error is not brought below 1 by the lines up to k + 1, each of which divides it by
  /// about (n_j / n_0)^2.
  double monitor() const {
    double product = 1;
    for (int j = line_ + 1; j <= wanted_ + 1; ++j) product *= (j + 1) * (j + 1);
    return product;
  }
  /// The line to want next, after the last one computed was accepted or the step given up at it.
  int next_wanted() const {
    const int k = wanted_;
    if (line_ < k) return cheaper(line_, line_ - 1) || line_ == 1 ? k : line_;
    if (line_ == k) return cheaper(k - 1, k) ? k - 1 : cheaper(k, k - 1) ? k + 1 : k;
    const int best = cheaper(k - 1, k) ? k - 1 : k;
    return cheaper(k + 1, best) ? k + 1 : best;
  }
  double step_for(int line) const {
    return line <= line_ ? step_[at(line)] : step_[at(line_)] * work[at(line)] / work[at(line_)];
  }
  Decision accept(double h) {
    // After a rejected step neither order nor step grows.
    const int next = within(rejected_ ? std::min(next_wanted(), wanted_) : next_wanted());
    const double step = rejected_ ? std::min(h, step_for(next)) : step_for(next);
    wanted_ = next;
    rejected_ = false;
    return {true, step};
  }
  Decision reject() {
    wanted_ = within(std::min({next_wanted(), wanted_, line_}));
    rejected_ = true;
    return {false, step_for(wanted_)};
  }

  int wanted_, line_ = 0;
  /// Evaluations up to each line.
  static constexpr std::array<double, Lines> work = [] {
    std::array<double, Lines> sum{1.0 + extrapolation_substeps(0)};
    for (int j = 1; j < Lines; ++j) sum[at(j)] = sum[at(j - 1)] + extrapolation_substeps(j);
    return sum;
  }();
  inline static const std::array<double, Lines> least_factor = [] {
    std::array<double, Lines> least{};
    for (int j = 0; j < Lines; ++j) least[at(j)] = std::pow(0.02, 1. / (2 * j + 1));
    return least;
  }();
  std::array<double, Lines> step_{}, error_{};
  bool rejected_ = false;
};

/// Trial steps of the extrapolated midpoint rule.
template <Ode P>
class ExtrapolationTrial {
 public:
  ExtrapolationTrial(const P& problem, const Tolerance& tolerance)
      : problem_(problem),
        table_(problem),
        control_(tolerance.relative),
        difference_(make_state(problem)),
        scale_(tolerance, difference_) {}
  int order() const { return 2 * control_.wanted(); }

  Decision operator()(double t, double h, const State<P>& y, State<P>& y_new) {
    if (repeated_)
      table_.begin_again(h, control_.wanted());
    else
      table_.begin(t, h, y, control_.wanted());
    table_.add_line(0);
    const Decision decision = control_.attempt(h, [&](int line) {
      if (problem_.tripped()) return std::numeric_limits<double>::infinity();
      if (!control_.looks_at(line)) {
        table_.add_line(line);
        return 0.0;
      }
      table_.add_line(line, &difference_);
      table_.result(line, y_new);
      return scaled_error_norm(difference_, y, y_new, scale_);
    });
    table_.result(control_.line(), y_new);
    repeated_ = !decision.accept;
    return decision;
  }
  /// Hermite's interpolation with steps aside to its nodes, of as many lines as the step made,
  /// whose order is twice their number.
  Status between(const StepMade<State<P>>& step, double time, State<P>& y) {
    if (!nodes_.hold(step.t, step.h)) fill_nodes(step);
    nodes_.by_slopes(step.share(time), y);
    return Status::ok;
  }

 private:
  void fill_nodes(const StepMade<State<P>>& step) {
    const int used = control_.line() + 1;
    nodes_.begin(step.t, step.h, used - 2, step.before);
    const std::size_t end = nodes_.size() - 1;
    nodes_.state(0) = step.before;
    nodes_.state(end) = step.after;
    table_.begin(step.t, nodes_.share(1) * step.h, step.before, used);
    nodes_.slope(0) = table_.slope();
    for (std::size_t k = 1; k < end; ++k) {
      if (k > 1) table_.begin_again(nodes_.share(k) * step.h, used);
      for (int line = 0; line < used; ++line) table_.add_line(line);
      table_.result(used - 1, nodes_.state(k));
    }
    for (std::size_t k = 1; k <= end; ++k)
      problem_.rhs(step.t + nodes_.share(k) * step.h, nodes_.state(k).data(),
                   nodes_.slope(k).data());
    nodes_.filled();
  }

  static constexpr int lines = 10;  // up to order 20
  const P& problem_;
  ExtrapolationTable<P, lines> table_;
  OrderAndStepControl<lines> control_;
  State<P> difference_;
  ErrorScale<State<P>> scale_;
  InnerNodes<State<P>> nodes_;
  bool repeated_ = false;
};

}  // namespace odeum
