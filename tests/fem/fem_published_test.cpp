// SPDX-License-Identifier: BSD-3-Clause
// Elements against numbers that others have published.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "odeum/fem/elliptic.hpp"
#include "odeum/fem/shapes.hpp"
#include "odeum/linear/eigen_solvers.hpp"

namespace odeum::fem::fem_published_test {
namespace {

const EllipticProblem unit_load{.load = [](Point) { return 1.; }};

std::vector<double> solved(const EllipticSystem& system) {
  std::vector<double> x(system.right.size());
  linear::SparseLdlt(system.matrix).solve(system.right.data(), x.data());
  return x;
}

/// 4 times the integral of u, -div grad u = 1, u = 0 on the boundary: the stiffness of a bar
/// against torsion over its shear modulus.
double torsion_constant(std::size_t n) {
  const EllipticSystem system = assemble(unit_square(n), unit_load, one_point_rule());
  const std::vector<double> x = solved(system);
  return 4 * std::inner_product(x.begin(), x.end(), system.right.begin(), 0.);
}

/// The lowest value of K u = value M u, u = 0 on the boundary, by inverse iteration.
double lowest_eigenvalue(const TriangleMesh& mesh) {
  const EllipticSystem system = assemble(mesh, unit_load, one_point_rule());
  const linear::SparseMatrix mass = mass_matrix(mesh);
  const linear::SparseLdlt stiffness(system.matrix);
  std::vector<double> x = solved(system), right(x.size()), ax(x.size()), mx(mesh.nodes.size());
  double value = 0;
  // The second eigenvalue is above 1.5 times the first in these regions: 40 steps leave 1e-14 of
  // its part, by squares.
  for (int step = 0; step < 40; ++step) {
    mass.multiply(system.nodal(x).data(), mx.data());
    for (std::size_t i = 0; i < mx.size(); ++i)
      if (system.unknown[i] >= 0) right[static_cast<std::size_t>(system.unknown[i])] = mx[i];
    system.matrix.multiply(x.data(), ax.data());
    const double mean = std::inner_product(x.begin(), x.end(), right.begin(), 0.);
    value = std::inner_product(x.begin(), x.end(), ax.begin(), 0.) / mean;
    for (double& each : right) each /= std::sqrt(mean);
    stiffness.solve(right.data(), x.data());
  }
  return value;
}

// Timoshenko and Goodier, Theory of Elasticity, section 109: 0.1406 of the fourth power of a
// square's side; its series in more digits.
TEST(PublishedNumbers, TorsionConstantOfASquareBar) {
  constexpr double published = 0.1405770;
  const double coarse = torsion_constant(32), fine = torsion_constant(64);
  // The energy of a conforming solution is too small.
  EXPECT_LT(coarse, fine);
  EXPECT_LT(fine, published);
  // Without the term of h^2 one of h^4 remains: on 32 divisions 1e-6 times a third.
  EXPECT_NEAR((4 * fine - coarse) / 3, published, 5e-7);
  EXPECT_NEAR(std::log2((published - coarse) / (published - fine)), 2, 0.02);
}

// Betcke and Trefethen, Reviving the method of particular solutions, SIAM Review 47 (2005): the L
// shape of three unit squares has the lowest eigenvalue 9.6397238440219.
TEST(PublishedNumbers, LowestEigenvalueOfTheLShape) {
  constexpr double published = 9.6397238440219;
  double before = 0;
  for (const std::size_t n : {16, 32, 64}) {
    const double excess = lowest_eigenvalue(l_shape(n)) - published;
    // The excess is positive by the principle of the minimum; twice the order of the H1 error at
    // the corner, 4/3, comes from above, since the rest of the region converges with order 2.
    EXPECT_GT(excess, 0);
    if (before > 0) {
      const double order = std::log2(before / excess);
      EXPECT_GT(order, 4. / 3);
      EXPECT_LT(order, 1.6);
    }
    before = excess;
  }
  EXPECT_LT(before, 0.02);
}

// The square of the first zero of Bessel's function J0 (Abramowitz and Stegun, table 9.5).
TEST(PublishedNumbers, LowestEigenvalueOfTheDisc) {
  constexpr double zero = 2.4048255577;
  TriangleMesh mesh = polygon(6);
  double values[6] = {};
  for (double& value : values) {
    mesh = refined(mesh, onto_unit_circle).mesh;
    value = lowest_eigenvalue(mesh);
  }
  const double coarse = values[4] - zero * zero, fine = values[5] - zero * zero;
  EXPECT_GT(fine, 0);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.05);
  // The term of h^2 taken away, of 4e-3 on 64 divisions: some h^4 remain.
  EXPECT_NEAR((4 * values[5] - values[4]) / 3, zero * zero, 1e-4);
}

}  // namespace
}  // namespace odeum::fem::fem_published_test
