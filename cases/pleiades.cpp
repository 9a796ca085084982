// SPDX-License-Identifier: BSD-3-Clause
#include "problems/pleiades.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/set_problem.hpp"

namespace odeum::cases {
namespace {

Case make_pleiades() {
  Case c;
  c.equation = "r_i'' = sum over j of m_j (r_j - r_i) / |r_j - r_i|^3, seven stars in a plane";
  c.source = "Hairer, Norsett, Wanner, Solving ODEs I, (II.10.3)";
  c.y0 = {3, 3, -1, -3, 2, -2,   2,    3, -3, 2, 0,     0, -4, 4,
          0, 0, 0,  0,  0, 1.75, -1.5, 0, 0,  0, -1.25, 1, 0,  0};
  c.stops = {1, 2, 3};
  for (std::size_t i = 0; i < 14; ++i) c.measured.push_back(i);  // positions
  c.settings.steps_multiple = 3;
  c.settings.coarsest_steps = 384;
  c.settings.finest_steps = 3072;
  c.settings.evaluation_budget = 12'000;
  c.settings.orders_to_first_stop = true;
  c.truth = reference_truth("pleiades", 1e-25);
  c.invariants = {{"angular_momentum", [](const double* y) {
                     double sum = 0;
                     for (std::size_t i = 0; i < 7; ++i)
                       sum += Pleiades::mass(i) * (y[i] * y[21 + i] - y[7 + i] * y[14 + i]);
                     return sum;
                   }}};
  set_problem(c, Pleiades{});
  return c;
}

}  // namespace

/// A planar problem of seven bodies with close encounters, all of them after the first stop.
std::vector<Statement> pleiades() {
  return {{.id = "pleiades",
           .title = "Pleiades",
           .tags = {"second_order", "separable", "celestial"},
           .make = make_pleiades}};
}

}  // namespace odeum::cases
