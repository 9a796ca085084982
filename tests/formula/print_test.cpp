// SPDX-License-Identifier: BSD-3-Clause
// Cases that are texts: what is said of them, what is printed, and mistakes in both.
#include <gtest/gtest.h>

#include "odeum/cases/text_case.hpp"
#include "odeum/formula/text_ode.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/print/print_text.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/convergence/settings.hpp"
#include "support/catalogue.hpp"

namespace odeum::print_test {
namespace {

const std::string decay =
    "parameters: {k: 2}\nstates: {x: 3*k}\nequations: {x: -k*x}\ntime: {end: 1}\n";

/// Makes the first case of a file whose problem is `problem`.
Case made(const std::string& cases, const std::string& problem = decay,
          const formula::Overrides& set = {}) {
  return case_of(cases::text_statements("f.yaml", problem + cases, "f", set).front());
}

void expect_fault(const std::string& cases, const std::string& place, const std::string& part,
                  const std::string& problem = decay) {
  try {
    made(cases, problem);
    ADD_FAILURE() << "made: " << cases;
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("f.yaml:" + place)) << error.what();
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

TEST(CaseTexts, MistakesHaveTheirPlace) {
  expect_fault("cases: {a-b: {floor: 1}}\n", "5:9: ", "not a name");
  expect_fault("cases: {d: {reference: kepler_e06}}\n", "5:24: ", "floor: got none");
  expect_fault("cases: {d: {referense: r}}\n", "5:13: ", "did you mean reference?");
  expect_fault("cases: {d: {reference: r, floor: 1}}\n", "5:24: ", "no reference r");
  expect_fault("case: {nature: soft}\n", "5:16: ", "expected smooth, stiff or chaotic");
  expect_fault("case: {offer: jacobian}\n", "5:8: ", "did you mean offers?");
  expect_fault("case: {offers: jacobi}\n", "5:16: ", "got jacobi, expected jacobian");
  expect_fault("cases: {d: {parameters: [z]}}\n", "5:25: ", "no parameter; got z");
  expect_fault("cases: {d: {meanings: {z: 1}}}\n", "5:24: ", "no parameter; got z");
  expect_fault("cases: {d: {floor: t}}\n", "5:20: ", "not a constant");
  expect_fault("cases: {d: {steps_multiple: -3}}\n", "5:29: ", "got -3, expected a whole number");
  expect_fault("cases: {d: {evaluation_budget: 1e40}}\n", "5:32: ", "expected a whole number");
  expect_fault("cases: {d: {steps_multiple: 2.5}}\n", "5:29: ", "got 2.5, expected a whole");
  expect_fault("cases: {d: {stops: [1, 0.5]}}\n", "5:20: ", "got 0.5, expected a time after 1");
  expect_fault("cases: {d: {thresholds: [1, 2]}}\n", "5:25: ", "expected 1 positive numbers");
  // Names that were ignored: the case was that of the usual values.
  expect_fault("cases: {d: {set: {kk: 3}}}\n", "5:19: ", "no parameter; got kk");
  expect_fault("cases: {d: {invariants: energie}}\n", "5:25: ", "no invariant; got energie");
}

TEST(PrintedTexts, RefuseWhatIsNotPrinted) {
  EXPECT_THROW(print::print_text("f.yaml",
                                 "states: {x: 1, v: 0}\nequations: {x: v, v: -x}\n"
                                 "mass: {v: {v: 2}}\ntime: {end: 1}\n"),
               InputError);
  EXPECT_THROW(print::print_text("f.yaml",
                                 "parameters: {n: 3}\nstates: {\"u[1..n]\": 1}\n"
                                 "equations: {\"u[1..3]\": 1}\ntime: {end: 1}\n"),
               InputError);
}

TEST(PrintedTexts, ParametersAreMembersAndWhatFollowsFromThemToo) {
  const print::Printed printed = print::print_text("decay.yaml", decay);
  for (const char* line : {"struct Decay {", "double k = 0x1p+1;", "_ = -this->k;",
                           "void linear_matrix(double* a) const"})
    EXPECT_NE(printed.header.find(line), std::string::npos) << line << '\n' << printed.header;
  EXPECT_NE(printed.unit.find("problem{.k = values[0]};"), std::string::npos) << printed.unit;
}

// Tags are words for people: these decided where studies stop, what they may spend and what they
// claim of a user's problem.
TEST(CaseTexts, TagsDecideNothing) {
  const std::string text = "states: {x: 1}\nequations: {x: -x*x}\ntime: {end: 4}\n";
  const auto case_with = [&](const std::string& tags) {
    return case_of(cases::text_statements(
        "f.yaml", text + "case: {stops: [1, 4], tags: [" + tags + "]}\n", "f")[0]);
  };
  const Case tagged = case_with(
      "celestial, cloth, kinked, kinked_4, late_encounters, linear, non_autonomous, stiff, "
      "chaotic");
  EXPECT_EQ(tags_of(tagged), (std::vector<std::string>{"nonlinear", "autonomous", "smooth",
                                                       "celestial", "cloth", "late_encounters"}));
  EXPECT_EQ(study::convergence_stops(tagged), tagged.stops);
  EXPECT_EQ(tagged.nature.highest_order, infinity);
  EXPECT_FALSE(tagged.nature.linear || tagged.nature.stiff || tagged.nature.chaotic);
  EXPECT_EQ(tagged.settings.evaluation_budget, case_with("other").settings.evaluation_budget);
}

// Every key, in a text of a user: what it says is in the case.
TEST(CaseTexts, OfAUserSayAllThatBuiltInOnesDo) {
  const std::string problem =
      "name: Decay\nparameters: {k: 2, m: 1}\nstates: {x: 3*k, z: m}\n"
      "equations: {x: -k*x, z: k*x}\ninvariants: {sum: x + z, other: 2*x + 2*z}\n"
      "time: {end: 1}\n";
  const std::string cases =
      "case:\n  source: a book\n  tags: [short]\n  meanings: {k: a rate}\n  positive: k\n"
      "  not_negative: [m]\n  offers: [jacobian]\n"
      "cases:\n  one:\n    title: One\n    equation: x' = -k x\n    tags: special\n"
      "    nature: [smooth, stiff]\n"
      "    set: {m: 2}\n    stops: [0.5, 1]\n    thresholds: [1e-3, k]\n    invariants: sum\n"
      "    steps_multiple: 2\n    coarsest_steps: 8\n    finest_steps: 64\n"
      "    timed_stops: 2\n    timed_floor: 1e-12\n    evaluation_budget: 1000\n"
      "  two: {no_fixed_steps: it is an example}\n";
  const std::vector<Statement> statements = cases::text_statements("f.yaml", problem + cases, "f");
  ASSERT_EQ(statements.size(), 2U);
  EXPECT_EQ(statements[1].title, "Decay");
  const Case c = case_of(statements[0]);
  EXPECT_EQ(c.title, "One");
  EXPECT_EQ(c.equation, "x' = -k x; k = 2");
  EXPECT_EQ(c.source, "a book");
  EXPECT_EQ(tags_of(c), (std::vector<std::string>{"linear", "autonomous", "smooth", "stiff",
                                                  "short", "special"}));
  EXPECT_EQ(c.y0, (std::vector<double>{6, 2}));
  EXPECT_EQ(c.stops, (std::vector<double>{0.5, 1}));
  EXPECT_EQ(c.tolerance.threshold(1), 2);
  ASSERT_EQ(c.invariants.size(), 1U);
  EXPECT_EQ(c.invariants[0].name, "sum");
  EXPECT_EQ(c.settings.coarsest_steps, 8U);
  EXPECT_EQ(c.settings.timed_stops, std::vector<double>{2});
  double y[2];
  ASSERT_TRUE(c.truth.at(2, y)) << "the truth is computed there too";
  EXPECT_NEAR(y[0], 6 * std::exp(-4.0), 1e-14);
  EXPECT_FALSE(c.problem.view.taylor) << "it offers the Jacobian alone";
  EXPECT_TRUE(c.problem.view.jacobian);
  ASSERT_EQ(c.parameters.size(), 1U);
  EXPECT_EQ(c.parameters[0].meaning, "a rate");
  EXPECT_EQ(c.with_values({3}, {}).y0, (std::vector<double>{9, 2}));
  EXPECT_THROW(c.with_values({-1}, {}), std::invalid_argument);
  EXPECT_EQ(case_of(statements[1]).settings.no_fixed_steps, "it is an example");
  EXPECT_THROW(made("", problem, {{"kk", "1"}}), InputError);
  // Values that are given again stay: k and m, in the order of their names.
  EXPECT_EQ(made("", problem, {{"k", "3"}}).with_values({3, 5}, {}).y0,
            (std::vector<double>{9, 5}));
}

// A text with the equations and all keys of a built-in one is the same case: the same rows, byte
// for byte but for the id.
TEST(CaseTexts, GiveTheRowsOfTheBuiltInCase) {
  for (const std::string stem : {"kepler", "robertson", "rc_circuit", "prothero_robinson"}) {
    std::string text =
        read_text_file(ODEUM_SOURCE_DIR "/cases/" + stem + ".yaml", "problem", 100'000);
    for (Statement& statement : cases::text_statements("mine/f.yaml", text, "f")) {
      const std::string id = statement.id;
      statement.id = id + "_mine";
      add_user_case(statement);
      std::string rows[2];
      for (const bool mine : {false, true}) {
        const std::string name = mine ? statement.id : id;
        rows[mine] = record::to_record(
            study::converge({.cases = {name},
                             .solvers = {"odeum/rk4", "odeum/radau_iia5", "gsl/rkf45"},
                             .own = {{"mode", "adaptive"}}}));
        for (std::size_t at = rows[mine].find(name); at != std::string::npos;
             at = rows[mine].find(name, at + id.size()))
          rows[mine].replace(at, name.size(), id);
      }
      EXPECT_GT(rows[0].size(), 1000U);
      EXPECT_EQ(rows[0], rows[1]) << id;
    }
  }
}

TEST(Catalogue, ARunOfOneSolverMakesOneCaseAndOneEntrant) {
  const std::size_t before = Entrants::made();
  const Case& c = known_case("henon_heiles_regular");
  EXPECT_TRUE(c.entrants.find("odeum/velocity_verlet")->unfit.empty());
  EXPECT_LE(Entrants::made(), before + 1);
  EXPECT_EQ(&known_case("henon_heiles_regular"), &c);
  EXPECT_THROW(known_case("henon"), std::out_of_range);
}

// The constants that follow from parameters, and the initial values, are those of the values that a
// user gives.
TEST(CaseTexts, FollowTheirParameters) {
  const Case c = tests::find_case("rigid_body_hlw").with_values({3, 1.5, 0.8, 0.7}, {});
  const std::string file = ODEUM_SOURCE_DIR "/cases/rigid_body.yaml";
  const formula::TextOde text(
      formula::read_problem(file, formula::problem_text(file),
                            {{"I1", "3"}, {"I2", "1.5"}, {"I3", "0.8"}, {"angle", "0.7"}}));
  const double y[] = {0.3, 0.5, 0.7};
  double f[3], expected[3];
  c.problem.view.rhs(c.problem.view.problem, 0, y, f);
  text.view().rhs(text.view().problem, 0, y, expected);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(f[i], expected[i], 1e-15);
    EXPECT_NEAR(c.y0[i], static_cast<double>(text.problem().y0[i]), 1e-15);
  }
  EXPECT_THROW(tests::find_case("kepler_e06").with_values({1.5}, {}), std::invalid_argument);
}

TEST(CaseTexts, AClosedFormHoldsForAllParameters) {
  const Case c = tests::find_case("prothero_robinson_1e3_smooth").with_values({2, 3}, {});
  double y = 0;
  ASSERT_TRUE(c.truth.at(0.5, &y));
  EXPECT_NEAR(y, std::cos(0.5) + 2 * std::exp(-1.0), 1e-15);
  EXPECT_EQ(c.truth.source, "the closed form of cases/prothero_robinson.yaml");
  EXPECT_EQ(tests::find_case("prothero_robinson_1e3_smooth").truth.source,
            "cases/reference/prothero_robinson_1e3_smooth.csv");
}

}  // namespace
}  // namespace odeum::print_test
