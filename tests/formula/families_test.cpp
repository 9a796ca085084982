// SPDX-License-Identifier: BSD-3-Clause
// Families of states are compiled as loops: the same values as those of the interpreter, and a text
// that does not grow with the family.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/formula/text_ode.hpp"

namespace odeum::families_test {
namespace {

using formula::TextOde;

/// u[1] + ... + u[n], which all equations share.
std::string sum_of_all(int n) {
  std::string sum = "u[1]";
  for (int i = 2; i <= n; ++i) sum += fmt::format(" + u[{}]", i);
  return sum;
}

std::vector<std::string> families() {
  const std::string ends = "boundaries: {u[0]: 0, u[n+1]: 1}\ntime: {end: 1}\n";
  return {
      // Constants that differ by index, and an even distance in reverse.
      "parameters: {n: 60}\nstates: {u[1..n]: 1/i}\n"
      "equations: {u[1..n]: i^2*(u[i-1] - 2*u[i] + u[i+1]) + u[n+1-i]}\n" +
          ends,
      // Two families, functions that two rows share, and the time.
      "parameters: {n: 50}\nstates: {u[1..n]: 1 + i/n, v[1..n]: 2}\n"
      "equations: {u[1..n]: u[i-1] - u[i] + v[i]*exp(-1/u[i])*sin(t), "
      "v[1..n]: -v[i]*exp(-1/u[i])*sin(t) + cos(i*t)}\n" +
          ends,
      // What all rows share.
      "parameters: {n: 40}\ndefinitions: {mean: (" + sum_of_all(40) +
          ")/n}\nstates: {u[1..n]: 2 + sin(i)}\n"
          "equations: {u[1..n]: sqrt(2 + mean^2)*u[i+1] - mean*u[i-1]*u[i]^1.5}\n" +
          ends,
      // Second order.
      "parameters: {n: 70}\nstates: {u[1..n]: sin(i), v[1..n]: 0}\n"
      "equations: {u[1..n]: v[i], "
      "v[1..n]: sin(u[i+1] - u[i]) - sin(u[i] - u[i-1]) - 0.1*v[i]*abs(v[i])}\n" +
          ends,
      // Conditions.
      "parameters: {n: 45}\nstates: {u[1..n]: i}\n"
      "equations: {u[1..n]: \"if(u[i] > 20, min(u[i-1], u[i+1]), max(u[i], t))\"}\n" +
          ends,
  };
}

/// Both round each operation; contracted to fused ones in the compiled code, of terms that may
/// cancel.
void expect_near(const std::vector<double>& a, const std::vector<double>& b, const char* what) {
  double largest = 0;
  for (const double x : b) largest = std::max(largest, std::abs(x));
  EXPECT_GT(largest, 0) << what;
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_NEAR(a[k], b[k], 1e-14 * largest) << what << ' ' << k;
}

TEST(Families, CompiledAsInterpreted) {
  for (const std::string& text : families()) {
    SCOPED_TRACE(text);
    const TextOde compiled(formula::read_problem("f", text));
    if (compiled.how().find("interpreted") != std::string::npos) GTEST_SKIP() << compiled.how();
    const TextOde plain(formula::read_problem("f", text), TextOde::Code::interpreted);
    const OdeView &a = compiled.view(), &b = plain.view();
    const std::size_t n = compiled.size();
    std::vector<double> y(n), f(n), g(n);
    for (std::size_t i = 0; i < n; ++i) y[i] = 1.5 + std::sin(static_cast<double>(3 * i));
    a.rhs(a.problem, 0.7, y.data(), f.data());
    b.rhs(b.problem, 0.7, y.data(), g.data());
    expect_near(f, g, "rhs");
    std::vector<double> j(n * n), k(n * n);
    a.jacobian(a.problem, 0.7, y.data(), j.data());
    b.jacobian(b.problem, 0.7, y.data(), k.data());
    expect_near(j, k, "jacobian");
    ASSERT_EQ(a.time_derivative == nullptr, b.time_derivative == nullptr);
    if (a.time_derivative) {
      a.time_derivative(a.problem, 0.7, y.data(), f.data());
      b.time_derivative(b.problem, 0.7, y.data(), g.data());
      expect_near(f, g, "time derivative");
    }
    ASSERT_EQ(a.acceleration == nullptr, b.acceleration == nullptr);
    if (a.acceleration) {
      f.assign(n / 2, 0);
      g = f;
      a.acceleration(a.problem, 0.7, y.data(), y.data() + n / 2, f.data());
      b.acceleration(b.problem, 0.7, y.data(), y.data() + n / 2, g.data());
      expect_near(f, g, "acceleration");
    }
    std::vector<long double> x(y.begin(), y.end()), p(n * n), q(n * n);
    compiled.jacobian_extended(0.7L, x.data(), p.data());
    plain.jacobian_extended(0.7L, x.data(), q.data());
    for (std::size_t i = 0; i < p.size(); ++i)
      EXPECT_LE(std::abs(p[i] - q[i]), 1e-17L * (1 + std::abs(q[i])) * 100) << i;
  }
}

TEST(Families, TheTextDoesNotGrowWithThem) {
  const auto length = [](int n) {
    formula::Problem problem = formula::read_problem(
        "f", fmt::format("parameters: {{n: {}}}\nstates: {{u[1..n]: 1, v[1..n]: 3}}\n"
                         "equations: {{u[1..n]: 1 + u[i]^2*v[i] - 4*u[i] + 0.02*(u[i-1] - 2*u[i] + "
                         "u[i+1]), v[1..n]: 3*u[i] - u[i]^2*v[i] + 0.02*(v[i-1] - 2*v[i] + "
                         "v[i+1])}}\nboundaries: {{u[0]: 1, v[0]: 3, u[n+1]: 1, v[n+1]: 3}}\n"
                         "time: {{end: 1}}\n",
                         n));
    const formula::Analysis analysis = formula::analyse(problem);
    return formula::print_c(problem, analysis).size();
  };
  // Where entries of the Jacobian stand is a table: two of them, of 8 entries for a cell and of at
  // most 7 characters each.
  const std::size_t few = length(1000), many = length(2000);
  EXPECT_LE(many - few, 2 * 1000 * 8 * 7U);
  EXPECT_LT(many, 300'000U);
}

}  // namespace
}  // namespace odeum::families_test
