// SPDX-License-Identifier: BSD-3-Clause
// Each case's Jacobian, invariants and other capabilities agree with its right-hand side.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>

#include "odeum/cases/text_case.hpp"
#include "support/catalogue.hpp"

namespace odeum::cases_test {
namespace {

/// The states of a case at its start and at every time of its truth.
std::vector<std::pair<double, std::vector<double>>> along(const Case& c) {
  std::vector<std::pair<double, std::vector<double>>> points{{c.t0, c.y0}};
  std::vector<double> times = c.stops;
  times.insert(times.end(), c.settings.timed_stops.begin(), c.settings.timed_stops.end());
  for (const double t : times) {
    std::vector<double> y(c.y0.size());
    if (c.truth.at(t, y.data()) && is_finite(y.data(), y.size())) points.emplace_back(t, y);
  }
  return points;
}

double largest(const std::vector<double>& x) {
  double norm = 0;
  for (const double component : x) norm = std::max(norm, std::abs(component));
  return norm;
}

/// A derivative by central differences with steps of `reach`, and a bound on its error: the
/// rounding of its values, and the change by steps four times smaller, which bounds its truncation.
struct Difference {
  std::vector<double> value, uncertainty;
};
template <class Function>
Difference difference(std::size_t n, double reach, Function&& f) {
  const auto central = [&](double h, std::vector<double>& size) {
    std::vector<double> up(n), down(n), value(n);
    f(h, up.data());
    f(-h, down.data());
    for (std::size_t i = 0; i < n; ++i) {
      value[i] = (up[i] - down[i]) / (2 * h);
      size[i] = std::max(std::abs(up[i]), std::abs(down[i]));
    }
    return value;
  };
  std::vector<double> size(n);
  const std::vector<double> rough = central(reach, size), fine = central(reach / 4, size);
  Difference d{fine, std::vector<double>(n)};
  const double all = largest(size);
  for (std::size_t i = 0; i < n; ++i)
    d.uncertainty[i] = std::abs(fine[i] - rough[i]) + 1e-13 * all / reach;
  return d;
}

/// Checks every case of a kind, of which there is one at least. One test for all of them: made for
/// each test's process, sixty cases would take longer than their checks.
template <class Is, class Check>
void each_case(Is&& is, Check&& check) {
  std::size_t checked = 0;
  for (const Case& c : all_cases()) {
    if (!is(c.problem.view)) continue;
    const testing::ScopedTrace trace(__FILE__, __LINE__, c.id);
    check(c);
    ++checked;
  }
  EXPECT_GT(checked, 0U);
}
constexpr auto any = [](const OdeView&) { return true; };
constexpr auto linear = [](const OdeView& p) { return p.linear_matrix != nullptr; };
constexpr auto with_taylor_series = [](const OdeView& p) { return p.taylor != nullptr; };
constexpr auto with_jacobian = [](const OdeView& p) { return p.jacobian != nullptr; };
constexpr auto of_second_order = [](const OdeView& p) { return p.second_order(); };

// A case is looked for in the texts that have its id in their words, which others are not read for.
TEST(Catalogue, EveryCaseOfATextIsFoundByTheWordsOfThatText) {
  for (const cases::BuiltInText& text : cases::built_in_texts())
    for (const Statement& statement : cases::text_statements(text)) {
      EXPECT_TRUE(text.may_state(statement.id)) << statement.id;
      EXPECT_EQ(cases::built_in_text_of(statement.id), &text) << statement.id;
      EXPECT_TRUE(knows_case(statement.id)) << statement.id;
    }
  EXPECT_FALSE(knows_case("kepler"));
}

TEST(LinearCase, MatrixIsThatOfTheRightHandSide) {
  each_case(linear, [](const Case& c) {
    const OdeView& p = c.problem.view;
    const std::size_t n = p.dimension;
    std::vector<double> a(n * n), y(n), zero(n), f(n), b(n);
    for (std::size_t i = 0; i < n; ++i) y[i] = std::sin(1.0 + static_cast<double>(i));
    p.linear_matrix(p.problem, a.data());
    p.rhs(p.problem, 3, y.data(), f.data());
    p.rhs(p.problem, 0, zero.data(), b.data());
    for (std::size_t i = 0; i < n; ++i) {
      double sum = b[i], size = std::abs(b[i]);
      for (std::size_t j = 0; j < n; ++j) {
        sum += a[i * n + j] * y[j];
        size += std::abs(a[i * n + j] * y[j]);
      }
      EXPECT_NEAR(f[i], sum, 4e-16 * size * static_cast<double>(n + 1))
          << i;  // roundings of the sum
    }
  });
}

// The series satisfies the equation: its derivative by h is the right-hand side there.
TEST(CaseWithTaylorSeries, SolvesTheEquation) {
  each_case(with_taylor_series, [](const Case& c) {
    const OdeView& p = c.problem.view;
    const std::size_t n = p.dimension;
    const std::vector<double>& y0 = c.y0;
    constexpr std::size_t order = 24;
    std::vector<double> series((order + 1) * n), y(n), rate(n), f(n);
    p.taylor(p.problem, 0, y0.data(), order, series.data());
    double largest = 0;
    for (std::size_t i = 0; i < n; ++i)
      largest = std::max(largest, std::abs(series[order * n + i]));
    const double h = 0.2 * std::pow(largest, -1.0 / order);  // a fifth of the radius of convergence
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t k = order + 1; k-- > 0;) {
        y[i] = y[i] * h + series[k * n + i];
        if (k > 0) rate[i] = rate[i] * h + static_cast<double>(k) * series[k * n + i];
      }
    }
    p.rhs(p.problem, h, y.data(), f.data());
    double size = 0;
    for (const double component : f) size = std::max(size, std::abs(component));
    for (std::size_t i = 0; i < n;
         ++i)  // 0.2^24 is negligible; sums of some ten terms of that size
      EXPECT_NEAR(rate[i], f[i], 1e-13 * size) << i;
  });
}

TEST(CaseWithJacobian, IsTheDerivative) {
  each_case(with_jacobian, [](const Case& c) {
    const OdeView& p = c.problem.view;
    const std::size_t n = p.dimension;
    for (const auto& [t, y] : along(c)) {
      std::vector<double> j(n * n);
      p.jacobian(p.problem, t, y.data(), j.data());
      const double most = largest(j);
      std::vector<double> moved = y;
      // A problem of many unknowns has some columns checked, all kinds of neighbours among them.
      const std::size_t stride = n > 200 ? 37 : 1;
      for (std::size_t k = 0; k < n; k += stride) {
        // Components may be tiny where the solution is stiff: steps relative to their own size.
        const double reach = 1e-3 * std::max(std::abs(y[k]), 1e-6 * std::max(1.0, largest(y)));
        const Difference d = difference(n, reach, [&, t = t, &y = y](double h, double* f) {
          moved[k] = y[k] + h;
          p.rhs(p.problem, t, moved.data(), f);
          moved[k] = y[k];
        });
        for (std::size_t i = 0; i < n; ++i) {
          const double entry = j[i * n + k];
          EXPECT_NEAR(entry, d.value[i], d.uncertainty[i] + 1e-9 * std::abs(entry))
              << "d f_" << i << " / d y_" << k << " at t = " << t;
          // So that the test can fail: the bound on a relevant entry is below a tenth of it.
          if (std::abs(entry) > 1e-3 * most && most < 1e9) {
            EXPECT_LT(d.uncertainty[i], 0.1 * std::abs(entry)) << i << ", " << k << " at t = " << t;
          }
        }
      }
    }
  });
}

TEST(EveryCase, TimeDerivativeIsTheDerivative) {
  each_case(any, [](const Case& c) {
    const OdeView& p = c.problem.view;
    const std::size_t n = p.dimension;
    for (const auto& [t, y] : along(c)) {
      std::vector<double> exact(n, 0.0);
      if (p.time_derivative) p.time_derivative(p.problem, t, y.data(), exact.data());
      // A thousandth of the fastest period of any explicit time: 1/(100 pi) s.
      const Difference d = difference(n, 1e-6, [&, t = t, &y = y](double h, double* f) {
        p.rhs(p.problem, t + h, y.data(), f);
      });
      for (std::size_t i = 0; i < n; ++i)
        EXPECT_NEAR(exact[i], d.value[i], d.uncertainty[i] + 1e-9 * std::abs(exact[i]))
            << "t = " << t;
    }
  });
}

TEST(SecondOrderCase, AccelerationIsTheSecondHalfOfTheRightHandSide) {
  each_case(of_second_order, [](const Case& c) {
    const OdeView& p = c.problem.view;
    const std::size_t half = p.degrees_of_freedom;
    ASSERT_EQ(2 * half, p.dimension);
    for (const auto& [t, y] : along(c)) {
      std::vector<double> f(p.dimension), a(half);
      p.rhs(p.problem, t, y.data(), f.data());
      // A separable acceleration takes no velocity.
      p.acceleration(p.problem, t, y.data(), p.velocity_dependent ? y.data() + half : nullptr,
                     a.data());
      for (std::size_t i = 0; i < half; ++i) {
        EXPECT_EQ(f[i], y[half + i]);
        EXPECT_EQ(f[half + i], a[i]);
      }
    }
  });
}

TEST(EveryCase, InvariantsAreKeptByTheReference) {
  each_case(any, [](const Case& c) {
    const auto holds = [&](const std::string& name, const auto& value) {
      const double start = value(c.y0.data());
      double gradient = 0;  // change of the value by a change of the state in its last digit
      for (const auto& [t, y] : along(c)) {
        std::vector<double> moved = y;
        for (std::size_t k = 0; k < y.size(); ++k) {
          const double h = 1e-6 * std::max(1.0, largest(y));
          moved[k] = y[k] + h;
          gradient = std::max(gradient, std::abs(value(moved.data()) - value(y.data())) / h);
          moved[k] = y[k];
        }
      }
      for (const auto& [t, y] : along(c)) {
        // The state is known to its floor and rounded to double; so is the value, a sum of n terms.
        const double floor = std::max(c.truth.floor, c.settings.timed_floor) + 4e-16 * largest(y);
        const auto n = static_cast<double>(y.size());
        EXPECT_NEAR(value(y.data()), start, 4 * n * gradient * floor + 4e-16 * n * std::abs(start))
            << name << " at t = " << t;
      }
    };
    for (const Invariant& invariant : c.invariants) holds(invariant.name, invariant.value);
    // Energy decreases with damping or a cloth's friction.
    if (c.energy && std::ranges::count(c.tags, "separable") > 0) holds("energy", c.energy);
  });
}

TEST(EveryCase, StopsLieOnItsStepsAndAreKnown) {
  each_case(any, [](const Case& c) {
    std::vector<double> y(c.y0.size());
    Request request;
    request.stops = c.stops;
    request.steps = c.settings.steps_multiple;
    if (c.settings.no_fixed_steps.empty()) {
      EXPECT_TRUE(FixedGrid(c.t0, request).fits());
    }
    for (const double t : c.stops) EXPECT_TRUE(c.truth.at(t, y.data())) << t;
    for (const double t : c.settings.timed_stops) EXPECT_TRUE(c.truth.at(t, y.data())) << t;
    EXPECT_EQ(c.settings.coarsest_steps % c.settings.steps_multiple, 0U);
  });
}

// The equation had y1, y2 and y3, and the picture beside it y0 and y2.
TEST(EveryCase, ItsEquationNamesItsStates) {
  const std::regex left("(^|, )([A-Za-z][A-Za-z0-9_]*)'+ =");
  std::size_t found = 0;
  each_case(any, [&](const Case& c) {
    if (c.components.empty()) return;
    for (std::sregex_iterator each(c.equation.begin(), c.equation.end(), left), none; each != none;
         ++each) {
      const std::string name = (*each)[2];
      ++found;
      // q and y stand for all of them; other names are explained by those of the states.
      const bool explained = std::ranges::all_of(c.components, [&](const std::string& state) {
        return c.equation.find(state) != std::string::npos;
      });
      EXPECT_TRUE(name == "q" || name == "y" || explained ||
                  std::count(c.components.begin(), c.components.end(), name) == 1)
          << name << " in " << c.equation;
    }
  });
  EXPECT_GT(found, 20U);
}

}  // namespace
}  // namespace odeum::cases_test
