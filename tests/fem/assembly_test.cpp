// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/fem/element.hpp"
#include "odeum/fem/shapes.hpp"

namespace odeum::fem::assembly_test {
namespace {

std::string error_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::runtime_error& e) {
    return e.what();
  }
  return "no error";
}

// Every node's rows are summed in the order of the triangles, whichever thread does it.
TEST(EllipticAssembly, IsTheSameBitsForAnyNumberOfThreads) {
  const TriangleMesh mesh = unstructured_square(20, 3);
  const EllipticProblem problem{
      .load = [](Point p) { return std::exp(p.x) + p.y; },
      .diffusion =
          [](Point p) {
            return Tensor{1 + p.x, 0.3, 1 + p.y};
          },
      .is_dirichlet = [](Point p) { return p.x == 0; },
      .boundary_value = [](Point p) { return p.y; },
      .flux = [](Point p, Point normal) { return normal.x + p.y * normal.y; }};
  for (const Rule* rule : {&vertex_rule(), &degree_5_rule()}) {
    const EllipticSystem one = assemble(mesh, problem, *rule);
    for (const std::size_t threads : {2, 3}) {
      const EllipticSystem some = assemble(mesh, problem, *rule, Undetermined::refuse, threads);
      EXPECT_EQ(some.matrix.start, one.matrix.start);
      EXPECT_EQ(some.matrix.column, one.matrix.column);
      EXPECT_EQ(some.matrix.value, one.matrix.value);
      EXPECT_EQ(some.right, one.right);
    }
  }
  const auto nan_at = [](Point p) { return p.y > 0.5 ? NAN : 1.; };
  const auto error = [&](std::size_t threads) {
    return error_of(
        [&] { assemble(mesh, {.load = nan_at}, one_point_rule(), Undetermined::refuse, threads); });
  };
  EXPECT_NE(error(1).find("the load f is nan"), std::string::npos);
  EXPECT_EQ(error(3), error(1));
}

// All rows against a matrix that is put together from the elements' entries.
TEST(EllipticAssembly, AddsUpTheElements) {
  const TriangleMesh mesh = unstructured_square(5, 7);
  const auto diffusion = [](Point p) { return Tensor{2 + p.x, -0.5, 1 + p.y}; };
  const EllipticSystem system = assemble(mesh,
                                         {.load = [](Point) { return 1.; },
                                          .diffusion = diffusion,
                                          .is_dirichlet = [](Point p) { return p.y == 0; }},
                                         vertex_rule());
  std::vector<linear::Triplet> entries;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const Element element(mesh, t);
    const auto k = element.stiffness(diffusion(element.at({1. / 3, 1. / 3, 1. / 3})));
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j) {
        const int row = system.unknown[mesh.triangles[t][i]],
                  column = system.unknown[mesh.triangles[t][j]];
        if (row >= 0 && column >= 0) entries.push_back({row, column, k[i][j]});
      }
  }
  const int n = static_cast<int>(system.right.size());
  const linear::SparseMatrix sum = linear::from_triplets(n, n, entries);
  ASSERT_EQ(system.matrix.column, sum.column);
  // Rounding of a few sums of entries of size 1 to 10.
  for (std::size_t k = 0; k < sum.value.size(); ++k)
    EXPECT_NEAR(system.matrix.value[k], sum.value[k], 1e-13);
}

}  // namespace
}  // namespace odeum::fem::assembly_test
