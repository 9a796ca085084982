// SPDX-License-Identifier: BSD-3-Clause
// One step of own methods against an independent evaluation: textbook formulas, tableaus, by hand.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "odeum_methods.hpp"
#include "support/catalogue.hpp"
#include "support/field.hpp"

namespace odeum::tests::own_steps_test {
namespace {

/// A nonlinear, non-autonomous acceleration, in which a wrong node or weight shows.
double pendulum(double t, double q) { return std::cos(3 * t) - 2 * std::sin(q); }
double pendulum_q(double, double q) { return -2 * std::cos(q); }
double pendulum_t(double t, double) { return -3 * std::sin(3 * t); }

struct State2 {
  double q, v;
};

using Step = State2 (*)(double t, double h, State2 y);

State2 verlet(double t, double h, State2 y) {
  const double a0 = pendulum(t, y.q), q = y.q + h * y.v + h * h / 2 * a0;
  return {q, y.v + h / 2 * (a0 + pendulum(t + h, q))};
}

const std::map<std::string, Step>& textbook() {
  static const std::map<std::string, Step> steps{
      {"explicit_euler",
       [](double t, double h, State2 y) -> State2 {
         return {y.q + h * y.v, y.v + h * pendulum(t, y.q)};
       }},
      {"midpoint",
       [](double t, double h, State2 y) -> State2 {
         const State2 m{y.q + h / 2 * y.v, y.v + h / 2 * pendulum(t, y.q)};
         return {y.q + h * m.v, y.v + h * pendulum(t + h / 2, m.q)};
       }},
      {"heun",
       [](double t, double h, State2 y) -> State2 {
         const double a = pendulum(t, y.q);
         return {y.q + h / 2 * (y.v + y.v + h * a),
                 y.v + h / 2 * (a + pendulum(t + h, y.q + h * y.v))};
       }},
      {"rk4",
       [](double t, double h, State2 y) -> State2 {
         const State2 k1{y.v, pendulum(t, y.q)};
         const State2 k2{y.v + h / 2 * k1.v, pendulum(t + h / 2, y.q + h / 2 * k1.q)};
         const State2 k3{y.v + h / 2 * k2.v, pendulum(t + h / 2, y.q + h / 2 * k2.q)};
         const State2 k4{y.v + h * k3.v, pendulum(t + h, y.q + h * k3.q)};
         return {y.q + h / 6 * (k1.q + 2 * k2.q + 2 * k3.q + k4.q),
                 y.v + h / 6 * (k1.v + 2 * k2.v + 2 * k3.v + k4.v)};
       }},
      {"symplectic_euler",
       [](double t, double h, State2 y) -> State2 {
         const double v = y.v + h * pendulum(t, y.q);
         return {y.q + h * v, v};
       }},
      {"symplectic_euler_position_first",
       [](double t, double h, State2 y) -> State2 {
         const double q = y.q + h * y.v;
         return {q, y.v + h * pendulum(t + h, q)};
       }},
      {"velocity_verlet", verlet},
      {"leapfrog", verlet},
      {"stormer_verlet", verlet},
      {"implicit_euler_linearised",
       [](double t, double h, State2 y) -> State2 {
         // (1 - h^2 a_q) dv = h (a + h a_q v), dq = h (v + dv), all at (t + h, q).
         const double a = pendulum(t + h, y.q), a_q = pendulum_q(t + h, y.q);
         const double dv = h * (a + h * a_q * y.v) / (1 - h * h * a_q);
         return {y.q + h * (y.v + dv), y.v + dv};
       }},
  };
  return steps;
}

TEST(OwnSteps, TakeTheStepOfTheTextbook) {
  const double t = 0.4, h = 0.3;
  const State2 y{1.1, -0.6};
  std::size_t checked = 0;
  for (const Entrant& entrant : own_methods_on({pendulum, pendulum_q, pendulum_t}, t, {y.q, y.v})) {
    if (!entrant.info.fixed) continue;
    const Outcome outcome = entrant.solve(fixed_request(1, {t + h}));
    ASSERT_EQ(outcome.status, Status::ok) << entrant.info.id() << ": " << outcome.detail;
    const auto step = textbook().find(entrant.info.method);
    if (step == textbook().end()) continue;
    const State2 expected = step->second(t, h, y);
    // Some ten roundings of numbers of size one, and for Stormer-Verlet the division by h.
    EXPECT_NEAR(outcome.states[0], expected.q, 3e-15) << entrant.info.id();
    EXPECT_NEAR(outcome.states[1], expected.v, 3e-15) << entrant.info.id();
    ++checked;
  }
  EXPECT_EQ(checked, textbook().size());
}

TEST(OwnSteps, ImplicitEulerSolvesItsEquation) {
  const double t = 0.4, h = 0.3;
  int checked = 0;
  for (const Entrant& entrant :
       own_methods_on({pendulum, pendulum_q, pendulum_t}, t, {1.1, -0.6})) {
    if (entrant.info.method != "implicit_euler" &&
        entrant.info.method != "implicit_euler_fixed_point")
      continue;
    const Outcome outcome = entrant.solve(fixed_request(1, {t + h}));
    ASSERT_EQ(outcome.status, Status::ok);
    const double q = outcome.states[0], v = outcome.states[1];
    // Newton's corrections stop below 1e-13 of the state, those of the fixed point, which contracts
    // by sqrt(2) h = 0.42, below 1e-11.
    const double tolerance = entrant.info.method == "implicit_euler" ? 1e-13 : 1e-11;
    EXPECT_NEAR(q, 1.1 + h * v, tolerance) << entrant.info.id();
    EXPECT_NEAR(v, -0.6 + h * pendulum(t + h, q), tolerance) << entrant.info.id();
    ++checked;
  }
  EXPECT_EQ(checked, 2);
}

/// A Runge-Kutta step by its definition, from the tableau.
template <std::size_t S>
std::array<double, 2> plain_step(const Tableau<S>& tableau, double t, double h,
                                 std::array<double, 2> y) {
  std::array<std::array<double, 2>, S> k{};
  for (std::size_t i = 0; i < S; ++i) {
    std::array<double, 2> argument = y;
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t n = 0; n < 2; ++n) argument[n] += h * tableau.a[i][j] * k[j][n];
    k[i] = {argument[1], pendulum(t + tableau.c(i) * h, argument[0])};
  }
  for (std::size_t i = 0; i < S; ++i)
    for (std::size_t n = 0; n < 2; ++n) y[n] += h * tableau.b[i] * k[i][n];
  return y;
}

TEST(OwnSteps, ExplicitKernelsTakeTheStepOfTheirTableau) {
  const Field problem{pendulum, pendulum_q, pendulum_t};
  const double t = 0.4, h = 0.3;
  int checked = 0;
  methods::All::for_each([&]<class M>() {
    if constexpr (requires { M::tableau.embedded(); }) {
      if (!M::tableau.is_explicit()) return;
      std::array<double, 2> y{1.1, -0.6};
      const auto expected = plain_step(M::tableau, t, h, y);
      typename M::template Stepper<Field> stepper(problem);
      ASSERT_EQ(stepper.step(t, h, y), Status::ok);
      for (std::size_t n = 0; n < 2; ++n)  // weights of up to ten, some tens of roundings
        EXPECT_NEAR(y[n], expected[n], 1e-14) << M::info.id;
      ++checked;
    }
  });
  EXPECT_GE(checked, 9);
}

/// y' = t + y from y(0) = 1 with h = 0.1, worked by hand as in textbooks.
struct Sum {
  static constexpr std::size_t dimension = 1;
  void rhs(double t, const double* y, double* dydt) const { dydt[0] = t + y[0]; }
  void jacobian(double, const double*, double* j) const { j[0] = 1; }
};

template <class M>
double hand_step() {
  const Sum problem;
  typename M::template Stepper<Sum> stepper(problem);
  std::array<double, 1> y{1};
  EXPECT_EQ(stepper.step(0, 0.1, y), Status::ok);
  return y[0];
}

TEST(OwnSteps, AgreeWithStepsWorkedByHand) {
  constexpr double rounding = 5e-16;  // two units in the last place of 1.1
  EXPECT_NEAR(hand_step<methods::explicit_euler>(), 1.1, rounding);
  EXPECT_NEAR(hand_step<methods::midpoint>(), 1.11, rounding);
  EXPECT_NEAR(hand_step<methods::heun>(), 1.11, rounding);
  EXPECT_NEAR(hand_step<methods::rk4>(), 1 + 2.6482 / 24, rounding);  // 1.110341666...
  EXPECT_NEAR(hand_step<methods::implicit_euler>(), 1.01 / 0.9, rounding);
  EXPECT_NEAR(hand_step<methods::implicit_euler_linearised>(), 1.01 / 0.9, rounding);
}

/// q'' = t + q - 2 v: second-order schemes with a velocity-dependent acceleration.
struct Dragged {
  static constexpr std::size_t dimension = 2;
  [[maybe_unused]] static constexpr bool velocity_dependent = true;
  static double a(double t, double q, double v) { return t + q - 2 * v; }
  void acceleration(double t, const double* q, const double* v, double* out) const {
    out[0] = a(t, q[0], v[0]);
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
};

template <class M>
std::array<double, 2> dragged_step(double t, double h, std::array<double, 2> y) {
  const Dragged problem;
  typename M::template Stepper<Dragged> stepper(problem);
  if constexpr (requires { stepper.start(t, h, y); }) stepper.start(t, h, y);
  EXPECT_EQ(stepper.step(t, h, y), Status::ok);
  return y;
}

TEST(OwnSteps, SecondOrderSchemesTakeTheVelocityThatTheySay) {
  const double t = 0.2, h = 0.1, q = 1.5, v = -0.7, a0 = Dragged::a(t, q, v);
  const auto velocity_first = dragged_step<methods::symplectic_euler>(t, h, {q, v});
  EXPECT_DOUBLE_EQ(velocity_first[1], v + h * a0);
  EXPECT_DOUBLE_EQ(velocity_first[0], q + h * (v + h * a0));
  const auto position_first = dragged_step<methods::symplectic_euler_position_first>(t, h, {q, v});
  EXPECT_DOUBLE_EQ(position_first[0], q + h * v);
  EXPECT_DOUBLE_EQ(position_first[1], v + h * Dragged::a(t + h, q + h * v, v));
  const auto verlet = dragged_step<methods::velocity_verlet>(t, h, {q, v});
  const double q1 = q + h * v + h * h / 2 * a0;
  EXPECT_DOUBLE_EQ(verlet[0], q1);
  EXPECT_DOUBLE_EQ(verlet[1], v + h / 2 * (a0 + Dragged::a(t + h, q1, v + h * a0)));
}

TEST(OwnSteps, LeapfrogIsVelocityVerletOnTheUndampedOscillator) {
  const Case& c = find_case("damped_oscillator_undamped");
  const Request request = fixed_request(400, c.stops);
  const Outcome leapfrog = find_entrant(c, "odeum/leapfrog").solve(request);
  const Outcome verlet = find_entrant(c, "odeum/velocity_verlet").solve(request);
  ASSERT_EQ(leapfrog.status, Status::ok);
  ASSERT_EQ(leapfrog.states.size(), verlet.states.size());
  // Two roundings a step of numbers of size 11 at 400 steps, which the oscillator does not damp.
  for (std::size_t i = 0; i < verlet.states.size(); ++i)
    EXPECT_NEAR(leapfrog.states[i], verlet.states[i], 400 * 2 * 11 * 2.3e-16);
}

}  // namespace
}  // namespace odeum::tests::own_steps_test
