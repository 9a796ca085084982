// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>

#include "odeum/kernel/components.hpp"
#include "odeum/problem/concepts.hpp"
#include "odeum/tableau/extrapolation_coefficients.hpp"

/// Extrapolation of Gragg's modified midpoint rule (Hairer, Norsett, Wanner, Solving ODEs I, II.9).
namespace odeum {

/// The extrapolation table of one step of length h, line by line. With f = f(t, y) given to
/// begin(), line j costs n_j evaluations and its last entry has order 2 (j + 1).
///
/// The evaluations of a line depend on each other, those of different lines do not: lines that are
/// certain to be needed are computed side by side, so that the processor overlaps their latencies.
///
/// Increments relative to y are summed and extrapolated, not states: the weights of the table then
/// amplify the rounding of numbers of size h, and a step rounds y once.
template <class P, int Lines>
class ExtrapolationTable {
 public:
  explicit ExtrapolationTable(const P& problem)
      : problem_(problem), f0_(make_state(problem)), y0_(f0_), f_(f0_) {
    for (auto* states : {&before_, &now_, &argument_, &table_}) states->fill(f0_);
  }

  /// A step from (t, y); the first `sure` lines are certain to be needed.
  void begin(double t, double h, const State<P>& y, int sure) {
    t_ = t;
    y0_ = y;
    problem_.rhs(t, y.data(), f0_.data());
    begin_again(h, sure);
  }
  /// The same start with another length.
  void begin_again(double h, int sure) {
    h_ = h;
    midpoint_rule(0, sure - 1);
    computed_ = sure;
  }

  /// Adds line j, after line j - 1; `difference`, if not null, becomes T_{j,j} - T_{j,j-1}.
  void add_line(int line, State<P>* difference = nullptr) {
    if (line >= computed_) midpoint_rule(line, line);
    State<P>& now = now_[static_cast<std::size_t>(line)];
    // table_[k] holds T_{line-1,k}; the new line overwrites it from the left.
    for (int k = 0; k < line; ++k) {
      State<P>& above = table_[static_cast<std::size_t>(k)];
      const double weight = weights[static_cast<std::size_t>(line)][static_cast<std::size_t>(k)];
      each_component(now, [&](std::size_t i) {
        const double left = now[i], step = weight * (left - above[i]);
        above[i] = left;
        now[i] = left + step;
        if (difference && k + 1 == line) (*difference)[i] = step;
      });
    }
    table_[static_cast<std::size_t>(line)] = now;
  }
  /// f(t, y) of begin().
  const State<P>& slope() const { return f0_; }
  /// The new state by the last entry of `line`.
  void result(int line, State<P>& y) const {
    const State<P>& increment = table_[static_cast<std::size_t>(line)];
    each_component(y, [&](std::size_t i) { y[i] = y0_[i] + increment[i]; });
  }

 private:
  // Gragg's rule for lines first, ..., last side by side, into now_.
  void midpoint_rule(int first, int last) {
    for (int line = first; line <= last; ++line) {
      State<P>& now = now_[static_cast<std::size_t>(line)];
      const double h = h_ / extrapolation_substeps(line);
      State<P>&before = before_[static_cast<std::size_t>(line)],
      &argument = argument_[static_cast<std::size_t>(line)];
      each_component(now, [&](std::size_t i) {
        before[i] = 0;
        now[i] = h * f0_[i];
        argument[i] = y0_[i] + h * f0_[i];
      });
    }
    for (int k = 1; k <= extrapolation_substeps(last); ++k)
      for (int line = last; line >= first && extrapolation_substeps(line) >= k; --line)
        substep(line, k);
  }

  // The last one is the smoothing: (y_{n-1} + 2 y_n + y_{n+1}) / 4.
  void substep(int line, int k) {
    State<P>&before = before_[static_cast<std::size_t>(line)],
    &now = now_[static_cast<std::size_t>(line)],
    &argument = argument_[static_cast<std::size_t>(line)];
    const int n = extrapolation_substeps(line);
    const double h = h_ / n;
    problem_.rhs(t_ + k * h, argument.data(), f_.data());
    if (k == n) {
      each_component(now, [&](std::size_t i) { now[i] = (before[i] + now[i] + h * f_[i]) / 2; });
      return;
    }
    each_component(now, [&](std::size_t i) {
      // y + next, with one multiply-add between this evaluation and the next.
      argument[i] = (y0_[i] + before[i]) + 2 * h * f_[i];
      const double next = before[i] + 2 * h * f_[i];
      before[i] = now[i];
      now[i] = next;
    });
  }

  static constexpr auto weights = [] {
    std::array<std::array<double, Lines>, Lines> w{};
    for (int line = 0; line < Lines; ++line)
      for (int k = 0; k < line; ++k)
        w[static_cast<std::size_t>(line)][static_cast<std::size_t>(k)] =
            extrapolation_weight(line, k + 1);
    return w;
  }();

  const P& problem_;
  double t_ = 0, h_ = 0;
  int computed_ = 0;  ///< lines whose midpoint rule has been computed (in now_)
  State<P> f0_, y0_, f_;
  std::array<State<P>, Lines> before_, now_, argument_, table_;
};

}  // namespace odeum
