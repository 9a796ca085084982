// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>

#include "odeum/problem/concepts.hpp"

/// Extrapolation of Gragg's modified midpoint rule (Hairer, Norsett, Wanner, Solving ODEs I, II.9).
namespace odeum {

/// Substeps of line j (from 0): 2, 4, 6, ...; the harmonic sequence doubled.
constexpr int extrapolation_substeps(int line) { return 2 * (line + 1); }

/// What the entry (j, k) of the extrapolation table adds to T_{j,k-1}: the difference to the entry
/// above, over (n_j / n_{j-k})^2 - 1.
constexpr double extrapolation_weight(int line, int column) {
  const double ratio =
      static_cast<double>(extrapolation_substeps(line)) / extrapolation_substeps(line - column);
  return 1 / (ratio * ratio - 1);
}

/// The extrapolation table of one step of length h, line by line. With f = f(t, y) given to
/// begin(), line j costs n_j evaluations and its last entry has order 2 (j + 1).
template <class P, int Lines>
class ExtrapolationTable {
 public:
  explicit ExtrapolationTable(const P& problem) : problem_(problem), f0_(make_state(problem)) {
    before_ = now_ = f_ = y0_ = f0_;
    table_.fill(f0_);
  }

  void begin(double t, double h, const State<P>& y) {
    t_ = t;
    h_ = h;
    y0_ = y;
    problem_.rhs(t, y.data(), f0_.data());
  }
  /// The same start with another length.
  void begin_again(double h) { h_ = h; }

  /// Computes line j; `difference`, if not null, becomes T_{j,j} - T_{j,j-1}.
  void add_line(int line, State<P>* difference = nullptr) {
    midpoint_rule(extrapolation_substeps(line));
    // table_[k] holds T_{line-1,k}; the line moves through it from the left.
    for (int k = 0; k < line; ++k) {
      State<P>& above = table_[static_cast<std::size_t>(k)];
      const double weight = extrapolation_weight(line, k + 1);
      for (std::size_t i = 0; i < now_.size(); ++i) {
        const double left = now_[i], step = weight * (left - above[i]);
        above[i] = left;
        now_[i] = left + step;
        if (difference && k + 1 == line) (*difference)[i] = step;
      }
    }
    table_[static_cast<std::size_t>(line)] = now_;
  }
  const State<P>& best(int line) const { return table_[static_cast<std::size_t>(line)]; }

 private:
  // Gragg's rule with its smoothing at the end: (y_{n-1} + 2 y_n + y_{n+1}) / 4, into now_.
  void midpoint_rule(int n) {
    const double h = h_ / n;
    before_ = y0_;
    for (std::size_t i = 0; i < now_.size(); ++i) now_[i] = y0_[i] + h * f0_[i];
    for (int k = 1; k < n; ++k) {
      problem_.rhs(t_ + k * h, now_.data(), f_.data());
      for (std::size_t i = 0; i < now_.size(); ++i) {
        const double next = before_[i] + 2 * h * f_[i];
        before_[i] = now_[i];
        now_[i] = next;
      }
    }
    problem_.rhs(t_ + h_, now_.data(), f_.data());
    for (std::size_t i = 0; i < now_.size(); ++i) now_[i] = (before_[i] + now_[i] + h * f_[i]) / 2;
  }

  const P& problem_;
  double t_ = 0, h_ = 0;
  State<P> f0_, y0_, before_, now_, f_;
  std::array<State<P>, Lines> table_;
};

/// The stability function of the last entry of line `lines - 1`.
template <int Lines>
std::complex<double> extrapolated_midpoint_stability(std::complex<double> z) {
  std::array<std::complex<double>, Lines> table{};
  for (int line = 0; line < Lines; ++line) {
    const int n = extrapolation_substeps(line);
    const std::complex<double> hz = z / static_cast<double>(n);
    std::complex<double> before = 1, now = 1.0 + hz;
    for (int k = 1; k < n; ++k) {
      const std::complex<double> next = before + 2.0 * hz * now;
      before = now;
      now = next;
    }
    now = (before + now + hz * now) / 2.0;
    for (int k = 0; k < line; ++k) {
      const std::complex<double> above = table[static_cast<std::size_t>(k)];
      table[static_cast<std::size_t>(k)] = now;
      now += extrapolation_weight(line, k + 1) * (now - above);
    }
    table[static_cast<std::size_t>(line)] = now;
  }
  return table[Lines - 1];
}

}  // namespace odeum
