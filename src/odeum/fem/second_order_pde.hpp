// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "odeum/formula/evaluator.hpp"

/// The type of a linear partial differential equation of second order in two variables,
/// a u_xx + b u_xy + c u_yy + d u_x + e u_y + ... = 0 (Courant and Hilbert, Methods of Mathematical
/// Physics II, chapter III).
namespace odeum::fem {

enum class PdeType {
  elliptic,
  parabolic,
  hyperbolic,
  first_order,  ///< a, b and c are 0
  undefined     ///< a coefficient is not finite
};
const char* to_string(PdeType type);

/// What the coefficients say at one point.
struct PdePoint {
  PdeType type = PdeType::undefined;
  long double a = 0, b = 0, c = 0;
  long double discriminant = 0;  ///< b^2 - 4 a c
  /// Directions (dx, dy) of length 1 with a dy^2 - b dx dy + c dx^2 = 0: two where hyperbolic, one
  /// where parabolic.
  std::vector<std::array<double, 2>> characteristics = {};
  /// Parabolic, and no first derivative along the characteristic: an ordinary differential
  /// equation on every line across it.
  bool degenerate = false;
};

/// A rectangle that is sampled in its corners, on its edges and inside.
struct PdeRegion {
  double x0 = -1, x1 = 1, y0 = -1, y1 = 1;
};

class SecondOrderPde {
 public:
  /// `text`: an equation or an expression that is 0, in u_xx, u_xy, u_yy, u_x, u_y, u, x and y, or
  /// with t in place of y: `u_tt = 4*u_xx`. Throws formula::ExpressionError, with the place in the
  /// text, for what is not understood, for what is not linear in the second derivatives, and where
  /// their coefficients depend on u: then the type depends on the solution.
  explicit SecondOrderPde(const std::string& text);
  /// a u_xx + b u_xy + c u_yy from three expressions.
  SecondOrderPde(const std::string& a, const std::string& b, const std::string& c);

  PdePoint at(double x, double y) const;
  /// The name of the second variable: y or t.
  const std::string& second() const { return second_; }
  /// Whether a, b and c are constants.
  bool constant() const { return constant_; }

 private:
  void prepare(formula::Graph& graph, const std::vector<formula::Id>& coefficients);
  std::shared_ptr<const formula::Evaluator<long double>> evaluate_;
  std::string second_ = "y";
  bool constant_ = false, lower_known_ = false;
};

/// The types over a region, at the nodes of a grid of `divisions` intervals each way.
struct PdeMap {
  PdeRegion region;
  std::size_t divisions = 0;
  std::vector<PdePoint> points;  ///< row by row from y0, divisions + 1 to a row
  /// Points where the discriminant changes its sign, on the lines of the grid, to rounding.
  std::vector<std::array<double, 2>> changes;

  const PdePoint& point(std::size_t i, std::size_t j) const {
    return points[j * (divisions + 1) + i];
  }
  std::array<double, 2> place(std::size_t i, std::size_t j) const;
  double share(PdeType type) const;  ///< of the points
};
/// Throws std::invalid_argument for a region that is empty or not finite, or no division.
PdeMap map_types(const SecondOrderPde& pde, const PdeRegion& region, std::size_t divisions);

}  // namespace odeum::fem
