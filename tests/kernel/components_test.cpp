// SPDX-License-Identifier: BSD-3-Clause
// Kernels handle few components one by one and many as vectors: the steps of all sizes, known at
// compile time or not, are those of the formulas written out in plain loops.
#include "odeum/kernel/components.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "odeum/linear/dense_lu.hpp"
#include "odeum/methods/dormand_nystroem64.hpp"
#include "odeum/methods/dormand_prince54.hpp"
#include "odeum/methods/rodas4.hpp"
#include "odeum/problem/concepts.hpp"

namespace odeum::tests::components_test {
namespace {

/// A ring of n unknowns, or of as many masses with springs that stiffen; N of them, or `dynamic`.
template <std::size_t N>
struct Ring {
  static constexpr std::size_t dimension = N;
  std::size_t unknowns;
  std::size_t size() const { return unknowns; }
  void rhs(double, const double* y, double* f) const {
    const std::size_t n = unknowns;
    for (std::size_t i = 0; i < n; ++i)
      f[i] = y[(i + 1) % n] * y[(i + 1) % n] - y[i] * y[(i + n - 1) % n];
  }
  void jacobian(double, const double* y, double* j) const {
    const std::size_t n = unknowns;
    std::fill(j, j + n * n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      j[i * n + (i + 1) % n] += 2 * y[(i + 1) % n];
      j[i * n + i] -= y[(i + n - 1) % n];
      j[i * n + (i + n - 1) % n] -= y[i];
    }
  }
};
template <std::size_t N>
struct Masses {
  static constexpr std::size_t dimension = N;
  static constexpr bool velocity_dependent = false;
  std::size_t unknowns;
  std::size_t size() const { return unknowns; }
  void acceleration(double, const double* q, const double*, double* a) const {
    const std::size_t n = unknowns / 2;
    for (std::size_t i = 0; i < n; ++i)
      a[i] = q[(i + 1) % n] - 2 * q[i] + q[(i + n - 1) % n] - q[i] * q[i] * q[i];
  }
  void rhs(double t, const double* y, double* f) const {
    second_order_rhs(*this, unknowns / 2, t, y, f);
  }
};

using States = std::vector<std::vector<double>>;
constexpr double h = 0.05;

std::vector<double> start(std::size_t n) {
  std::vector<double> y(n);
  for (std::size_t i = 0; i < n; ++i) y[i] = 1 + 0.5 * std::sin(static_cast<double>(i));
  return y;
}

// The new state and the estimate.
States plain_explicit(std::size_t n) {
  constexpr const auto& T = methods::dormand_prince54::tableau;
  const Ring<dynamic> ring{n};
  States k(T.stages, std::vector<double>(n)), result{start(n), std::vector<double>(n)};
  for (std::size_t i = 0; i < T.stages; ++i) {
    std::vector<double> argument = start(n);
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t c = 0; c < n; ++c) argument[c] += h * T.a[i][j] * k[j][c];
    ring.rhs(0, argument.data(), k[i].data());
  }
  for (std::size_t i = 0; i < T.stages; ++i)
    for (std::size_t c = 0; c < n; ++c) {
      result[0][c] += h * T.b[i] * k[i][c];
      result[1][c] += h * (T.b[i] - T.b_hat[i]) * k[i][c];
    }
  return result;
}

States plain_nystroem(std::size_t n) {
  constexpr const auto& T = methods::dormand_nystroem64::nystroem;
  const Masses<dynamic> masses{n};
  const std::size_t m = n / 2;
  const std::vector<double> y = start(n);
  States a(T.stages, std::vector<double>(m)), result{y, std::vector<double>(n)};
  for (std::size_t i = 0; i < T.stages; ++i) {
    std::vector<double> q(m);
    for (std::size_t c = 0; c < m; ++c) {
      q[c] = y[c] + T.c[i] * h * y[m + c];
      for (std::size_t j = 0; j < i; ++j) q[c] += h * h * T.a[i][j] * a[j][c];
    }
    masses.acceleration(0, q.data(), y.data() + m, a[i].data());
  }
  for (std::size_t c = 0; c < m; ++c) {
    result[0][c] += h * y[m + c];
    for (std::size_t i = 0; i < T.stages; ++i) {
      result[0][c] += h * h * T.b_q[i] * a[i][c];
      result[0][m + c] += h * T.b_v[i] * a[i][c];
      result[1][c] += h * h * (T.b_q[i] - T.b_q_hat[i]) * a[i][c];
      result[1][m + c] += h * (T.b_v[i] - T.b_v_hat[i]) * a[i][c];
    }
  }
  return result;
}

States plain_rosenbrock(std::size_t n) {
  constexpr const auto& T = methods::rodas4::rosenbrock_tableau;
  const Ring<dynamic> ring{n};
  const std::vector<double> y = start(n);
  linear::DenseLu lu(n);
  std::vector<double> jacobian(n * n);
  ring.jacobian(0, y.data(), jacobian.data());
  for (std::size_t i = 0; i < n * n; ++i)
    lu.data()[i] = (i % (n + 1) == 0 ? 1 / (T.gamma * h) : 0) - jacobian[i];
  EXPECT_TRUE(lu.factorise());
  States u(T.stages, std::vector<double>(n)), result{y, std::vector<double>(n)};
  for (std::size_t i = 0; i < T.stages; ++i) {
    std::vector<double> argument = y;
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t c = 0; c < n; ++c) argument[c] += T.a[i][j] * u[j][c];
    ring.rhs(0, argument.data(), u[i].data());
    for (std::size_t j = 0; j < i; ++j)
      for (std::size_t c = 0; c < n; ++c) u[i][c] += T.c[i][j] / h * u[j][c];
    lu.solve(u[i].data());
    for (std::size_t c = 0; c < n; ++c) {
      result[0][c] += T.m[i] * u[i][c];
      result[1][c] += (T.m[i] - T.m_hat[i]) * u[i][c];
    }
  }
  return result;
}

template <class M, class P>
void expect_step(const States& expected) {
  const std::size_t n = expected[0].size();
  const P problem{n};
  typename M::template Stepper<P> stepper(problem);
  State<P> y = make_state(problem), error = y;
  const std::vector<double> y0 = start(n);
  std::copy(y0.begin(), y0.end(), y.begin());
  ASSERT_EQ(stepper.step(0, h, y, error), Status::ok);
  // Sums of up to 7 terms in another order, and elimination of a matrix near the identity.
  for (std::size_t c = 0; c < n; ++c) {
    EXPECT_NEAR(y[c], expected[0][c], 4e-15) << M::info.id << ", component " << c << " of " << n;
    EXPECT_NEAR(error[c], expected[1][c], 4e-15) << M::info.id << ", component " << c;
  }
}

template <class M, template <std::size_t> class P, std::size_t... N>
void expect_steps(States (*plain)(std::size_t), std::index_sequence<N...>) {
  (expect_step<M, P<N>>(plain(N)), ...);
  for (const std::size_t n : {N...}) expect_step<M, P<dynamic>>(plain(n));
}

TEST(Components, AStepIsThatOfThePlainFormulasForEverySize) {
  expect_steps<methods::dormand_prince54, Ring>(plain_explicit,
                                                std::index_sequence<1, 2, 3, 4, 8, 12, 13, 28>());
  expect_steps<methods::dormand_nystroem64, Masses>(plain_nystroem,
                                                    std::index_sequence<2, 4, 6, 24, 26>());
  expect_steps<methods::rodas4, Ring>(plain_rosenbrock, std::index_sequence<1, 2, 3, 5, 8, 13>());
}

TEST(Components, EachIsVisitedOnce) {
  const auto check = [](const auto& state) {
    std::vector<int> visits(state.size(), 0);
    each_component(state, [&](std::size_t n) { ++visits[n]; });
    EXPECT_EQ(visits, std::vector<int>(state.size(), 1));
    EXPECT_EQ(sum_of_components(state, [](std::size_t n) { return static_cast<double>(n); }),
              static_cast<double>(state.size() * (state.size() - 1)) / 2);
  };
  check(std::array<double, few_components>{});
  check(std::array<double, few_components + 1>{});
  for (const std::size_t n : {std::size_t{1}, few_components, few_components + 1})
    check(std::vector<double>(n));
}

}  // namespace
}  // namespace odeum::tests::components_test
