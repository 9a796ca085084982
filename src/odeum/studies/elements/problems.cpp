// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/elements/problems.hpp"

#include <cmath>
#include <numbers>

#include "odeum/fem/shapes.hpp"

namespace odeum::study {
namespace {

using fem::Point;
using std::numbers::pi;

constexpr const char* smooth = "smooth solution: the best orders of linear elements";

std::vector<ModelProblem::Claim> smooth_claims() {
  return {{"l2", 2, smooth}, {"h1", 1, smooth}, {"max", 2, smooth}};
}
/// Theory gives h^2 |log h| for the largest error (Scott 1976), and the logarithm is there on some
/// meshes (Haverkamp 1984): where two edges without Dirichlet condition meet in a corner, the error
/// over h^2 rises by the same amount with every halving of h. A claim of 2 alone would not hold.
std::vector<ModelProblem::Claim> smooth_claims_with_logarithm() {
  return {
      {"l2", 2, smooth},
      {"h1", 1, smooth},
      {"max_by_log", 2, "the largest error goes as h^2 |log h|: here it is divided by |log h|"}};
}

/// f = 1, u = 0 on the boundary: the middle has u = 0.0736713532815, by the series in products of
/// sines (Timoshenko and Goodier, Theory of Elasticity, section 109, for torsion).
ModelProblem unit_load() {
  return {.id = "poisson_square_unit_load",
          .title = "Unit load on the unit square",
          .equation = "-div grad u = 1, u = 0 on the boundary",
          .truth = "series of sines, Timoshenko and Goodier, Theory of Elasticity, section 109",
          .problem = {.load = [](Point) { return 1.; }},
          .scale = 0.0737,
          .centre_value = 0.0736713532815138,
          .coarsest = fem::unit_square(2),
          .claims = {{"centre", 2, "the solution is smooth in the middle"}}};
}

/// Dirichlet on two edges, Neumann on the other two, a tensor that varies, an unstructured mesh.
ModelProblem mixed() {
  const auto tensor = [](Point p) { return fem::Tensor{1 + p.x, 0.3, 1 + p.y * p.y}; };
  const auto value = [](Point p) { return std::exp(p.x) * std::cos(2 * p.y); };
  const auto gradient = [](Point p) {
    return Point{std::exp(p.x) * std::cos(2 * p.y), -2 * std::exp(p.x) * std::sin(2 * p.y)};
  };
  const auto load = [](Point p) {
    const double c = std::exp(p.x) * std::cos(2 * p.y), s = std::exp(p.x) * std::sin(2 * p.y);
    // div(a grad u) = u_x + (1 + x) u_xx + 0.6 u_xy + 2 y u_y + (1 + y^2) u_yy
    return -(c + (1 + p.x) * c - 1.2 * s - 4 * p.y * s - 4 * (1 + p.y * p.y) * c);
  };
  const auto flux = [=](Point p, Point normal) {
    const fem::Tensor a = tensor(p);
    const Point g = gradient(p);
    return normal.x * (a.xx * g.x + a.xy * g.y) + normal.y * (a.xy * g.x + a.yy * g.y);
  };
  return {.id = "poisson_unstructured_mixed",
          .title = "Varying tensor, two edges with a flux, an unstructured mesh",
          .equation = "-div(a grad u) = f, a = [[1 + x, 0.3], [0.3, 1 + y^2]]",
          .truth = "closed form: exp(x) cos(2 y)",
          .problem = {.load = load,
                      .diffusion = tensor,
                      .is_dirichlet = [](Point p) { return p.x == 0 || p.y == 0; },
                      .boundary_value = value,
                      .flux = flux},
          .value = value,
          .gradient = gradient,
          .scale = std::numbers::e,
          .coarsest = fem::unstructured_square(4, 16),
          .divisions = 4,
          .claims = smooth_claims_with_logarithm(),
          .pictured = true};
}

/// No Dirichlet condition: the solution of mean 0.
ModelProblem neumann() {
  const auto load = [](Point p) {
    return 5 * pi * pi * std::cos(pi * p.x) * std::cos(2 * pi * p.y);
  };
  const auto value = [](Point p) { return std::cos(pi * p.x) * std::cos(2 * pi * p.y); };
  const auto gradient = [](Point p) {
    return Point{-pi * std::sin(pi * p.x) * std::cos(2 * pi * p.y),
                 -2 * pi * std::cos(pi * p.x) * std::sin(2 * pi * p.y)};
  };
  return {.id = "poisson_square_neumann",
          .title = "A flux of 0 on the whole boundary",
          .equation = "-div grad u = 5 pi^2 cos(pi x) cos(2 pi y), mean of u is 0",
          .truth = "closed form: cos(pi x) cos(2 pi y)",
          .problem = {.load = load, .is_dirichlet = [](Point) { return false; }},
          .value = value,
          .gradient = gradient,
          .coarsest = fem::unit_square(2),
          .undetermined = fem::Undetermined::mean_zero,
          .claims = smooth_claims_with_logarithm()};
}

/// u = r^(2/3) sin(2/3 theta), theta from the edge y = 0: harmonic, its gradient infinite at the
/// reentrant corner (Braess, Finite Elements, II.7).
ModelProblem corner() {
  const auto angle = [](Point p) {
    const double theta = std::atan2(p.y, p.x);
    return theta < 0 ? theta + 2 * pi : theta;
  };
  const auto value = [=](Point p) {
    return std::cbrt(p.x * p.x + p.y * p.y) * std::sin(2. / 3 * angle(p));
  };
  const std::string theory =
      "reentrant corner of 3/2 pi: u goes as r^(2/3) and is in H^s for s < 5/3 only";
  return {.id = "poisson_l_shape",
          .title = "Reentrant corner",
          .equation = "-div grad u = 0 on the L shape",
          .truth = "closed form: r^(2/3) sin(2/3 theta), Braess, Finite Elements, II.7",
          .problem = {.load = [](Point) { return 0.; }, .boundary_value = value},
          .value = value,
          .gradient =
              [=](Point p) {
                // Perpendicular to the level lines: the angle of the gradient is pi/2 - theta/3.
                const double size = 2. / 3 * std::pow(std::hypot(p.x, p.y), -1. / 3);
                return Point{-size * std::sin(angle(p) / 3), size * std::cos(angle(p) / 3)};
              },
          .coarsest = fem::l_shape(2),
          .claims = {{"l2", 4. / 3, theory + "; smooth: 2"},
                     {"h1", 2. / 3, theory + "; smooth: 1"},
                     {"max", 2. / 3, theory + "; smooth: 2"}},
          .pictured = true};
}

ModelProblem disc(bool follows_circle) {
  const auto gradient = [](Point p) { return Point{-2 * p.x, -2 * p.y}; };
  ModelProblem model{.id = follows_circle ? "poisson_disc" : "poisson_disc_fixed_polygon",
                     .title = follows_circle ? "Disc, whose meshes follow its boundary"
                                             : "Disc as a hexagon, whose boundary is never refined",
                     .equation = "-div grad u = 4, u = 0 on the circle",
                     .truth = "closed form: 1 - x^2 - y^2",
                     .problem = {.load = [](Point) { return 4.; }},
                     .value = [](Point p) { return 1 - p.x * p.x - p.y * p.y; },
                     .gradient = gradient,
                     .coarsest = fem::polygon(6),
                     .divisions = 1,
                     .claims = smooth_claims(),
                     .pictured = follows_circle};
  if (follows_circle) model.onto_boundary = fem::onto_unit_circle;
  for (ModelProblem::Claim& claim : model.claims)
    claim.theory = follows_circle
                       ? "the polygon has its corners on the circle and misses it by h^2: no order "
                         "is lost"
                       : "the polygon of six corners stays as it is: the error of the region "
                         "remains, and the order is lost";
  return model;
}

}  // namespace

ModelProblem smooth_problem(const fem::Rule& rule) {
  // u = p(x) q(y). A product of two sines alone would not do: it is an eigenvector of the matrix,
  // and conjugate gradients would find the solution in a step.
  struct Factor {
    double value, slope, curvature;
  };
  const auto factor = [](double growth, double k, double x) {
    const double e = std::exp(growth * x), s = std::sin(k * x), c = std::cos(k * x);
    return Factor{e * s, e * (growth * s + k * c),
                  e * ((growth * growth - k * k) * s + 2 * growth * k * c)};
  };
  const auto p = [=](Point at) { return factor(1, pi, at.x); };
  const auto q = [=](Point at) { return factor(-1, 2 * pi, at.y); };
  return {.id = "poisson_square_smooth",
          .title = "Smooth solution on the unit square",
          .equation = "-div grad u = f, u = 0 on the boundary",
          .truth = "closed form: exp(x - y) sin(pi x) sin(2 pi y)",
          .problem = {.load =
                          [=](Point at) {
                            return -p(at).curvature * q(at).value - p(at).value * q(at).curvature;
                          }},
          .rule = &rule,
          .value = [=](Point at) { return p(at).value * q(at).value; },
          .gradient =
              [=](Point at) {
                return Point{p(at).slope * q(at).value, p(at).value * q(at).slope};
              },
          .coarsest = fem::unit_square(2),
          .claims = smooth_claims()};
}

ModelProblem skewed_problem() {
  const auto tensor = [](Point) { return fem::Tensor{1, -0.95, 1}; };
  return {.id = "poisson_square_skewed",
          .title = "Skewed tensor, for which Jacobi diverges",
          .equation = "-div(a grad u) = 1, a = [[1, -0.95], [-0.95, 1]]",
          .truth = "none: of the linear solvers alone",
          .problem = {.load = [](Point) { return 1.; }, .diffusion = tensor},
          .coarsest = fem::unit_square(2),
          .claims = {}};
}

std::vector<ModelProblem> model_problems() {
  return {smooth_problem(),
          smooth_problem(fem::one_point_rule()),
          smooth_problem(fem::vertex_rule()),
          unit_load(),
          mixed(),
          neumann(),
          corner(),
          disc(true),
          disc(false)};
}

Hierarchy::Hierarchy(const ModelProblem& problem, std::size_t most)
    : problem_(problem), levels_(problem.problem, *problem.rule, problem.undetermined) {
  levels_.add(problem.coarsest);
  while (2 * finest_divisions() <= most)
    levels_.add(fem::refined(levels_.finest().mesh, problem.onto_boundary));
}

std::vector<double> Hierarchy::nodal(const fem::Levels::Level& level,
                                     const std::vector<double>& x) const {
  return problem_.undetermined == fem::Undetermined::mean_zero
             ? fem::nodal_of_mean_zero(level.mesh, level.system, x)
             : level.system.nodal(x);
}

}  // namespace odeum::study
