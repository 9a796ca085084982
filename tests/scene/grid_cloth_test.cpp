// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/springs/grid_cloth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "odeum/cases/square_cloth.hpp"
#include "odeum/methods/imex_verlet.hpp"
#include "odeum/methods/implicit_euler.hpp"
#include "odeum/methods/predicted_implicit_euler.hpp"
#include "odeum/methods/rk4.hpp"
#include "odeum/methods/velocity_verlet.hpp"
#include "odeum/scene/problem/scene_problem.hpp"
#include "support/scenes.hpp"

namespace odeum::scene::grid_cloth_test {
namespace {

/// n x n particles a spacing apart, springs along rows and columns, one edge fixed.
Scene make_net(std::size_t n) {
  Scene scene;
  scene.gravity = {0, -9.8, 1};
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = 0; c < n; ++c) {
      Particle particle{.position = {0.1 * static_cast<double>(r), 0.1 * static_cast<double>(c), 0},
                        .mass = 0.02,
                        .fixed = c == 0};
      if (!particle.fixed) particle.velocity = {0.1, 0, std::sin(static_cast<double>(r + c))};
      scene.particles.push_back(particle);
    }
  for (std::size_t r = 0; r < n; ++r)
    for (std::size_t c = 0; c < n; ++c) {
      const std::size_t a = r * n + c;
      if (c + 1 < n)
        scene.springs.push_back(
            {.a = a, .b = a + 1, .stiffness = 20, .damping = 0.05, .rest_length = 0.1});
      if (r + 1 < n)
        scene.springs.push_back(
            {.a = a, .b = a + n, .stiffness = 10, .damping = 0.05, .rest_length = 0.1});
    }
  return scene;
}

constexpr double h = 1e-3;
constexpr std::size_t steps = 200;

/// n steps of a method on a problem from y.
template <class Method, class P, class... Options>
void take_steps(const P& problem, double step, std::size_t n, State<P>& y, Options... options) {
  using Real = RealOf<P>;
  typename Method::template Stepper<P> stepper(problem, options...);
  const Real length = static_cast<Real>(step);
  if constexpr (requires { stepper.start(0, length, y); }) stepper.start(0, length, y);
  for (std::size_t i = 0; i < n; ++i)
    ASSERT_EQ(stepper.step(static_cast<Real>(static_cast<double>(i) * step), length, y),
              Status::ok);
}

template <class Method>
std::vector<double> by_method(const Scene& scene) {
  const SceneProblem problem(scene);
  std::vector<double> y = start_of(scene);
  take_steps<Method>(problem, h, steps, y);
  return y;
}

/// In the layout of the grid.
template <class Method, class Real, class... Options>
std::vector<double> on_grid(const Scene& scene, double t, std::size_t n, std::size_t threads = 1,
                            Options... options) {
  const GridCloth<Real> cloth(scene, threads);
  std::vector<Real> y = cloth.scattered(start_of(scene));
  take_steps<Method>(cloth, t / static_cast<double>(n), n, y, options...);
  return cloth.gathered(y);
}
template <class Real>
std::vector<double> by_engine(const Scene& scene, bool verlet, std::size_t threads = 1) {
  const double t = h * static_cast<double>(steps);
  return verlet ? on_grid<methods::velocity_verlet, Real>(scene, t, steps, threads)
                : on_grid<methods::rk4, Real>(scene, t, steps, threads);
}

void expect_near(const std::vector<double>& a, const std::vector<double>& b, double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], tolerance) << i;
}

// The work space of a thread still holds what is not finite when it serves a grid of another shape.
TEST(GridOfAScene, IsComputedAloneAfterAnotherBlewUp) {
  const SceneProblem first(make_net(9)), second(make_net(5));
  const auto accelerations = [](const SceneProblem& problem, const std::vector<double>& y) {
    std::vector<double> a(problem.size() / 2);
    problem.acceleration(0, y.data(), y.data() + a.size(), a.data());
    return a;
  };
  const std::vector<double> alone = accelerations(second, second.start());
  accelerations(first, std::vector<double>(first.size(), INFINITY));
  EXPECT_EQ(accelerations(second, second.start()), alone);
}

TEST(GridCloth, TakesTheStepsOfTheMethods) {
  const Scene scene = make_net(9);
  // Two hundred steps of numbers up to ten, whose forces are summed in another order.
  expect_near(by_engine<double>(scene, true), by_method<methods::velocity_verlet>(scene), 1e-12);
  expect_near(by_engine<double>(scene, false), by_method<methods::rk4>(scene), 1e-12);
}

TEST(GridCloth, InSinglePrecisionStaysNearDouble) {
  const Scene scene = make_net(9);
  // Roundings of 6e-8 of numbers up to two, in 200 steps, grow little over a fifth of a second.
  expect_near(by_engine<float>(scene, true), by_engine<double>(scene, true), 1e-4);
  expect_near(by_engine<float>(scene, false), by_engine<double>(scene, false), 1e-4);
}

TEST(GridCloth, GivesTheSameBitsOnAnyNumberOfThreads) {
  const Scene scene = make_net(9);
  for (const bool verlet : {true, false}) {
    const auto one = by_engine<double>(scene, verlet);
    EXPECT_EQ(by_engine<double>(scene, verlet, 2), one);
    EXPECT_EQ(by_engine<double>(scene, verlet, 3), one);
  }
}

// Coordinates of size one round by 1e-16, rest lengths of 1/255 with them: by 3e-14 of themselves.
TEST(GridCloth, FindsAFineGrid) {
  for (const std::size_t n : {11U, 64U, 101U, 256U})
    EXPECT_NO_THROW(require_grid(cases::square_cloth(n, 10))) << n;
}

// Springs of no rest length are linear: one Newton step of backward Euler solves it.
TEST(GridCloth, PredictedImplicitEulerIsBackwardEulerOfALinearCloth) {
  Scene scene = make_net(7);
  for (Spring& spring : scene.springs) spring.rest_length = 0;
  expect_near(on_grid<methods::predicted_implicit_euler, double>(scene, h * steps, steps, 1, 1e-13),
              by_method<methods::implicit_euler>(scene), 1e-9);
}

double distance(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size() / 2; ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

/// The order measured from three runs of n, 2 n and 4 n steps.
double order_of_runs(std::size_t n, const auto& end) {
  const auto coarse = end(n), medium = end(2 * n), fine = end(4 * n);
  return std::log2(distance(coarse, medium) / distance(medium, fine));
}

TEST(GridCloth, PredictedImplicitEulerIsOfOrderOneAndStableAtLargeSteps) {
  const Scene scene = cases::square_cloth(11, 10);
  const auto end = [&](std::size_t n) {
    return on_grid<methods::predicted_implicit_euler, double>(scene, 0.25, n, 1, 1e-10);
  };
  EXPECT_NEAR(order_of_runs(400, end), 1, 0.1);
  for (const double x : end(5))
    EXPECT_LT(std::abs(x), 20);  // h = 0.05 s, the limit of explicit ones
}

template <class Real>
std::vector<double> by_imex(const Scene& scene, double t, std::size_t n, std::size_t threads = 1) {
  return on_grid<methods::imex_verlet, Real>(scene, t, n, threads, 1e-9);
}

TEST(GridCloth, ImexVerletIsOfOrderTwoToTheSameSolution) {
  const Scene scene = cases::square_cloth(11, 10);
  const auto end = [&](std::size_t n) { return by_imex<double>(scene, 0.25, n); };
  EXPECT_NEAR(order_of_runs(100, end), 2, 0.15);
  EXPECT_LT(distance(end(1600), on_grid<methods::rk4, double>(scene, 0.25, 400)), 1e-5);
  EXPECT_LT(distance(by_imex<float>(scene, 0.25, 400), end(400)), 1e-3);
}

TEST(GridCloth, ImexVerletWithoutDampersIsVelocityVerlet) {
  Scene scene = make_net(9);
  for (Spring& spring : scene.springs) spring.damping = 0;
  expect_near(by_imex<double>(scene, h * steps, steps), by_engine<double>(scene, true), 1e-12);
}

// Velocity Verlet needs h < 0.046 m / d = 2e-4 s here, and at 1e-3 grows without bound.
TEST(GridCloth, ImexVerletIsNotLimitedByDamping) {
  Scene scene = cases::square_cloth(11, 10);
  for (Spring& spring : scene.springs) spring.damping = 5;
  const std::vector<double> imex = by_imex<double>(scene, 1, 1000);
  for (const double x : imex) EXPECT_LT(std::abs(x), 20);
  EXPECT_FALSE(distance(on_grid<methods::velocity_verlet, double>(scene, 1, 1000), imex) < 1e3);
}

// The dampers by conjugate gradients over edges and by Chebyshev's iteration on the grid.
TEST(GridCloth, ImexVerletIsTheSameEdgeByEdge) {
  Scene scene = make_net(9);
  const std::vector<double> grid = by_imex<double>(scene, h * steps, steps);
  scene.springs.back().stiffness *= 1 + 1e-12;  // not alike: no grid
  const SceneProblem edges(scene);
  ASSERT_FALSE(edges.grid());
  std::vector<double> y = start_of(scene);
  take_steps<methods::imex_verlet>(edges, h, steps, y, 1e-11);
  expect_near(y, grid, 1e-7);  // 200 steps, each damped to 1e-9 of a change of up to 0.1 m/s
}

TEST(GridCloth, ImexVerletGivesTheSameBitsOnAnyNumberOfThreads) {
  const Scene scene = cases::square_cloth(11, 10);
  const auto one = by_imex<double>(scene, 0.05, 20);
  EXPECT_EQ(by_imex<double>(scene, 0.05, 20, 2), one);
  EXPECT_EQ(by_imex<double>(scene, 0.05, 20, 3), one);
}

TEST(GridCloth, RefusesScenesThatAreNoGrid) {
  Scene scene = make_net(5);
  EXPECT_THROW(GridCloth<double>(scene, 0), std::invalid_argument);
  EXPECT_NO_THROW(GridCloth<double>{scene});
  scene.springs.pop_back();
  EXPECT_THROW(GridCloth<double>{scene}, std::invalid_argument);
}

}  // namespace
}  // namespace odeum::scene::grid_cloth_test
