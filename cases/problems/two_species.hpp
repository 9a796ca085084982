// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/problem/concepts.hpp"

namespace odeum::cases {

/// Two species in a row of cells, y = (u_1, v_1, u_2, v_2, ...), each coupled with the other in its
/// cell and with itself in the neighbouring cells: what cases with reaction and diffusion share.
/// `Cells` has `cells`, and for cell i, from 0,
///
///     cell(i, u_left, v_left, u, v, u_right, v_right, f)    fills f[0] = u', f[1] = v'
///     u_before(), v_before(), u_after(u_last), v_after(v_last)    beyond the ends
///     slopes(i, u, v, s)    fills s with d u' / d (u_left, u, v, u_right), then d v' / d (v_left,
///                           u, v, v_right); of the last cell those with u_after, v_after.
template <class Cells>
struct TwoSpecies : Cells {
  static constexpr std::size_t dimension = dynamic;

  explicit TwoSpecies(Cells given) : Cells(std::move(given)) {
    const auto n = static_cast<int>(size());
    for (int row_number = 0; row_number < n; ++row_number) {
      const int first = row_number - row_number % 2;
      std::vector<int> row{first, first + 1};
      if (row_number >= 2) row.push_back(row_number - 2);
      if (row_number + 2 < n) row.push_back(row_number + 2);
      pattern_.add_row(row);
    }
  }
  std::size_t size() const { return 2 * Cells::cells; }

  void rhs(double, const double* y, double* f) const {
    const std::size_t last = Cells::cells - 1;
    if (last == 0)
      return Cells::cell(0, Cells::u_before(), Cells::v_before(), y[0], y[1], Cells::u_after(y[0]),
                         Cells::v_after(y[1]), f);
    Cells::cell(0, Cells::u_before(), Cells::v_before(), y[0], y[1], y[2], y[3], f);
    for (std::size_t i = 1; i < last; ++i) {
      const double* const at = y + 2 * i;
      Cells::cell(i, at[-2], at[-1], at[0], at[1], at[2], at[3], f + 2 * i);
    }
    const double* const at = y + 2 * last;
    Cells::cell(last, at[-2], at[-1], at[0], at[1], Cells::u_after(at[0]), Cells::v_after(at[1]),
                f + 2 * last);
  }

  const Sparsity* sparsity() const { return &pattern_; }
  void jacobian_entries(double, const double* y, double* values) const {
    double s[8];
    for (std::size_t i = 0; i < Cells::cells; ++i) {
      Cells::slopes(i, y[2 * i], y[2 * i + 1], s);
      const bool first = i == 0, last = i + 1 == Cells::cells;
      if (!first) *values++ = s[0];
      *values++ = s[1];
      *values++ = s[2];
      if (!last) *values++ = s[3];
      if (!first) *values++ = s[4];
      *values++ = s[5];
      *values++ = s[6];
      if (!last) *values++ = s[7];
    }
  }

 private:
  Sparsity pattern_;
};

/// The Brusselator with diffusion: u' = 1 + u^2 v - 4 u + c (u_left - 2 u + u_right), v' = 3 u -
/// u^2 v + c (v_left - 2 v + v_right), u = 1 and v = 3 at both ends of the unit interval.
struct BrusselatorCells {
  std::size_t cells;
  double c;  ///< of diffusion, over the square of the distance of cells
  BrusselatorCells(std::size_t n, double diffusion)
      : cells(n), c(diffusion * static_cast<double>((n + 1) * (n + 1))) {}

  static double u_before() { return 1; }
  static double v_before() { return 3; }
  static double u_after(double) { return 1; }
  static double v_after(double) { return 3; }
  void cell(std::size_t, double u_left, double v_left, double u, double v, double u_right,
            double v_right, double* f) const {
    const double reaction = u * u * v;
    f[0] = 1 + reaction - 4 * u + c * (u_left - 2 * u + u_right);
    f[1] = 3 * u - reaction + c * (v_left - 2 * v + v_right);
  }
  void slopes(std::size_t, double u, double v, double* s) const {
    s[0] = s[3] = s[4] = s[7] = c;
    s[1] = 2 * u * v - 4 - 2 * c;
    s[2] = u * u;
    s[5] = 3 - 2 * u * v;
    s[6] = -u * u - 2 * c;
  }
};
using Brusselator1d = TwoSpecies<BrusselatorCells>;
inline Brusselator1d brusselator_1d_problem(std::size_t cells) {
  return Brusselator1d(BrusselatorCells(cells, 0.02));
}
std::vector<double> brusselator_1d_start(std::size_t cells);

}  // namespace odeum::cases
