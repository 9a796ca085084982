// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/reference.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/cases/square_cloth.hpp"
#include "odeum/scene/problem/scene_problem.hpp"

namespace odeum::cases {
namespace {

struct Variant {
  const char* id;
  const char* reference;
  const char* title;
  double stiffness;
  bool tension_only;
  double
      floor;  ///< absolute error of the reference, from the digits stated in its index or program
  std::uint64_t coarsest_steps;

  // Smooth means that methods of every order converge visibly within the budget. The stiff cloth
  // is smooth too, but its fast modes would need h < 1e-5 s of low orders, up to t = 2 s.
  bool smooth() const { return !tension_only && stiffness <= 100; }
};

Case make_variant(const Variant& variant) {
  constexpr std::size_t n = 11;
  const auto scene = std::make_shared<const scene::Scene>(
      square_cloth(n, variant.stiffness, variant.tension_only));
  Case c;
  c.equation =
      "m x_a'' = sum of k (l - L) u + d (v_b - v_a) over springs, + m g; 11 x 11 particles, k = " +
      std::to_string(static_cast<int>(variant.stiffness)) + ", d = 0.05";
  c.source = "mass-spring cloth with structural, shear and bend springs, Provot 1995";
  c.y0 = scene::start_of(*scene);
  for (std::size_t i = 0; i < 3 * n * n; ++i) c.measured.push_back(i);  // positions
  c.stops = {0.25, 0.5, 1, 2};
  c.nature.smooth = variant.smooth();
  c.nature.stiff = !variant.tension_only && !variant.smooth();
  if (variant.tension_only) c.nature.highest_order = scene::order_at_kinks;
  c.settings.orders_to_first_stop = !variant.smooth();
  c.settings.orders_in_full = true;
  c.settings.steps_multiple = 8;
  c.settings.coarsest_steps = variant.coarsest_steps;
  c.settings.finest_steps = (variant.smooth() ? 16 : 8) * variant.coarsest_steps;
  // Half a second per solve or less, and enough for most methods to show their order; the study of
  // convergence runs the stiff and the tension-only cloth to the first stop alone.
  c.settings.evaluation_budget = variant.tension_only      ? 32'000
                                 : variant.stiffness > 100 ? 120'000
                                                           : 100'000;
  c.truth = reference_truth(variant.reference, variant.floor);
  if (variant.smooth()) {
    // A spring of the moving middle is shortest at t = 0.005 s, where its length has branch points
    // 0.007 s off the real axis: order 9 is reached only at steps whose errors are below 1e-15.
    ExtendedProblem extended = scene::extended_problem(*scene);
    extended.truth = extended_truth(variant.reference);
    extended.floor = 1e-20;  // the digits of the file
    c.extended = std::make_shared<const ExtendedProblem>(std::move(extended));
  }
  set_problem(c, scene::SceneProblem(*scene), scene);
  return c;
}

Statement state(const Variant& variant) {
  return {.id = variant.id,
          .title = variant.title,
          .tags = {"second_order", "mechanical", "cloth"},
          .make = [variant] { return make_variant(variant); }};
}

}  // namespace

/// A cloth fixed along one edge whose middle has an initial velocity: two-way springs, tension-only
/// springs (a force with a kink), and springs a hundred times stiffer.
std::vector<Statement> cloth() {
  return {state({"cloth11_two_way", "cloth11_two_way_long", "Cloth", 10, false, 4e-17, 160}),
          state({"cloth11_tension_only", "cloth11_tension_only_long",
                 "Cloth of tension-only springs", 10, true, 1e-12, 160}),
          state({"cloth11_two_way_k1e3", "cloth11_two_way_k1e3", "Stiff cloth", 1000, false, 1e-11,
                 1600})};
}

}  // namespace odeum::cases
