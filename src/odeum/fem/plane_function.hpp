// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "odeum/fem/triangle_mesh.hpp"
#include "odeum/formula/evaluator.hpp"

namespace odeum::fem {

/// A function of x and y from an expression.
class PlaneFunction {
 public:
  /// Throws formula::ExpressionError.
  explicit PlaneFunction(const std::string& text);
  double operator()(Point p) const { return values(p)[0]; }
  Point gradient(Point p) const {
    const auto all = values(p);
    return {all[1], all[2]};
  }

 private:
  std::array<double, 3> values(Point p) const;
  std::shared_ptr<const formula::Evaluator<double>> evaluate_;
};

}  // namespace odeum::fem
