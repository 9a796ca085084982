// SPDX-License-Identifier: BSD-3-Clause
// Steps to a tolerance across contacts, kinks and jumps of the right-hand side: no method that
// looks at f only where its stages are may pass one without seeing it.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/own_runs.hpp"

namespace odeum::tests::contact_test {
namespace {

struct Mechanical {
  static constexpr std::size_t dimension = 2;
};

/// A ball on a floor of 1e6 N/m for each kg.
struct Contact : Mechanical {
  void rhs(double, const double* y, double* f) const {
    f[0] = y[1];
    f[1] = -9.81 - (y[0] < 0 ? 1e6 * y[0] : 0);
  }
};
/// The same floor, rounded over 0.1 mm: not the kink is the difficulty.
struct SmoothContact : Mechanical {
  void rhs(double, const double* y, double* f) const {
    f[0] = y[1];
    f[1] = -9.81 + 1e6 * 1e-4 * std::log1p(std::exp(-y[0] / 1e-4));
  }
};
struct ForceThatJumps : Mechanical {
  void rhs(double, const double* y, double* f) const {
    f[0] = y[1];
    f[1] = y[0] > 0.5 ? -50 : 1;
  }
};

/// The same for methods of q'' = a(t, q).
struct ForceOfPosition : ForceThatJumps {
  static constexpr bool velocity_dependent = false;
  void acceleration(double, const double* q, const double*, double* a) const {
    a[0] = q[0] > 0.5 ? -50 : 1;
  }
};

/// The largest error at t = 10, in units of tolerance times amplification times 1 + |y|.
template <class P>
double error_of(const std::string& method, double tolerance, const P& problem,
                const std::vector<double>& start, const std::vector<double>& end,
                double amplification) {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = Tolerance(tolerance, std::vector<double>{tolerance});
  request.stops = {10};
  const Outcome outcome = run_own(method, contest_on(problem, 0, start), request);
  EXPECT_EQ(outcome.status, Status::ok) << method << ": " << outcome.detail;
  double error = 0;
  for (std::size_t i = 0; i < 2 && outcome.status == Status::ok; ++i)
    error = std::fmax(error, std::abs(outcome.states[i] - end[i]) /
                                 (tolerance * amplification * (1 + std::abs(end[i]))));
  return error;
}

class Contacts : public testing::TestWithParam<const char*> {};

// The ends and amplifications are those of tests/outside/switches: event location and DOP853 of
// SciPy at 1e-13. Each of the 20 crossings of the floor, or 8 of the jump, may be off by some tens
// of tolerances, since an estimate of a method is that of smooth problems.
TEST_P(Contacts, AreSeen) {
  for (const double tolerance : {1e-5, 1e-8}) {
    EXPECT_LT(error_of(GetParam(), tolerance, Contact{}, {1, 0},
                       {0.9950168638362482, -0.31268055833816477}, 74.2),
              1e3)
        << tolerance;
    EXPECT_LT(error_of(GetParam(), tolerance, SmoothContact{}, {1, 0},
                       {0.995016876408015, -0.31268016411399424}, 74.2),
              1e3)
        << tolerance;
    EXPECT_LT(error_of(GetParam(), tolerance, ForceThatJumps{}, {0, 1},
                       {-0.3542093586090064, -0.5399826689644951}, 6.19),
              1e3)
        << tolerance;
  }
}

INSTANTIATE_TEST_SUITE_P(, Contacts,
                         testing::Values("radau_iia3", "radau_iia5", "radau_iia9",
                                         "radau_iia_variable", "gauss4", "gauss6", "lobatto_iiic4",
                                         "rodas4", "rk4", "sdirk3", "sdirk4", "cash_karp54_order3"),
                         [](const auto& info) { return std::string(info.param); });

// Their estimates are small where a force jumps between two nodes: they ended ok, off by 5e8 times
// the tolerance.
TEST(ContactsOfPositions, AreSeenByNystroemMethods) {
  for (const char* method : {"dormand_nystroem64", "dormand_nystroem86"})
    for (const double tolerance : {1e-5, 1e-8})
      EXPECT_LT(error_of(method, tolerance, ForceOfPosition{}, {0, 1},
                         {-0.3542093586090064, -0.5399826689644951}, 6.19),
                1e3)
          << method << " at " << tolerance;
}

/// A tank that fills at rate 1 and from 0 on at the root of its level: one long step from before to
/// t = 2 has the slope 1 at both ends.
struct FillingTank {
  static constexpr std::size_t dimension = 1;
  void rhs(double, const double* y, double* f) const { f[0] = y[0] > 0 ? std::sqrt(y[0]) : 1; }
};

TEST(BackwardDifferences, LookIntoTheMiddleOfAStepThatIsMuchLongerThanTheLast) {
  for (const double tolerance : {1e-4, 1e-5, 1e-6}) {
    Request request;
    request.mode = Mode::adaptive;
    request.tolerance = Tolerance(tolerance, std::vector<double>{tolerance});
    request.stops = {2};
    const Outcome outcome =
        run_own("bdf_variable", contest_on(FillingTank(), 0, std::vector<double>{-1}), request);
    // Where h leaves 0 an error of one tolerance grows to its root.
    EXPECT_TRUE(outcome.status != Status::ok ||
                std::abs(outcome.states[0] - 0.25) < 3 * std::sqrt(tolerance))
        << outcome.states[0] << " at " << tolerance;
  }
}

}  // namespace
}  // namespace odeum::tests::contact_test
