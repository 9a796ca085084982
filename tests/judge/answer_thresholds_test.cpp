// SPDX-License-Identifier: BSD-3-Clause
// Answers of runs whose absolute tolerances matter: components far below 1.
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>

#include "odeum/cases/set_problem.hpp"
#include "odeum/judge/answer.hpp"
#include "support/catalogue.hpp"

namespace odeum::tests::answer_thresholds_test {
namespace {

using judge::Answer;

judge::JudgedAnswer judged_run(const Case& c, const char* solver, double relative,
                               double absolute) {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = {relative, absolute};
  request.stops = c.stops;
  const Outcome outcome = find_entrant(c, solver).solve(request);
  EXPECT_EQ(outcome.status, Status::ok) << solver << ' ' << outcome.detail;
  if (outcome.status != Status::ok) return {};
  const judge::Judge judge(c, c.stops);
  return judge::judge_answer(
      judge.errors(outcome), judge::measure_amplification(c, c.stops, request.tolerance), relative,
      static_cast<double>(outcome.counters.steps), c.truth.floor, judge.scale());
}

// With an absolute tolerance far above the second species the first one becomes negative, where the
// reaction runs away: the run ends ok with 1.9e8 instead of 0.
TEST(Answer, OfOneNumberAsBothTolerancesOnRobertsonsReactionIsWrong) {
  const Case& c = find_case("robertson");
  for (const double tolerance : {1e-3, 1e-5}) {
    const judge::JudgedAnswer judged = judged_run(c, "odeum/trapezoidal", tolerance, tolerance);
    EXPECT_EQ(judged.answer, Answer::wrong) << tolerance << ' ' << judged.reason;
    EXPECT_NE(judged.reason.find("an error of 1.9e+08"), std::string::npos) << judged.reason;
  }
  const judge::JudgedAnswer judged = judged_run(c, "odeum/radau_iia5", 1e-5, 1e-10);
  EXPECT_EQ(judged.answer, Answer::explained) << judged.reason;
  EXPECT_LT(judged.explained, 0.05);  // 100 tolerances, of three components of the size of 1
}

/// E5 of stiff DETEST: components between 1e-3 and 1e-23, the second of which decays to the value
/// of reports/findings.md.
struct E5 {
  static constexpr std::size_t dimension = 4;
  void rhs(double, const double* y, double* f) const {
    const double first = 7.89e-10 * y[0], second = 1.1e7 * y[0] * y[2],
                 third = 1.13e9 * y[1] * y[2], fourth = 1.13e3 * y[3];
    f[0] = -first - second;
    f[1] = first - third;
    f[2] = first - second - third + fourth;
    f[3] = second - fourth;
  }
  void jacobian(double, const double* y, double* j) const {
    const double a = 7.89e-10, b = 1.1e7, c = 1.13e3, mc = 1.13e9;
    const double rows[16] = {-a - b * y[2],
                             0,
                             -b * y[0],
                             0,
                             a,
                             -mc * y[2],
                             -mc * y[1],
                             0,
                             a - b * y[2],
                             -mc * y[2],
                             -b * y[0] - mc * y[1],
                             c,
                             b * y[2],
                             0,
                             b * y[0],
                             -c};
    std::copy(std::begin(rows), std::end(rows), j);
  }
};

// A tolerance of 1e-6 promises nothing of components of 1e-23: relative to them the error of each
// solver is above 1e13, and it is a hundredth of the tolerance. Absolute tolerances below the
// components do promise, and the judge measures by them.
TEST(Answer, OnE5IsJudgedByTheAbsoluteToleranceAsked) {
  Case c;
  c.id = "e5";
  c.y0 = {1.76e-3, 0, 0, 0};
  c.stops = {1e13};
  c.truth.at = [](double, double* y) {
    y[0] = y[3] = 0;  // below 1e-3429, and 1e-14 of that
    y[1] = y[2] = 8.86123352129108e-23;
    return true;
  };
  cases::set_problem(c, E5{});
  const judge::Judge judge(c, c.stops);
  for (const Entrant& entrant : c.entrants) {
    const std::string id = entrant.info.id();
    if (id != "odeum/rodas4" && id != "odeint/rosenbrock4_dense_output") continue;
    const auto run = [&](double absolute) {
      Request request;
      request.mode = Mode::adaptive;
      request.tolerance = {1e-6, absolute};
      request.stops = c.stops;
      return entrant.solve(request);
    };
    const Outcome loose = run(1e-6), tight = run(1e-24);
    ASSERT_EQ(loose.status, Status::ok) << id << loose.detail;
    ASSERT_EQ(tight.status, Status::ok) << id << tight.detail;
    const double of_loose = judge.errors(loose)[0].error_max,
                 of_tight = judge.errors(tight)[0].error_max;
    EXPECT_GT(of_loose / 8.86123352129108e-23, 1e13) << id;
    EXPECT_LT(of_loose, 1e-6) << id;
    EXPECT_LT(of_tight, 1e-18) << id;
    const judge::JudgedAnswer judged = judge::judge_answer(
        judge.errors(tight), judge::measure_amplification(c, c.stops, Tolerance(1e-6, 1e-24)), 1e-6,
        static_cast<double>(tight.counters.steps), 0, judge.scale());
    EXPECT_EQ(judged.answer, Answer::explained) << id << ' ' << judged.reason;
    EXPECT_LT(judged.explained, 1e-9) << id;  // 100 tolerances of what is left at the end
  }
}

}  // namespace
}  // namespace odeum::tests::answer_thresholds_test
