// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <limits>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/set_problem.hpp"

namespace odeum::cases {
namespace {

/// y' = y^2.
struct BlowUp {
  static constexpr std::size_t dimension = 1;
  template <class R>
  void rhs(R, const R* y, R* dydt) const {
    dydt[0] = y[0] * y[0];
  }
  void jacobian(double, const double* y, double* j) const { j[0] = 2 * y[0]; }
};

Case make_case(const Values& values) {
  const double start = values[0];
  require_positive("y0", start);
  Case c;
  c.equation = fmt::format(
      "y' = y^2, y(0) = y0: y = y0 / (1 - y0 t) for t < 1 / y0, and no solution from there on; y0 "
      "= {}",
      start);
  c.source = "by separation of variables";
  c.y0 = {start};
  c.components = {"y"};
  c.stops = {0.5, 2};
  c.settings.steps_multiple = 4;
  c.truth.source = "closed form";
  c.truth.closed_form = true;
  c.truth.at = [start](double t, double* y) {
    y[0] = start * t < 1 ? start / (1 - start * t) : std::numeric_limits<double>::infinity();
    return true;
  };
  set_problem(c, BlowUp{});
  return c;
}

}  // namespace

/// A solution that ends at a pole, t = 1, within the interval: a solver that reports success at the
/// end has stepped over it, to the other branch of 1 / (1 - t).
std::vector<Statement> blow_up() {
  return {{.id = "blow_up", .title = "Solution that ends at a pole", .tags = {"ends"}, .make = [] {
             return with_parameters({{"y0", 1, "at the start"}}, make_case);
           }}};
}

}  // namespace odeum::cases
