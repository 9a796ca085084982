// SPDX-License-Identifier: BSD-3-Clause
// Symplectic splittings of q'' = a(t, q): order, conditions, structure, cost.
#include <gtest/gtest.h>

#include <cmath>

#include "support/second_order_methods.hpp"

namespace odeum::tests::splitting_test {
namespace {

TEST(Splitting, HasTheOrderThatItClaimsAlsoWhereTimeAppears) {
  int checked = 0;
  for_each_splitting([&]<class M>() {
    expect_claimed_order<M>();
    ++checked;
  });
  EXPECT_GE(checked, 9);
}

TEST(Splitting, ConditionsSeeEveryCoefficient) {
  for_each_splitting([&]<class M>() {
    constexpr const auto& good = M::splitting;
    using Rows = std::remove_cvref_t<decltype(good)>;
    const auto accepted = [](const Rows& s) {
      const auto n = s.as_nystroem();
      return std::abs(s.c(s.stages - 1) + s.drift.back() - 1) < order_rounding &&
             order_fault(n, n.b_q, n.b_v, s.order).order == 0;
    };
    ASSERT_TRUE(accepted(good));
    for (std::size_t i = 0; i < good.stages; ++i)
      for (const bool kick : {true, false}) {
        Rows mutant = good;
        double& value = (kick ? mutant.kick : mutant.drift)[i];
        if (value == 0) continue;
        value += 1e-6;
        EXPECT_FALSE(accepted(mutant)) << M::info.id << (kick ? " kick " : " drift ") << i;
      }
  });
}

/// d(end)/d(start) of one step, by central differences of Kepler's problem.
template <class M>
std::array<std::array<double, 4>, 4> derivative(const State<Kepler>& y, double h) {
  const Kepler problem;
  std::array<std::array<double, 4>, 4> d{};
  constexpr double epsilon = 1e-5;
  for (std::size_t j = 0; j < 4; ++j) {
    State<Kepler> ends[2];
    for (const int side : {0, 1}) {
      State<Kepler> moved = y;
      moved[j] += side == 0 ? -epsilon : epsilon;
      typename M::template Stepper<Kepler> stepper(problem);
      if constexpr (requires { stepper.start(0, h, moved); }) stepper.start(0, h, moved);
      stepper.step(0, h, moved);
      ends[side] = moved;
    }
    for (std::size_t i = 0; i < 4; ++i) d[i][j] = (ends[1][i] - ends[0][i]) / (2 * epsilon);
  }
  return d;
}

template <class M>
double symplectic_defect() {
  const auto d = derivative<M>(Kepler::exact(0.4), 0.3);
  double worst = 0;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      double form = 0;  // sum over degrees of freedom of dq ^ dv
      for (const std::size_t k : {0U, 1U}) form += d[k][i] * d[k + 2][j] - d[k + 2][i] * d[k][j];
      const double expected = j == i + 2 ? 1 : i == j + 2 ? -1 : 0;
      worst = std::max(worst, std::abs(form - expected));
    }
  return worst;
}

TEST(Splitting, KeepsTheSymplecticForm) {
  // Differences of steps of 1e-5: 1e-10 times third derivatives of some tens, doubled by products.
  for_each_splitting([&]<class M>() { EXPECT_LT(symplectic_defect<M>(), 5e-8) << M::info.id; });
  EXPECT_GT(symplectic_defect<methods::rk4>(), 1e-6) << "the measure sees what is not symplectic";
}

TEST(Splitting, UndoesItsStepWhereItIsSymmetric) {
  int symmetric = 0;
  for_each_splitting([&]<class M>() {
    const Driven problem;
    const double t = 0.4, h = 0.3;
    const State<Driven> y0{0.8, -0.5};
    State<Driven> y = y0;
    for (const double sign : {1, -1}) {
      typename M::template Stepper<Driven> stepper(problem);
      const double from = sign > 0 ? t : t + h;
      if constexpr (requires { stepper.start(from, sign * h, y); })
        stepper.start(from, sign * h, y);
      stepper.step(from, sign * h, y);
    }
    if (M::splitting.symmetric()) {
      EXPECT_LT(distance(y, y0), 1e-14) << M::info.id;  // some tens of roundings of size one
      ++symmetric;
    } else {
      EXPECT_GT(distance(y, y0), 1e-8) << M::info.id;
    }
  });
  EXPECT_GE(symmetric, 6);
}

struct Oscillator {
  static constexpr std::size_t dimension = 2;
  [[maybe_unused]] static constexpr bool velocity_dependent = false;
  double w;
  void acceleration(double, const double* q, const double*, double* a) const {
    a[0] = -w * w * q[0];
  }
  void rhs(double t, const double* y, double* dydt) const {
    second_order_rhs(*this, 1, t, y, dydt);
  }
};

template <class M>
void expect_map_to_be_the_step(double w) {
  const Oscillator problem{w};
  const OscillatorMap map = M::oscillator_map(w);
  for (const std::size_t column : {0U, 1U}) {
    State<Oscillator> y{column == 0 ? 1 / w : 0, column == 1 ? 1.0 : 0};
    typename M::template Stepper<Oscillator> stepper(problem);
    if constexpr (requires { stepper.start(0, 1, y); }) stepper.start(0, 1, y);
    stepper.step(0, 1, y);
    // Some tens of roundings of products of coefficients of up to ten.
    EXPECT_NEAR(w * y[0], map[column], 1e-12) << M::info.id;
    EXPECT_NEAR(y[1], map[2 + column], 1e-12) << M::info.id;
  }
}

TEST(OscillatorMap, IsTheStepOnTheOscillator) {
  for (const double w : {0.3, 1.7}) {
    for_each_splitting([&]<class M>() {
      expect_map_to_be_the_step<M>(w);
      const OscillatorMap m = M::oscillator_map(w);
      EXPECT_NEAR(m[0] * m[3] - m[1] * m[2], 1, 1e-12) << M::info.id << ": an area";
    });
    for_each_nystroem([&]<class M>() { expect_map_to_be_the_step<M>(w); });
  }
}

struct Counted : Kepler {
  int* count;
  void acceleration(double t, const double* q, const double* v, double* a) const {
    ++*count;
    Kepler::acceleration(t, q, v, a);
  }
};

template <class M>
int evaluations_of_ten_steps() {
  int count = 0;
  const Counted problem{{}, &count};
  typename M::template Stepper<Counted> stepper(problem);
  State<Counted> y = Kepler::exact(0);
  if constexpr (requires { stepper.start(0, 0.1, y); }) stepper.start(0, 0.1, y);
  for (int i = 0; i < 10; ++i) stepper.step(0.1 * i, 0.1, y);
  return count;
}

TEST(Splitting, SharesTheKickBetweenSteps) {
  EXPECT_EQ(evaluations_of_ten_steps<methods::yoshida4>(), 1 + 10 * 3);
  EXPECT_EQ(evaluations_of_ten_steps<methods::suzuki4>(), 1 + 10 * 5);
  EXPECT_EQ(evaluations_of_ten_steps<methods::yoshida6>(), 1 + 10 * 7);
  EXPECT_EQ(evaluations_of_ten_steps<methods::yoshida8>(), 1 + 10 * 15);
  EXPECT_EQ(evaluations_of_ten_steps<methods::blanes_moan4>(), 1 + 10 * 6);
  EXPECT_EQ(evaluations_of_ten_steps<methods::blanes_moan6>(), 1 + 10 * 11);
  EXPECT_EQ(evaluations_of_ten_steps<methods::mclachlan_atela4>(), 10 * 4);
}

}  // namespace
}  // namespace odeum::tests::splitting_test
