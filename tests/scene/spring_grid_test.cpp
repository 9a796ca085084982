// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/springs/spring_grid.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "odeum/scene/problem/scene_problem.hpp"
#include "odeum/scene/springs/lanes.hpp"

namespace odeum::scene::spring_grid_test {
namespace {

struct Grid {
  std::size_t rows, columns;
  bool tension_only;
  friend std::ostream& operator<<(std::ostream& out, const Grid& x) {
    return out << x.rows << " x " << x.columns;
  }
};

Scene make_scene(const Grid& grid) {
  Scene scene;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  for (std::size_t r = 0; r < grid.rows; ++r)
    for (std::size_t c = 0; c < grid.columns; ++c)
      scene.particles.push_back(
          {.position = {static_cast<double>(r) + jitter(random),
                        static_cast<double>(c) + jitter(random), jitter(random)},
           .velocity = {jitter(random), jitter(random), jitter(random)},
           .mass = 0.1});
  const auto join = [&](std::size_t r, std::size_t c, int dr, int dc) {
    const int row = static_cast<int>(r) + dr, column = static_cast<int>(c) + dc;
    if (row < 0 || column < 0 || row >= static_cast<int>(grid.rows) ||
        column >= static_cast<int>(grid.columns))
      return;
    const auto b = static_cast<std::size_t>(row) * grid.columns + static_cast<std::size_t>(column);
    scene.springs.push_back({.a = r * grid.columns + c,
                             .b = b,
                             .stiffness = 10.0 * (1 + std::abs(dr)) + dc,
                             .damping = 0.1 * (2 + dc),
                             .rest_length = std::hypot(dr, dc),
                             .tension_only = grid.tension_only});
  };
  for (std::size_t r = 0; r < grid.rows; ++r)
    for (std::size_t c = 0; c < grid.columns; ++c)
      for (const int reach : {1, 2}) {
        join(r, c, 0, reach);
        join(r, c, reach, -reach);
        join(r, c, reach, 0);
        join(r, c, reach, reach);
      }
  return scene;
}

/// The same springs and one of zero stiffness, so that they are not a grid.
Scene spoiled(Scene scene) {
  scene.springs.push_back({.a = 0, .b = scene.size() - 1, .rest_length = 1});
  return scene;
}

class SpringGrid : public testing::TestWithParam<Grid> {};

TEST_P(SpringGrid, GathersWhatTheEdgesGive) {
  const Scene scene = make_scene(GetParam());
  const SceneProblem grid(scene), edges(spoiled(scene));
  ASSERT_NE(grid.grid(), nullptr);
  ASSERT_EQ(edges.grid(), nullptr);
  const std::vector<double> y = start_of(scene);
  std::vector<double> x(y.size()), by_grid(y.size()), by_edges(y.size());
  for (std::size_t i = 0; i < x.size(); ++i) x[i] = std::sin(static_cast<double>(i));
  // Accelerations up to some 2000 m/s^2, sums of sixteen in another order: 1.1e-16 * 2000 * 16.
  constexpr double rounding = 4e-12;
  grid.rhs(0, y.data(), by_grid.data());
  edges.rhs(0, y.data(), by_edges.data());
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(by_grid[i], by_edges[i], rounding) << i;
  grid.jacobian_times(0, y.data(), x.data(), by_grid.data());
  edges.jacobian_times(0, y.data(), x.data(), by_edges.data());
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(by_grid[i], by_edges[i], rounding) << i;
}

// Both stop at a residual of 1e-12, and the matrices' condition numbers are below 1e3; those of
// compressed springs are indefinite, so that both end in a direct solve.
TEST_P(SpringGrid, SolvesWhatTheEdgesSolve) {
  Scene scene = make_scene(GetParam());
  for (const std::size_t i : {std::size_t{0}, scene.size() - 2}) {
    scene.particles[i].fixed = true;
    scene.particles[i].velocity = {};
  }
  for (const double squeeze : {1.0, 0.3}) {
    for (Particle& particle : scene.particles)
      for (double& coordinate : particle.position) coordinate *= squeeze;
    const SceneProblem grid(scene), edges(spoiled(scene));
    ASSERT_NE(grid.grid(), nullptr);
    const std::vector<double> y = start_of(scene);
    for (const double gamma_h : {1e-3, 0.05, 0.4, 0.0, -1e-3}) {
      const auto by_grid = grid.shifted_solver(), by_edges = edges.shifted_solver();
      ASSERT_TRUE(by_grid->factorise(0, y.data(), gamma_h));
      ASSERT_TRUE(by_edges->factorise(0, y.data(), gamma_h));
      for (int trial = 0; trial < 2; ++trial) {  // one factorisation serves several right sides
        std::vector<double> a(y.size());
        for (std::size_t i = 0; i < a.size(); ++i)
          a[i] = std::sin(static_cast<double>(i) + trial);  // not zero on fixed particles either
        std::vector<double> b = a;
        ASSERT_TRUE(by_grid->solve(a.data(), ShiftedSolver::exact));
        ASSERT_TRUE(by_edges->solve(b.data(), ShiftedSolver::exact));
        double size = 0, difference = 0;
        for (std::size_t i = 0; i < a.size(); ++i) {
          size = std::max(size, std::abs(b[i]));
          difference = std::max(difference, std::abs(a[i] - b[i]));
        }
        EXPECT_LE(difference, 1e-8 * size) << squeeze << ' ' << gamma_h;
      }
    }
  }
}

TEST(GridSprings, HaveNoStiffnessAtNoLength) {
  Scene scene = make_scene({4, 4, false});
  scene.particles[5].position = scene.particles[6].position;
  const SceneProblem grid(scene), edges(spoiled(scene));
  const std::vector<double> y = start_of(scene);
  std::vector<double> x(y.size(), 0), by_grid(y.size()), by_edges(y.size());
  x[3 * 5] = 1;
  grid.jacobian_times(0, y.data(), x.data(), by_grid.data());
  edges.jacobian_times(0, y.data(), x.data(), by_edges.data());
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(by_grid[i], by_edges[i], 1e-9) << i;
  const auto a = grid.shifted_solver(), b = edges.shifted_solver();
  std::vector<double> xa = x, xb = x;
  ASSERT_TRUE(a->factorise(0, y.data(), 0.01) && a->solve(xa.data(), ShiftedSolver::exact));
  ASSERT_TRUE(b->factorise(0, y.data(), 0.01) && b->solve(xb.data(), ShiftedSolver::exact));
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(xa[i], xb[i], 1e-9) << i;
}

INSTANTIATE_TEST_SUITE_P(Shapes, SpringGrid,
                         testing::Values(Grid{11, 11, false}, Grid{3, 5, false}, Grid{8, 16, false},
                                         Grid{17, 9, true}, Grid{5, 33, true}),
                         [](const auto& test) {
                           return std::to_string(test.param.rows) + "x" +
                                  std::to_string(test.param.columns) +
                                  (test.param.tension_only ? "_tension_only" : "");
                         });

TEST(SpringGrid, NeverLooksAtItsMargins) {
  const Scene scene = make_scene({6, 10, false});
  const auto structure = find_grid(scene.particles, scene.springs);
  ASSERT_TRUE(structure);
  const GridLayout layout(structure->rows, structure->columns);
  const GridSprings<double> springs(layout, structure->kinds);
  const std::vector<double> y = start_of(scene);
  std::vector<double> results[2];
  for (const double margin : {0.0, 1e6}) {
    std::vector<double> q(3 * layout.size, margin), v(q), force(q.size());
    layout.scatter(y.data(), q.data());
    layout.scatter(y.data() + y.size() / 2, v.data());
    springs.forces(q.data(), v.data(), force.data(), 0, layout.rows);
    std::vector<double>& result = results[margin != 0];
    result.resize(y.size() / 2);
    layout.gather(force.data(), result.data());
  }
  EXPECT_EQ(results[0], results[1]);  // to the bit
}

// Forces on the ends of springs are kept between rows, in space that grids of a thread share.
TEST(SpringGrid, TheSameBitsFromRowsOneByOneAndAfterAWiderGrid) {
  const auto forces = [](std::size_t rows, std::size_t columns, bool one_by_one) {
    const Scene scene = make_scene({rows, columns, false});
    const auto structure = find_grid(scene.particles, scene.springs);
    const GridLayout layout(structure->rows, structure->columns);
    const GridSprings<double> springs(layout, structure->kinds);
    const std::vector<double> y = start_of(scene);
    std::vector<double> q(3 * layout.size), v(q), force(q), result(y.size() / 2);
    layout.scatter(y.data(), q.data());
    layout.scatter(y.data() + y.size() / 2, v.data());
    const std::size_t each = one_by_one ? 1 : rows;
    for (std::size_t row = 0; row < rows; row += each)
      springs.forces(q.data(), v.data(), force.data(), row, row + each);
    layout.gather(force.data(), result.data());
    return result;
  };
  const std::vector<double> whole = forces(9, 8, false);
  EXPECT_EQ(forces(9, 8, true), whole);
  forces(9, 16, false);  // whose lines are as long
  EXPECT_EQ(forces(9, 8, false), whole);
}

// A force depends on lengths by their ratios alone, also where no float holds their squares.
TEST(SpringGrid, PullsAlikeAtAnyLength) {
  const auto forces = [](double metre) {
    Scene scene = make_scene({6, 10, false});
    for (Particle& particle : scene.particles)
      for (double& coordinate : particle.position) coordinate *= metre;
    for (Spring& spring : scene.springs) spring.rest_length *= metre;
    GridStructure grid = *find_grid(scene.particles, scene.springs);
    const GridLayout layout(grid.rows, grid.columns);
    const GridSprings<double> springs(layout, grid.kinds);
    const std::vector<double> y = start_of(scene);
    std::vector<double> q(3 * layout.size), force(q), result(y.size() / 2);
    layout.scatter(y.data(), q.data());
    springs.forces(q.data(), nullptr, force.data(), 0, layout.rows);
    layout.gather(force.data(), result.data());
    for (double& x : result) x /= metre;
    return result;
  };
  const std::vector<double> expected = forces(1);
  for (const double metre : {0x1p-80, 0x1p-9, 0x1p9, 0x1p80}) {
    const std::vector<double> found = forces(metre);
    // Sums of sixteen springs of some 100 N: 1.1e-16 * 100 * 16.
    for (std::size_t i = 0; i < found.size(); ++i)
      EXPECT_NEAR(found[i], expected[i], 2e-13) << metre << ' ' << i;
  }
}

TEST(SpringGrid, InSinglePrecisionAgreesToSinglePrecision) {
  const Scene scene = make_scene({12, 12, false});
  const auto structure = find_grid(scene.particles, scene.springs);
  const GridLayout layout(structure->rows, structure->columns);
  const std::vector<double> y = start_of(scene);
  std::vector<double> wide(y.size() / 2), narrow(y.size() / 2);
  const auto run = [&]<class Real>(Real, std::vector<double>& out) {
    const GridSprings<Real> springs(layout, structure->kinds);
    std::vector<Real> q(3 * layout.size), v(q), force(q);
    layout.scatter(y.data(), q.data());
    layout.scatter(y.data() + y.size() / 2, v.data());
    springs.forces(q.data(), v.data(), force.data(), 0, layout.rows);
    layout.gather(force.data(), out.data());
  };
  run(double{}, wide);
  run(float{}, narrow);
  // Differences of positions up to 12, sixteen springs of up to 40 N/m: 6e-8 * 12 * 40 * 16.
  for (std::size_t i = 0; i < wide.size(); ++i) EXPECT_NEAR(narrow[i], wide[i], 5e-4) << i;
}

TEST(SpringGrid, IsFoundOnlyWhereEverySpringIsInItsPlace) {
  const Scene whole = make_scene({7, 9, false});
  ASSERT_TRUE(find_grid(whole.particles, whole.springs));
  EXPECT_EQ(find_grid(whole.particles, whole.springs)->rows, 7U);
  EXPECT_EQ(find_grid(whole.particles, whole.springs)->columns, 9U);
  EXPECT_EQ(find_grid(whole.particles, whole.springs)->kinds.size(), 8U);
  Scene torn = whole;
  torn.springs.erase(torn.springs.begin() + 5);
  EXPECT_FALSE(find_grid(torn.particles, torn.springs));
  Scene doubled = whole;
  doubled.springs.push_back(doubled.springs.front());
  EXPECT_FALSE(find_grid(doubled.particles, doubled.springs));
  Scene uneven = whole;
  uneven.springs[3].stiffness *= 1.001;
  EXPECT_FALSE(find_grid(uneven.particles, uneven.springs));
  Scene loose;
  loose.particles.resize(9);
  EXPECT_FALSE(find_grid(loose.particles, loose.springs));
}

// A spring of zero length has no direction; it must not give NaN to its neighbours.
TEST(SpringGrid, ASpringOfNoLengthExertsNoForce) {
  Scene scene = make_scene({4, 4, false});
  scene.particles[5].position = scene.particles[6].position;
  scene.particles[5].velocity = scene.particles[6].velocity;
  const SceneProblem grid(scene), edges(spoiled(scene));
  ASSERT_NE(grid.grid(), nullptr);
  const std::vector<double> y = start_of(scene);
  std::vector<double> by_grid(y.size()), by_edges(y.size());
  grid.rhs(0, y.data(), by_grid.data());
  edges.rhs(0, y.data(), by_edges.data());
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(by_grid[i], by_edges[i], 1e-12) << i;
}

template <class Real, bool moderate>
double worst_inverse_sqrt(double exponents) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> exponent(-exponents, exponents);
  double worst = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    Vector<Real> x{};
    for (std::size_t i = 0; i < Lanes<Real>::count; ++i)
      x[i] = static_cast<Real>(std::pow(10, exponent(random)));
    const Vector<Real> y = inverse_sqrt<Real, moderate>(x);
    for (std::size_t i = 0; i < Lanes<Real>::count; ++i)
      worst = std::max(
          worst, std::abs(static_cast<double>(y[i]) * std::sqrt(static_cast<double>(x[i])) - 1));
  }
  return worst;
}

TEST(Lanes, InverseSquareRootIsRightToTwoRoundings) {
  // Two roundings of 1.1e-16 or 6e-8, and two more of the check itself.
  const double worst = worst_inverse_sqrt<double, false>(300);
  EXPECT_LT(worst, 5e-16);
  EXPECT_GT(worst, 0);
  EXPECT_LT((worst_inverse_sqrt<double, true>(37)), 5e-16);
  EXPECT_LT((worst_inverse_sqrt<float, true>(37)), 1.3e-7);
}

}  // namespace
}  // namespace odeum::scene::spring_grid_test
