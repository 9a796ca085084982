// SPDX-License-Identifier: BSD-3-Clause
// The measurement on multistep methods, whose limits are textbook values, implemented here as plain
// loops in place of a library's solver.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numeric>
#include <vector>

#include "odeum/judge/stability_search.hpp"
#include "odeum/measure/growth_meter.hpp"

namespace odeum::study::multistep_test {
namespace {

using Complex = std::complex<double>;

/// y_{n+1} = sum_j (alpha_j + z beta_j) y_{n-j} / (1 - z beta_new), started with the exact solution
/// or, as libraries do, with one-step methods of lower order.
struct LinearMultistep {
  std::vector<double> alpha, beta;
  double beta_new = 0;
};

struct Stage {
  std::shared_ptr<Complex> z = std::make_shared<Complex>();
  Probe probe;

  explicit Stage(LinearMultistep method) {
    probe.place = [z = z](double re, double im) { *z = {re, im}; };
    Entrant entrant;
    entrant.info.family = "multistep";
    entrant.solve = [z = z, method](const Request& request) { return solve(method, *z, request); };
    probe.entrants.add(entrant);
  }

  static Outcome solve(const LinearMultistep& method, Complex z, const Request& request) {
    Outcome outcome;
    std::vector<Complex> y{1};  // newest first
    const auto taylor4 = 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
    std::size_t stop = 0;
    for (std::uint64_t i = 1; i <= request.steps; ++i) {
      Complex next = 0;
      if (y.size() < method.alpha.size()) {
        next = taylor4 * y.front();
      } else {
        for (std::size_t j = 0; j < y.size(); ++j)
          next += (method.alpha[j] + z * method.beta[j]) * y[j];
        next /= 1.0 - z * method.beta_new;
        y.pop_back();
      }
      y.insert(y.begin(), next);
      if (request.stops[stop] == static_cast<double>(i)) {
        const double state[]{next.real(), next.imag()};
        outcome.record(request.stops[stop++], state, 2);
      }
    }
    if (!std::isfinite(std::abs(y.front()))) outcome.status = Status::non_finite;
    return outcome;
  }

  judge::LimitFound limit(double re, double im) const {
    measure::GrowthMeter meter(probe, probe.entrants[0], false, measure::limit_length);
    return judge::find_limit([&](double x) { return meter.measure(re * x, im * x); });
  }
};

// Limits are quoted to 1e-6; closer, the two largest roots of a multistep method are of nearly
// equal modulus, and only ever longer runs separate them.
constexpr double quoted = 1e-6;

const LinearMultistep adams_bashforth2{{1, 0}, {3. / 2, -1. / 2}};
const LinearMultistep adams_bashforth3{{1, 0, 0}, {23. / 12, -16. / 12, 5. / 12}};
const LinearMultistep adams_bashforth4{{1, 0, 0, 0}, {55. / 24, -59. / 24, 37. / 24, -9. / 24}};

TEST(Multistep, AdamsBashforthOnTheRealAxis) {
  // -2/sum |b_j| of the coefficients: 1, 6/11, 3/10 (Hairer, Wanner, Solving ODEs II, V.1).
  EXPECT_NEAR(Stage(adams_bashforth2).limit(-1, 0).limit, 1, quoted);
  EXPECT_NEAR(Stage(adams_bashforth3).limit(-1, 0).limit, 6. / 11, quoted);
  EXPECT_NEAR(Stage(adams_bashforth4).limit(-1, 0).limit, 3. / 10, quoted);
}

TEST(Multistep, AdamsBashforth2HasNoLimitOnTheImaginaryAxis) {
  EXPECT_EQ(Stage(adams_bashforth2).limit(0, 1).limit, 0);
}

TEST(Multistep, AdamsBashforth3OnTheImaginaryAxis) {
  // Where the boundary locus z = (r - 1) r^2 / (23/12 r^2 - 16/12 r + 5/12), |r| = 1, meets the
  // imaginary axis again: y = 12 / (5 sqrt(11)) = 0.7236.
  EXPECT_NEAR(Stage(adams_bashforth3).limit(0, 1).limit, 12 / (5 * std::sqrt(11.0)), quoted);
}

TEST(Multistep, ExplicitMidpointIsNeutralUpToOne) {
  // y_{n+1} = y_{n-1} + 2 z y_n on z = iy: both roots have modulus 1 up to y = 1.
  EXPECT_NEAR(Stage({{0, 1}, {2, 0}}).limit(0, 1).limit, 1, quoted);
}

TEST(Multistep, ExplicitMidpointGrowsOnTheRealAxis) {
  // The root that grows, -(x + sqrt(1 + x^2)), is excited by the start to the order of x^5 only:
  // within a run of 64 steps it becomes measurable at some 5e-3, not at zero, hence the tolerance.
  const double limit = Stage({{0, 1}, {2, 0}}).limit(-1, 0).limit;
  EXPECT_LT(limit, 2e-2);
}

TEST(Multistep, BackwardDifferences2IsAStable) {
  Stage bdf2({{4. / 3, -1. / 3}, {0, 0}, 2. / 3});
  EXPECT_EQ(bdf2.limit(-1, 0).limit, std::numeric_limits<double>::infinity());
  EXPECT_EQ(bdf2.limit(0, 1).limit, std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace odeum::study::multistep_test
