// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <sstream>

#include "odeum/cases/text_case.hpp"
#include "support/catalogue.hpp"

namespace odeum::sweep::sweep_test {
namespace {

Case case_of_text(const std::string& text) {
  return case_of(cases::text_statements("sweep.yaml", text, "sweep_test").front());
}

Request adaptive(const Case& c, double tolerance) {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = tolerance;
  request.stops = {c.stops.back()};
  return request;
}

/// The state at the end with these parameters: in place, and as a case of its own.
void expect_same(const Case& c, const std::string& solver, const std::vector<double>& values) {
  const std::optional<Family> family = c.family({values});
  ASSERT_TRUE(family) << c.id;
  family->place(values);
  const Case own = c.with_values(values, {});
  const Outcome in_place = family->entrants.find(solver)->solve(adaptive(c, 1e-9)),
                alone = own.entrants.find(solver)->solve(adaptive(c, 1e-9));
  ASSERT_EQ(in_place.status, Status::ok) << c.id << ": " << in_place.detail;
  ASSERT_EQ(in_place.states.size(), alone.states.size());
  // Constants are folded in extended precision in one and computed in double in the other: some
  // units in the last place of each evaluation, which these problems amplify a hundredfold at most.
  for (std::size_t i = 0; i < alone.states.size(); ++i)
    EXPECT_NEAR(in_place.states[i], alone.states[i], 1e-9 * (1 + std::abs(alone.states[i])))
        << c.id << " " << i;
  if (own.energy) {
    EXPECT_NEAR(family->energy(alone.states.data()), own.energy(alone.states.data()), 1e-12);
  }
}

TEST(SweepFamily, OfABuiltInTextIsTheCaseWithThoseValues) {
  expect_same(tests::find_case("lotka_volterra"), "odeum/dormand_prince54",
              {0.7, 1.1, 0.9, 1.3, 0.8, 1.2});
  expect_same(tests::find_case("vdp_mu1"), "odeum/rodas4", {20, 1.5, 0.5});
}

// Constants that follow from parameters, functions of them, sums over an index, and rows of one
// form, which are printed as loops.
constexpr const char* many_constants = R"(
parameters: {k: 2, d: 0.3, p: 2.5, n0: 1}
definitions:
  half: k/2 + sin(d)
  rate: if(k > 3, k*d, d)
states: {"u[1..12]": n0*i/12, x: k - 1, v: 0}
equations:
  "u[1..12]": rate*(u[i-1] - 2*u[i] + u[i+1]) - half*0.01*u[i]^p
  x: v
  v: -k*x - d*v + exp(-half)
boundaries: {"u[0]": n0, "u[13]": d}
time: {end: 2}
)";

TEST(SweepFamily, OfAUsersTextFollowsItsConstants) {
  const Case c = case_of_text(many_constants);
  ASSERT_EQ(c.parameters.size(), 4U);  // d, k, n0, p
  expect_same(c, "odeum/dormand_prince54", {0.3, 2, 1, 2.5});
  expect_same(c, "odeum/dormand_prince54", {0.1, 4, 0.5, 1.5});
  expect_same(c, "odeum/radau_iia5", {0.2, 3.5, 2, 3});
}

TEST(SweepFamily, IsNotMadeWhereValuesMoveTheEndOrTheSize) {
  const Case end =
      case_of_text("parameters: {k: 2}\nstates: {x: 1}\nequations: {x: -k*x}\ntime: {end: 2*k}\n");
  EXPECT_FALSE(end.family({{2}, {3}}));
  EXPECT_TRUE(end.family({{2}}));
  const Case masses = case_of_text(
      "parameters: {m: 2}\nstates: {x: 1, v: 0}\nequations: {x: v, v: -x}\nmass: {v: {v: m}}\n"
      "time: {end: 2}\n");
  EXPECT_FALSE(masses.family({{2}, {3}}));
}

Plan plan_of(const Case& c, const Members& members) {
  Plan plan(c, members);
  plan.solver = "odeum/dormand_prince54";
  plan.request = adaptive(c, 1e-8);
  plan.quantities = quantities_of("", c);
  plan.jobs = 2;
  plan.checks = 4;
  return plan;
}

TEST(Sweep, HasARowForEachMemberAndAnErrorOfSome) {
  const Case c = case_of_text(
      "parameters: {k: 2, a: 1}\nstates: {x: a}\nequations: {x: -k*x}\n"
      "exact: {x: a*exp(-k*t)}\ntime: {end: 2}\n");
  const Plan plan = plan_of(c, Members({axis_of("k=0.1..10:log40"), axis_of("a=1,2,3")}, 0, 1));
  const Result result = run(plan);
  EXPECT_EQ(result.solved, 120U);
  EXPECT_TRUE(result.one_code);
  std::istringstream lines(result.csv);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "schema,member,solver,k,a,status,detail,x,rhs_evaluations");
  std::uint64_t member = 0;
  for (; std::getline(lines, line); ++member) {
    const std::vector<double> values = plan.members.values(member);
    EXPECT_TRUE(line.starts_with("1," + std::to_string(member) + ",odeum/")) << line;
    // Errors of each step at most 1e-8 of the state, of some hundred steps.
    EXPECT_NEAR(result.results[member], values[1] * std::exp(-2 * values[0]), 1e-6);
  }
  EXPECT_EQ(member, 120U);
  EXPECT_EQ(result.checks.made, 4U);
  EXPECT_LT(result.checks.largest, 1e-6);
  EXPECT_GT(result.checks.largest, 0);
  Plan one = plan;
  one.jobs = 1;
  EXPECT_EQ(run(one).csv, result.csv);
}

// In lanes, alone, and where the formula is the solution for some members only.
TEST(Sweep, AClosedFormGivesEachMemberItsError) {
  const Case c = case_of_text(
      "parameters: {k: 2, a: 1, p: 1}\nstates: {x: a}\nequations: {x: -k*x^p}\n"
      "exact: {x: a*exp(-k*t)}\ntime: {end: 2}\n");
  const std::optional<Quantity> error = error_of_members(c);
  ASSERT_TRUE(error);
  const auto run_over = [&](const std::string& solver, const std::vector<Axis>& axes) {
    Plan plan = plan_of(c, Members(axes, 0, 1));
    plan.solver = solver;
    plan.quantities.push_back(*error);
    return run(plan);
  };
  for (const char* solver : {"odeum/dormand_prince54", "odeum/taylor"}) {
    const Result result = run_over(solver, {axis_of("k=0.1..10:40"), axis_of("a=1,2,3")});
    double largest = 0;
    for (std::size_t member = 0; member < 120; ++member) {
      const std::size_t row = member / 3, column = member % 3;
      const double k = 0.1 + 9.9 / 39 * static_cast<double>(row),
                   exact = static_cast<double>(column + 1) * std::exp(-2 * k);
      // Both formulas are rounded.
      EXPECT_NEAR(result.results[2 * member + 1], std::abs(result.results[2 * member] - exact),
                  1e-14)
          << solver << " " << member;
      largest = std::max(largest, result.results[2 * member + 1]);
    }
    EXPECT_TRUE(result.checks.all);
    EXPECT_EQ(result.checks.made, 120U);
    EXPECT_EQ(result.checks.largest, largest);
    EXPECT_NE(result.csv.find(",x,error,rhs_evaluations\n"), std::string::npos);
  }
  // With p = 2 the reader refuses the formula, and the member has the reason.
  const Result some = run_over("odeum/dormand_prince54", {axis_of("p=1,2")});
  EXPECT_EQ(some.solved, 1U);
  EXPECT_LT(some.results[1], 1e-6);
  EXPECT_NE(some.csv.find("does not fulfil its equation"), std::string::npos) << some.csv;
  EXPECT_THROW(c.with_values({2, 1, 2}, {}), std::invalid_argument);
  // A case in C++, whose own closed form follows its values, and a text that has none.
  EXPECT_TRUE(error_of_members(tests::find_case("blow_up")));
  EXPECT_FALSE(error_of_members(tests::find_case("lotka_volterra")));
}

TEST(Sweep, AMemberThatFailsIsARow) {
  const Case c =
      case_of_text("parameters: {k: 2}\nstates: {x: 1}\nequations: {x: k*x^2}\ntime: {end: 0.4}\n");
  Plan plan = plan_of(c, Members({axis_of("k=1,2,4,2.2")}, 0, 1));
  plan.checks = 0;
  const Result result = run(plan);
  EXPECT_EQ(result.solved, 3U);
  ASSERT_EQ(result.endings.size(), 1U);
  EXPECT_EQ(result.endings.begin()->second.first, 2U);
  EXPECT_NE(sets_of(plan, 2).find("--set k=4"), std::string::npos);
  EXPECT_TRUE(std::isnan(result.results[2]));
  EXPECT_NEAR(result.results[3], 1 / (1 - 0.88), 1e-4);  // 1 / (1 - k t)
  EXPECT_THROW(run(plan_of(c, Members({axis_of("q=1,2")}, 0, 1))), std::invalid_argument);
}

TEST(Sweep, QuantitiesAreOfTheSolution) {
  const Case c = case_of_text(
      "parameters: {w: 1}\nstates: {x: 1, v: 0}\nequations: {x: v, v: -w^2*x}\n"
      "invariants: {energy: v^2/2 + w^2*x^2/2}\ntime: {end: 10}\n");
  Plan plan = plan_of(c, Members({axis_of("w=1,3")}, 0, 1));
  plan.quantities = quantities_of("max(x), min(v), x(end),energy", c);
  plan.checks = 0;
  plan.request.over_stops = true;
  plan.request.stops.clear();
  for (int k = 1; k <= 1000; ++k) plan.request.stops.push_back(k * 0.01);
  const Result result = run(plan);
  ASSERT_EQ(result.results.size(), 8U);
  EXPECT_EQ(result.results[0], 1);
  EXPECT_NEAR(result.results[5], -3, 1e-3);            // between outputs 0.01 apart
  EXPECT_NEAR(result.results[6], std::cos(30), 1e-5);  // to 1e-8 a step
  EXPECT_NEAR(result.results[7], 4.5, 1e-5);
  for (const char* wrong : {"max(y)", "x", "top(x)", "x(start)", "max(x", "energy()"})
    EXPECT_THROW(quantities_of(wrong, c), std::invalid_argument) << wrong;
}

// An output was no quantity, and had no error of its own.
TEST(Sweep, QuantitiesAreOutputsToo) {
  const Case c = case_of_text(
      "parameters: {k: 1}\nstates: {a: 1, b: 0}\nreactions: [{a -> b: k}]\n"
      "outputs: {flux: k*a, both: a + 2*b + t}\n"
      "exact: {a: exp(-k*t), b: 1 - exp(-k*t)}\ntime: {end: 2}\n");
  Plan plan = plan_of(c, Members({axis_of("k=1,3")}, 0, 1));
  plan.quantities = quantities_of("flux(end), both(end), max(flux), error(both), error(a)", c);
  plan.request.tolerance = 1e-9;
  plan.checks = 0;
  const Result result = run(plan);
  ASSERT_EQ(result.results.size(), 10U);
  for (const std::size_t member : {0U, 1U}) {
    const double k = member == 0 ? 1 : 3, a = std::exp(-2 * k);
    const double* const values = result.results.data() + 5 * member;
    // Some hundred times the tolerance.
    EXPECT_NEAR(values[0], k * a, 1e-7);
    EXPECT_NEAR(values[1], 4 - a, 1e-7);
    EXPECT_EQ(values[2], k);
    EXPECT_NEAR(values[3], std::abs(values[1] - (4 - a)), 1e-15);
    EXPECT_NEAR(values[4], std::abs(values[0] / k - a), 1e-15);
  }
  EXPECT_THROW(quantities_of("error(c)", c), std::invalid_argument);
  const Case unknown = case_of_text(
      "parameters: {k: 1}\nstates: {a: 1}\nequations: {a: -k*a + sin(a)/9}\ntime: {end: 2}\n");
  EXPECT_THROW(quantities_of("error(a)", unknown), std::invalid_argument);
}

}  // namespace
}  // namespace odeum::sweep::sweep_test
