// SPDX-License-Identifier: BSD-3-Clause
// until_event and at_events: every zero within long steps, by methods of each kind.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "odeum/api/integrate.hpp"
#include "odeum/methods/bdf_variable.hpp"
#include "odeum/methods/bogacki_shampine32.hpp"
#include "odeum/methods/dormand_prince54.hpp"
#include "odeum/methods/dormand_prince853.hpp"
#include "odeum/methods/gragg_bulirsch_stoer.hpp"
#include "odeum/methods/rk4.hpp"
#include "odeum/methods/rodas4.hpp"
#include "odeum/methods/sdirk4.hpp"
#include "odeum/methods/seulex.hpp"
#include "support/cubic.hpp"

namespace odeum::tests::events_test {
namespace {

double height(double, const State1& y) { return y[0]; }

/// From any start the roots that follow, each found from where the run before it ended.
template <class Method, class Steps>
void expect_roots(Steps steps, double within) {
  const std::array<double, 3> roots{-6, -2, 2};
  for (const double start : {-100.0, -7.5, -6.0, -5.9, -3.0, -2.0, -1.9, 0.0, 1.9, 2.0, 3.0}) {
    SCOPED_TRACE(testing::Message() << Method::info.id << " from " << start);
    State1 y{Cubic::at(start)};
    double t = start;
    for (const double root : roots) {
      if (root <= start) continue;
      const RunEnd run = integrate(Cubic{}, Method{}, y, t, 50, steps, until_event(height));
      ASSERT_TRUE(run.ok() && run.event);
      EXPECT_NEAR(run.t, root, within);
      t = run.t;
    }
    const RunEnd rest = integrate(Cubic{}, Method{}, y, t, 50, steps, until_event(height));
    EXPECT_FALSE(rest.event);

    std::vector<double> times;
    y = {Cubic::at(start)};
    integrate(Cubic{}, Method{}, y, start, 50, steps,
              at_events(height, [&](double time, const State1&) { times.push_back(time); }));
    std::size_t k = 0;
    for (const double root : roots) {
      if (root <= start) continue;
      ASSERT_LT(k, times.size());
      EXPECT_NEAR(times[k++], root, within);
    }
    EXPECT_EQ(k, times.size());
  }
}

// Methods of order 3 and above have no error on a cubic but rounding, of 1e6 at the start.
TEST(Events, AllRootsOfACubicByMethodsOfEachKind) {
  using namespace methods;
  expect_roots<dormand_prince54>(Tolerance{1e-6}, 1e-9);
  expect_roots<dormand_prince853>(Tolerance{1e-6}, 1e-9);
  expect_roots<bogacki_shampine32>(Tolerance{1e-6}, 1e-9);
  expect_roots<gragg_bulirsch_stoer>(Tolerance{1e-6}, 1e-9);
  expect_roots<sdirk4>(Tolerance{1e-6}, 1e-9);
  expect_roots<rodas4>(Tolerance{1e-6}, 1e-4);  // df/dt by differences
  expect_roots<seulex>(Tolerance{1e-8}, 1e-4);
  expect_roots<bdf_variable>(Tolerance{1e-10}, 1e-4);
  expect_roots<rk4>(Step{30}, 1e-9);
  expect_roots<dormand_prince54>(Step{200}, 1e-9);
}

/// A falling body: y'' = -10 from height 0.45, thrown up at 3 m/s.
struct Falling {
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = y[1];
    dydt[1] = -10;
  }
};
using State2 = std::array<double, 2>;

TEST(Events, HaveADirectionAndTouchesHaveNone) {
  // The height is 0.9 at its highest, at t = 0.3.
  const auto above = [](double level) {
    return [level](double, const State2& y) { return y[0] - level; };
  };
  const auto run = [&](double level, Crossing crossing) {
    State2 y{0.45, 3};
    return integrate(Falling{}, methods::dormand_prince54{}, y, 0, 2, Tolerance{1e-8},
                     until_event(above(level), crossing));
  };
  EXPECT_NEAR(run(0.85, Crossing::rising).t, 0.2, 1e-12);
  EXPECT_NEAR(run(0.85, Crossing::falling).t, 0.4, 1e-12);
  EXPECT_NEAR(run(0.85, Crossing::any).t, 0.2, 1e-12);
  EXPECT_NEAR(run(0.9, Crossing::any).t, 0.3, 1e-6);  // rounding hides the top within 1e-8
  EXPECT_FALSE(run(0.91, Crossing::any).event);
}

TEST(Events, ABallBouncesFromEventToEvent) {
  State2 y{1, 0};
  double t = 0;
  double flight = 2 * std::sqrt(0.2), hit = flight / 2;
  for (int bounce = 0; bounce < 30; ++bounce) {
    const RunEnd run =
        integrate(Falling{}, methods::dormand_prince54{}, y, t, 10, Tolerance{1e-8},
                  until_event([](double, const State2& s) { return s[0]; }, Crossing::falling));
    ASSERT_TRUE(run.event) << bounce;
    EXPECT_NEAR(run.t, hit, 1e-12);
    t = run.t;
    y = {0, -0.7 * y[1]};
    flight *= 0.7, hit += flight;
  }
}

}  // namespace
}  // namespace odeum::tests::events_test
