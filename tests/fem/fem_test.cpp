// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "odeum/fem/element.hpp"
#include "odeum/fem/shapes.hpp"
#include "odeum/linear/eigen_solvers.hpp"

namespace odeum::fem::fem_test {
namespace {

const TriangleMesh two_triangles{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 1, 2}, {0, 2, 3}}};

template <class Work>
std::string error_of(Work&& work) {
  try {
    work();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "no error";
}

double area(const TriangleMesh& mesh) {
  double sum = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) sum += doubled_area(mesh, t) / 2;
  return sum;
}

std::vector<double> solved(const TriangleMesh& mesh, const EllipticProblem& problem,
                           const Rule& rule) {
  const EllipticSystem system = assemble(mesh, problem, rule);
  std::vector<double> x(system.right.size());
  linear::SparseLdlt(system.matrix).solve(system.right.data(), x.data());
  return system.nodal(x);
}

// x^i y^j over the triangle (0, 0), (1, 0), (0, 1) integrates to i! j! / (i + j + 2)!.
TEST(Quadrature, IsExactToItsDegreeAndNoFurther) {
  for (const Rule* rule : {&one_point_rule(), &vertex_rule(), &degree_5_rule()})
    for (int degree = 0; degree <= rule->degree + 1; ++degree) {
      double worst = 0;
      for (int i = 0; i <= degree; ++i) {
        double sum = 0;
        for (const Rule::Node& node : rule->nodes)
          sum += node.weight / 2 * std::pow(node.at[1], i) * std::pow(node.at[2], degree - i);
        const double exact =
            std::tgamma(i + 1) * std::tgamma(degree - i + 1) / std::tgamma(degree + 3);
        worst = std::max(worst, std::abs(sum - exact));
      }
      if (degree <= rule->degree)
        EXPECT_LT(worst, 1e-15) << rule->name << degree;  // rounding
      else
        EXPECT_GT(worst, 1e-6) << rule->name << degree;
    }
}

TEST(Element, OfTheUnitRightTriangle) {
  const TriangleMesh mesh{{{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 2}}};
  const Element element(mesh, 0);
  const ElementMatrix stiffness{{{1, -0.5, -0.5}, {-0.5, 0.5, 0}, {-0.5, 0, 0.5}}};
  EXPECT_EQ(element.stiffness({}), stiffness);
  // grad = (-1, -1), (1, 0), (0, 1): a12 alone couples nodes 1 and 2 by area * a12.
  EXPECT_EQ(element.stiffness({1, 0.5, 1})[1][2], 0.25);
  EXPECT_EQ(mass_matrix(mesh).at(0, 0), 1. / 12);
  EXPECT_EQ(mass_matrix(mesh).at(0, 1), 1. / 24);
}

TEST(EllipticAssembly, OfUniformRightTrianglesIsTheFivePointStar) {
  const TriangleMesh mesh = unit_square(6);
  const EllipticSystem system = assemble(mesh, {.load = [](Point) { return 1.; }}, vertex_rule());
  ASSERT_EQ(system.matrix.rows, 25);
  for (int i = 0; i < 25; ++i)
    for (int j = 0; j < 25; ++j) {
      const int across = std::abs(i % 5 - j % 5), up = std::abs(i / 5 - j / 5);
      const double entry = i == j ? 4 : across + up == 1 ? -1 : 0;
      EXPECT_NEAR(system.matrix.at(i, j), entry, 1e-14) << i << ' ' << j;  // rounding of 6 terms
    }
  for (const double f : system.right) EXPECT_NEAR(f, 1. / 36, 1e-16);
}

// The patch test: a linear solution lies in the space of the elements, whatever the mesh.
TEST(EllipticAssembly, SolvesLinearSolutionsExactly) {
  const Tensor a{2, 0.5, 1};
  const auto linear_solution = [](Point p) { return 1 + 2 * p.x - 3 * p.y; };
  const EllipticProblem problem{
      .load = [](Point) { return 0.; },
      .diffusion = [=](Point) { return a; },
      .is_dirichlet = [](Point p) { return p.x == 0; },
      .boundary_value = linear_solution,
      .flux = [=](Point,
                  Point n) { return n.x * (2 * a.xx - 3 * a.xy) + n.y * (2 * a.xy - 3 * a.yy); }};
  for (const std::uint64_t seed : {1, 2, 3}) {
    const TriangleMesh mesh = unstructured_square(9, seed);
    const std::vector<double> nodal = solved(mesh, problem, one_point_rule());
    for (std::size_t i = 0; i < nodal.size(); ++i)
      EXPECT_NEAR(nodal[i], linear_solution(mesh.nodes[i]), 1e-12);  // rounding, condition 1e3
  }
}

TEST(MassMatrix, IntegratesProductsOfLinearFunctions) {
  const TriangleMesh mesh = unstructured_square(5, 4);
  const linear::SparseMatrix mass = mass_matrix(mesh);
  std::vector<double> x, mx(mesh.nodes.size());
  for (const Point& p : mesh.nodes) x.push_back(p.x);
  mass.multiply(x.data(), mx.data());
  double square = 0, sum = 0;
  for (std::size_t i = 0; i < x.size(); ++i) square += x[i] * mx[i], sum += mx[i];
  EXPECT_NEAR(square, 1. / 3, 1e-14);
  EXPECT_NEAR(sum, 1. / 2, 1e-14);
}

TEST(Shapes, AreValidMeshesOfTheirRegions) {
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6, 7, 8}) {
    const TriangleMesh mesh = unstructured_square(12, seed);
    EXPECT_NO_THROW(check(mesh));
    EXPECT_NEAR(area(mesh), 1, 1e-13);
  }
  EXPECT_NO_THROW(check(unit_square(1)));
  EXPECT_NO_THROW(check(l_shape(3)));
  EXPECT_NEAR(area(l_shape(3)), 3, 1e-13);
  EXPECT_THROW(unit_square(0), std::invalid_argument);
  EXPECT_THROW(l_shape(0), std::invalid_argument);
  EXPECT_THROW(polygon(2), std::invalid_argument);
  TriangleMesh disc = polygon(6);
  for (int i = 0; i < 4; ++i) disc = refined(disc, onto_unit_circle).mesh;
  EXPECT_NO_THROW(check(disc));
  // A regular polygon of 6 * 16 corners.
  EXPECT_NEAR(area(disc), 48 * std::sin(2 * std::numbers::pi / 96), 1e-13);
  EXPECT_EQ(boundary_edges(disc).size(), 96U);
}

TEST(Refinement, HalvesEdgesAndKeepsNodes) {
  const TriangleMesh coarse = unstructured_square(4, 1);
  const Refined fine = refined(coarse);
  EXPECT_NO_THROW(check(fine.mesh));
  EXPECT_EQ(fine.mesh.triangles.size(), 4 * coarse.triangles.size());
  EXPECT_NEAR(longest_edge(fine.mesh), longest_edge(coarse) / 2, 1e-15);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < fine.parents.size(); ++i) {
    const auto& [a, b] = fine.parents[i];
    kept += a == b;
    EXPECT_LT(distance(fine.mesh.nodes[i], middle(coarse.nodes[a], coarse.nodes[b])), 1e-15);
  }
  EXPECT_EQ(kept, coarse.nodes.size());
  // Uniform meshes stay the uniform ones, numbers of the nodes included.
  const TriangleMesh uniform = refined(unit_square(4)).mesh;
  for (std::size_t i = 0; i < uniform.nodes.size(); ++i)
    EXPECT_EQ(distance(uniform.nodes[i], unit_square(8).nodes[i]), 0);
}

TEST(MeshCheck, NamesWhatIsWrong) {
  const auto error = [](const std::function<void(TriangleMesh&)>& change) {
    TriangleMesh mesh = two_triangles;
    change(mesh);
    return error_of([&] { check(mesh); });
  };
  EXPECT_EQ(error([](TriangleMesh&) {}), "no error");
  EXPECT_EQ(error([](TriangleMesh& m) { m.triangles.clear(); }), "the mesh has no triangles");
  EXPECT_EQ(error([](TriangleMesh& m) { m.nodes[2].y = NAN; }), "node 2 is not at a finite point");
  EXPECT_EQ(error([](TriangleMesh& m) {
              m.triangles[1] = {0, 3, 2};
            }),
            "triangle 1 is inverted: its nodes run clockwise");
  EXPECT_EQ(error([](TriangleMesh& m) {
              m.nodes[3] = {0.5, 0.5};
            }),
            "triangle 1 is degenerate: its nodes lie on a line");
  EXPECT_EQ(error([](TriangleMesh& m) { m.nodes[3] = m.nodes[0]; }),
            "triangle 1 is degenerate: its nodes lie on a line");
  EXPECT_EQ(error([](TriangleMesh& m) {
              m.triangles[1] = {0, 2, 2};
            }),
            "triangle 1 has a node twice");
  EXPECT_EQ(error([](TriangleMesh& m) { m.triangles[1][2] = 4; }),
            "triangle 1 has node 4, but there are only 4 nodes, from 0");
  EXPECT_EQ(error([](TriangleMesh& m) {
              m.triangles.push_back({1, 2, 0});
            }),
            "triangle 2 is a duplicate of triangle 0");
  EXPECT_EQ(error([](TriangleMesh& m) {
              m.nodes.push_back({2, 2});
            }),
            "node 4 belongs to no triangle");
  EXPECT_EQ(error([](TriangleMesh& m) {
              m.nodes.push_back({0.5, 2});
              m.triangles.push_back({0, 2, 4});
            }),
            "triangle 0 and two more have the edge between node 0 and node 2");
  EXPECT_EQ(error([](TriangleMesh& m) {
              m.nodes.push_back({0.4, 0.2});
              m.triangles = {{0, 1, 2}, {0, 1, 4}, {1, 2, 3}};
            }),
            "triangle 1 overlaps triangle 0 at the edge between node 0 and node 1");
  EXPECT_EQ(error([](TriangleMesh& m) {
              for (const Point p : {Point{5, 0}, Point{6, 0}, Point{5, 1}}) m.nodes.push_back(p);
              m.triangles.push_back({4, 5, 6});
            }),
            "the mesh is in more than one piece: triangle 2 is not connected to triangle 0");
}

TEST(EllipticProblem, SaysWhyItCannotBeSolved) {
  const auto one = [](Point) { return 1.; };
  const TriangleMesh mesh = unit_square(4);
  const auto error = [&](const EllipticProblem& problem,
                         Undetermined undetermined = Undetermined::refuse) {
    return error_of([&] { assemble(mesh, problem, vertex_rule(), undetermined); });
  };
  EXPECT_EQ(error({.load = one}), "no error");
  EXPECT_EQ(error({.load = [](Point p) { return p.x == 0.5 && p.y == 0.25 ? NAN : 1; }}),
            "the load f is nan at (0.5, 0.25)");
  EXPECT_EQ(error({.load = one, .boundary_value = [](Point p) { return 1 / p.x; }}),
            "the boundary value is inf at (0, 0)");
  EXPECT_EQ(error({.load = one,
                   .diffusion =
                       [](Point) {
                         return Tensor{1, 1, 1};
                       }}),
            "the tensor a is not positive definite: [[1, 1], [1, 1]] at (0.166667, 0.0833333)");
  EXPECT_EQ(error({.load = one,
                   .diffusion =
                       [](Point) {
                         return Tensor{-1, 0, -1};
                       }}),
            "the tensor a is not positive definite: [[-1, 0], [0, -1]] at (0.166667, 0.0833333)");
  EXPECT_EQ(error({.load = one,
                   .diffusion =
                       [](Point) {
                         return Tensor{1, NAN, 1};
                       }}),
            "the tensor a is not finite at (0.166667, 0.0833333)");
  const auto nowhere = [](Point) { return false; };
  EXPECT_NE(error({.load = one, .is_dirichlet = nowhere}).find("no Dirichlet condition"),
            std::string::npos);
  EXPECT_EQ(error({.load = one, .is_dirichlet = nowhere}, Undetermined::mean_zero),
            "no solution: u is given nowhere, and load and flux add up to 1 instead of 0");
  // -1/4 through each of the four edges balances a load of 1.
  EXPECT_EQ(
      error({.load = one, .is_dirichlet = nowhere, .flux = [](Point, Point) { return -0.25; }},
            Undetermined::mean_zero),
      "no error");
  EXPECT_NE(error({.load = one, .is_dirichlet = nowhere, .flux = [](Point, Point) { return NAN; }})
                .find("the flux is nan"),
            std::string::npos);
  EXPECT_NE(error_of([&] {
              assemble(two_triangles, {.load = one}, vertex_rule());
            }).find("u is given at every node"),
            std::string::npos);
}

}  // namespace
}  // namespace odeum::fem::fem_test
