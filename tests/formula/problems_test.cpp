// SPDX-License-Identifier: BSD-3-Clause
// The problems that are shipped as text, against the compiled cases of the same equations.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <random>
#include <string>

#include "odeum/cases/text_truth.hpp"
#include "odeum/formula/text_ode.hpp"
#include "support/catalogue.hpp"

namespace odeum::problems_test {
namespace {

using formula::TextOde;

const std::filesystem::path folders[] = {ODEUM_SOURCE_DIR "/cases",
                                         ODEUM_SOURCE_DIR "/cases/problems"};

/// A problem that is a built-in case, or one of the others.
std::string path_of(const std::string& name) {
  for (const auto& folder : folders)
    if (const auto path = folder / (name + ".yaml"); std::filesystem::exists(path))
      return path.string();
  return name;
}
formula::Problem problem_of(const std::string& file, const formula::Overrides& set = {}) {
  return formula::read_problem(file, formula::problem_text(file), set);
}

struct Twin {
  const char* file;
  const char* id;  ///< of the compiled case
  formula::Overrides set = {};
};

void expect_twins(const OdeView& text, const OdeView& compiled, double t,
                  const std::vector<double>& y) {
  const std::size_t n = y.size();
  std::vector<double> a(n * n), b(n * n);
  // Both round some ten times, in another order; terms may cancel, of the size of the largest
  // entry.
  const auto expect_near = [&](std::size_t count, const char* what) {
    double largest = 0;
    for (std::size_t k = 0; k < count; ++k) largest = std::max(largest, std::abs(b[k]));
    for (std::size_t k = 0; k < count; ++k)
      EXPECT_NEAR(a[k], b[k], 1e-14 * largest) << what << ' ' << k;
  };
  text.rhs(text.problem, t, y.data(), a.data());
  compiled.rhs(compiled.problem, t, y.data(), b.data());
  expect_near(n, "rhs");
  text.jacobian(text.problem, t, y.data(), a.data());
  compiled.jacobian(compiled.problem, t, y.data(), b.data());
  expect_near(n * n, "jacobian");
  EXPECT_EQ(text.time_derivative == nullptr, compiled.time_derivative == nullptr);
  if (text.time_derivative && compiled.time_derivative) {
    text.time_derivative(text.problem, t, y.data(), a.data());
    compiled.time_derivative(compiled.problem, t, y.data(), b.data());
    expect_near(n, "time derivative");
  }
  if (compiled.taylor) {
    ASSERT_NE(text.taylor, nullptr);
    constexpr int order = 12;
    a.resize((order + 1) * n);
    b.resize((order + 1) * n);
    text.taylor(text.problem, t, y.data(), order, a.data());
    compiled.taylor(compiled.problem, t, y.data(), order, b.data());
    for (std::size_t k = 0; k < a.size(); ++k)
      EXPECT_NEAR(a[k], b[k], 1e-12 * (1 + std::abs(b[k]))) << "coefficient " << k;
  }
}

TEST(ShippedProblems, HaveTheFunctionsOfTheCompiledCases) {
  const Twin twins[] = {
      {"van_der_pol", "vdp_mu1"},       {"van_der_pol", "vdp_mu1000", {{"mu", "1000"}}},
      {"kepler", "kepler_e06"},         {"hires", "hires"},
      {"lorenz", "lorenz_kehlet_logg"}, {"lotka_volterra", "lotka_volterra"},
      {"brusselator", "brusselator2"},  {"two_masses_sum", "mass_matrix"},
      {"robertson", "robertson_40"},    {"arenstorf", "arenstorf"},
      {"rigid_body", "rigid_body_hlw"}, {"rigid_body_elliptic", "rigid_body_detest_b5"}};
  std::mt19937 random(3);  // NOLINT(cert-msc32-c,cert-msc51-cpp): the same points each time
  std::uniform_real_distribution<double> near(0.5, 1.5);
  for (const Twin& twin : twins) {
    SCOPED_TRACE(twin.file);
    const Case& c = tests::find_case(twin.id);
    const TextOde ode(problem_of(path_of(twin.file), twin.set));
    ASSERT_EQ(ode.size(), c.y0.size());
    for (std::size_t i = 0; i < c.y0.size(); ++i)
      EXPECT_DOUBLE_EQ(static_cast<double>(ode.problem().y0[i]), c.y0[i]);
    for (int point = 0; point < 20; ++point) {
      std::vector<double> y = c.y0;
      for (double& x : y) x = (x == 0 ? 0.3 : x) * near(random);
      expect_twins(ode.view(), c.problem.view, near(random), y);
    }
  }
}

/// Its closed form or a computed one, never a reference file.
cases::TextTruth truth_of(const formula::Problem& problem) {
  return problem.exact.empty()
             ? cases::truth_of(std::make_shared<const TextOde>(problem), {problem.scale})
             : cases::closed_form(problem, {problem.scale});
}

// The test set for initial value problem solvers (Bari) gives these, computed with RADAU5 to a
// tolerance of 1e-16 or so; 13 digits are held.
void expect_published_pollution(const std::vector<double>& y) {
  const double published[] = {
      0.5646255480022769e-01, 0.1342484130422339e+00, 0.4139734331099427e-08,
      0.5523140207484359e-02, 0.2018977262302196e-06, 0.1464541863493966e-06,
      0.7784249118997964e-01, 0.3245075353396018e+00, 0.7494013383880406e-02,
      0.1622293157301561e-07, 0.1135863833257075e-07, 0.2230505975721359e-02,
      0.2087162882798630e-03, 0.1396921016840158e-04, 0.8964884856898295e-02,
      0.4352846369330103e-17, 0.6899219696263405e-02, 0.1007803037365946e-03,
      0.1772146513969984e-05, 0.5682943292316392e-04};
  for (std::size_t i = 0; i < y.size(); ++i)
    EXPECT_NEAR(y[i], published[i], 1e-12 * published[i]) << i;
}

TEST(ShippedProblems, AllOfThemAreReadAndHaveATruth) {
  // Passages of the moon amplify rounding by some 1e7. The oregonator's jumps of five decades leave
  // the implicit methods of its reference eleven digits of 1,228.
  // e^(U / 0.026) of the transistors amplifies rounding by 40 for each volt.
  // Errors of E5 are in units of its scale, 1e-9 and less. Doses of 80 are on states that end at 3.
  const std::map<std::string, double> bounds{{"arenstorf", 1e-11},
                                             {"doses", 1e-13},
                                             {"e5", 1e-11},
                                             {"oregonator", 2e-8},
                                             {"transistor_amplifier", 1e-13},
                                             {"pendulum_xy", 1e-13}};
  int count = 0;
  bool has_published = false;
  std::vector<std::filesystem::directory_entry> files;
  for (const auto& folder : folders)
    for (const auto& entry : std::filesystem::directory_iterator(folder)) files.push_back(entry);
  for (const auto& entry : files) {
    if (entry.path().extension() != ".yaml") continue;
    SCOPED_TRACE(entry.path().string());
    ++count;
    const formula::Problem problem = problem_of(entry.path().string());
    const cases::TextTruth known = truth_of(problem);
    const Truth& truth = known.truth;
    std::vector<double> y(problem.y0.size());
    ASSERT_FALSE(known.stops.empty());
    EXPECT_TRUE(truth.at(known.stops.back(), y.data()));
    EXPECT_GT(truth.floor, 0);
    if (entry.path().stem() == "pollution") {
      EXPECT_EQ(known.stops.back(), problem.stops.back());
      expect_published_pollution(y);
      has_published = true;
    }
    const auto bound = bounds.find(entry.path().stem().string());
    double largest = 0;
    for (const double component : y) largest = std::max(largest, std::abs(component));
    // The states are rounded to double.
    EXPECT_LT(truth.floor, (bound == bounds.end() ? 2e-14 : bound->second) + 0x1p-53 * largest);
    EXPECT_FALSE(problem.equations_text.empty());
  }
  EXPECT_GE(count, 34);
  EXPECT_TRUE(has_published);
}

/// The computed truth of a shipped problem at its end.
std::vector<double> truth_at_end(const std::string& file) {
  const formula::Problem problem = problem_of(path_of(file));
  std::vector<double> y(problem.y0.size());
  EXPECT_TRUE(truth_of(problem).truth.at(problem.stops.back(), y.data())) << file;
  return y;
}

// Enright, Pryce, Two FORTRAN packages for assessing initial value methods, ACM TOMS 13 (1987),
// give 16 digits of B5 at 20, which hold to 1e-13.
TEST(ShippedProblems, TheRigidBodyHasThePublishedSolution) {
  const double published[] = {-0.9396570798729192, -0.3421177754000779, 0.7414126596199957};
  const std::vector<double> y = truth_at_end("rigid_body_elliptic");
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(y[i], published[i], 1e-13) << i;
}

// The initial velocity and the period are published to some 16 digits that count; the
// passages of the moon amplify what lies behind them.
TEST(ShippedProblems, ArenstorfsOrbitCloses) {
  const std::vector<double> y = truth_at_end("arenstorf"),
                            start = {0.994, 0, 0, -2.00158510637908252};
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(y[i], start[i], 1e-8) << i;
}

TEST(GivenCases, AreKnownBesideTheOthers) {
  const std::size_t before = known_cases().size();
  const Statement statement{
      .id = "given", .title = "Given", .tags = {}, .make = [] { return Case(); }};
  const Case& added = add_user_case(statement);
  EXPECT_EQ(known_cases().size(), before + 1);
  EXPECT_EQ(known_cases().back(), &added);
  EXPECT_THROW(add_user_case(statement), std::invalid_argument);
}

}  // namespace
}  // namespace odeum::problems_test
