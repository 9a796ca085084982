// SPDX-License-Identifier: BSD-3-Clause
// Every number of reports/trade-offs.md, measured again.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <optional>
#include <regex>
#include <sstream>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/spectrum.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/material/material.hpp"
#include "odeum/studies/reduction/reduction.hpp"
#include "odeum/studies/stability/stability.hpp"

namespace odeum::study::trade_offs_test {
namespace {

/// A solve to all stops of a case, or to others.
struct Solved {
  Outcome outcome;
  double error = 0;  ///< largest, over the stops
};

Solved solve(const std::string& case_id, const std::string& solver, Request request) {
  const Case& c = known_case(case_id);
  if (request.stops.empty()) request.stops = c.stops;
  Solved solved{find_solver(c.entrants, solver).solve(request), 0};
  EXPECT_EQ(solved.outcome.status, Status::ok) << case_id << ' ' << solver;
  if (solved.outcome.status == Status::ok)
    for (const judge::StopError& e : judge::Judge(c, request.stops).errors(solved.outcome))
      solved.error = std::max(solved.error, e.error_max);
  return solved;
}

Request steps(std::uint64_t count, std::vector<double> stops = {}) {
  Request request;
  request.steps = count;
  request.stops = std::move(stops);
  return request;
}
Request tolerance(double value) {
  Request request;
  request.mode = Mode::adaptive;
  request.tolerance = value;
  return request;
}

/// The evaluations of a run, which must have an error below `allowed`.
double evaluations(const std::string& case_id, const std::string& solver, const Request& request,
                   double allowed) {
  const Solved solved = solve(case_id, solver, request);
  EXPECT_LE(solved.error, allowed) << case_id << ' ' << solver;
  return static_cast<double>(solved.outcome.counters.rhs_evaluations);
}

/// The fewest evaluations with which a solver's runs to a tolerance reach an error.
double fewest(const std::string& case_id, const std::string& solver, double error) {
  double least = std::numeric_limits<double>::infinity();
  for (int exponent = 3; exponent <= 10; ++exponent)
    if (const Solved solved = solve(case_id, solver, tolerance(std::pow(10, -exponent)));
        solved.error <= error)
      least = std::min(least, static_cast<double>(solved.outcome.counters.rhs_evaluations));
  return least;
}

/// The largest relative error of the energy of x'' = -x at a hundred times.
double energy_error(const std::string& solver, std::uint64_t count, double end) {
  std::vector<double> stops;
  for (int k = 1; k <= 100; ++k) stops.push_back(end * k / 100);
  const Case& c = known_case("osc_undamped");
  const Solved solved = solve(c.id, solver, steps(count, stops));
  double worst = 0;
  for (std::size_t k = 0; k < stops.size(); ++k)
    worst = std::max(worst,
                     std::abs(c.energy(&solved.outcome.states[2 * k]) / c.energy(c.y0.data()) - 1));
  return worst;
}

/// The part of its amplitude that x'' = -x keeps.
double amplitude_left(const std::string& solver, std::uint64_t count, double end) {
  const Case& c = known_case("osc_undamped");
  const Solved solved = solve(c.id, solver, steps(count, {end}));
  return std::sqrt(c.energy(solved.outcome.states.data()) / c.energy(c.y0.data()));
}

double limit_of(const std::string& solver) {
  const StabilityResult result =
      measure_stability({.solvers = {solver}, .own = {{"grid", "8"}, {"plane", "oscillator"}}});
  for (const StabilityLimit& limit : result.limits)
    if (limit.axis == "oscillator") return limit.limit;
  return std::nan("");
}

double order_where_stiff(const std::string& solver) {
  for (const ReductionRow& row : measure_reduction({.solvers = {solver}}).rows)
    if (std::abs(row.lambda / -1e6 - 1) < 1e-9) return row.fit.order;
  return std::nan("");
}

double achieved(const std::string& solver) {
  return solve("kepler_e06", solver, tolerance(1e-6)).error / 1e-6;
}

double chain_stiffness(double rate, std::uint64_t sweeps) {
  for (const MaterialRow& row :
       measure_material({.solvers = {"bullet/soft_body_links"}}, Runner(2)).rows)
    if (row.scene == "hanging_chain" && row.sweeps == sweeps &&
        std::abs(row.step * rate - 1) < 1e-9)
      return row.static_stiffness_ratio;
  return std::nan("");
}

/// The step to which velocity Verlet is stable: 2 over the largest frequency.
double verlet_step(const std::string& case_id) {
  double fastest = 0;
  for (const auto& z : cases::spectrum_of(known_case(case_id)).eigenvalues)
    fastest = std::max(fastest, std::abs(z));
  return 2 / fastest;
}

struct Number {
  const char* name;
  std::function<double()> measure;
  /// The relative difference that is allowed: rounding of the text; more where a compiler's choice
  /// of fused operations changes which steps a solver rejects.
  double allowed = 0.06;
};
constexpr double steps_vary = 0.25;

const std::vector<Number>& numbers() {
  const double ten_periods = 20 * std::numbers::pi;
  static const std::vector<Number> list{
      {"rk4_limit", [] { return limit_of("odeum/rk4"); }},
      {"rk4_loss", [] { return 100 * (1 - amplitude_left("odeum/rk4", 10, 10)); }},
      {"verlet_orbit", [] { return fewest("kepler_e06", "odeum/velocity_verlet", 1e-6); },
       steps_vary},
      {"dopri_orbit", [] { return fewest("kepler_e06", "odeum/dormand_prince54", 1e-6); },
       steps_vary},
      {"nystroem_orbit", [] { return fewest("kepler_e06", "odeum/dormand_nystroem86", 1e-6); },
       steps_vary},
      {"verlet_energy", [] { return energy_error("odeum/velocity_verlet", 10'000, 1250); }},
      {"rk4_energy", [] { return energy_error("odeum/rk4", 2'500, 1250); }},
      {"explicit_stiff",
       [] {
         return evaluations("prothero_robinson_1e3_smooth", "odeum/dormand_prince54",
                            tolerance(1e-3), 1e-3);
       },
       steps_vary},
      {"radau_stiff",
       [] {
         return evaluations("prothero_robinson_1e3_smooth", "odeum/radau_iia5", tolerance(1e-3),
                            1e-3);
       },
       steps_vary},
      {"rosenbrock_robertson",
       [] { return evaluations("robertson_40", "odeum/rodas4", tolerance(1e-3), 1e-3); },
       steps_vary},
      {"explicit_cloth",
       [] {
         return evaluations("cloth11_two_way", "odeum/dormand_prince54", tolerance(1e-3), 1e-3);
       },
       steps_vary},
      {"midpoint_cloth",
       [] {
         return evaluations("cloth11_two_way", "odeum/implicit_midpoint", tolerance(1e-3), 1e-3);
       },
       steps_vary},
      {"euler_left",
       [=] { return 100 * amplitude_left("odeum/implicit_euler", 628, ten_periods); }},
      {"sdirk_order", [] { return order_where_stiff("odeum/sdirk4"); }},
      {"gauss_order", [] { return order_where_stiff("odeum/gauss4"); }},
      {"radau_order", [] { return order_where_stiff("odeum/radau_iia5"); }},
      {"tol_odeum", [] { return achieved("odeum/dormand_prince54"); }, steps_vary},
      {"tol_odeint", [] { return achieved("odeint/runge_kutta_dopri5"); }, steps_vary},
      {"tol_gsl", [] { return achieved("gsl/rkf45"); }, steps_vary},
      {"tol_gsl8", [] { return achieved("gsl/rk8pd"); }, steps_vary},
      {"tol_cvode", [] { return achieved("cvode/adams"); }, steps_vary},
      {"tol_arkode", [] { return achieved("arkode/erkstep_dormand_prince_7_4_5"); }, steps_vary},
      {"links_stiffness", [] { return chain_stiffness(60, 0); }},
      {"links_sweeps", [] { return chain_stiffness(60, 8); }},
      {"links_fine", [] { return chain_stiffness(960, 0); }},
      {"cloth_step", [] { return 1000 * verlet_step("cloth11_two_way"); }},
      {"stiff_cloth_step", [] { return 1000 * verlet_step("cloth11_two_way_k1e3"); }}};
  return list;
}

std::string trade_offs_text() {
  std::ifstream file(std::string(ODEUM_SOURCE_DIR) + "/reports/trade-offs.md");
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// Names and numbers of the tables "| `name` | number | how |".
std::vector<std::pair<std::string, std::string>> stated() {
  std::vector<std::pair<std::string, std::string>> list;
  const std::string text = trade_offs_text();
  const std::regex row(R"(\| `([a-z0-9_]+)` \| ([-0-9.,e]+) \|)");
  for (std::sregex_iterator it(text.begin(), text.end(), row), end; it != end; ++it)
    list.emplace_back((*it)[1], (*it)[2]);
  return list;
}

bool is_built(const std::string& name) {
  const auto has = [](const std::string& library) {
    return std::any_of(all_solvers().begin(), all_solvers().end(),
                       [&](const Solver& solver) { return solver.info.library == library; });
  };
  if (name.starts_with("links")) return has("bullet");
  return !name.starts_with("tol_") || has(name == "tol_gsl8" ? "gsl" : name.substr(4));
}

class TradeOffs : public testing::TestWithParam<std::size_t> {};

TEST_P(TradeOffs, NumberIsAsMeasured) {
  const Number& number = numbers()[GetParam()];
  if (!is_built(number.name)) GTEST_SKIP() << "needs a library that is not built in";
  std::string said;
  for (const auto& [name, value] : stated())
    if (name == number.name) said = value;
  ASSERT_NE(said, "") << "trade-offs.md has no " << number.name;
  std::string plain = said;
  std::erase(plain, ',');
  const double expected = std::stod(plain), measured = number.measure();
  EXPECT_NEAR(measured, expected, number.allowed * std::abs(expected)) << number.name;
}

INSTANTIATE_TEST_SUITE_P(Each, TradeOffs, testing::Range<std::size_t>(0, numbers().size()),
                         [](const auto& test) { return std::string(numbers()[test.param].name); });

TEST(TradeOffsText, ItsSentencesHaveTheNumbersOfItsTables) {
  const auto list = stated();
  EXPECT_EQ(list.size(), numbers().size());
  const std::string text = trade_offs_text();
  // The sentences: all lines but those of tables.
  std::string sentences;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with('|')) sentences += line + ' ';
  for (const auto& [name, value] : list) {
    const std::regex whole("(^|[^0-9.,])" + std::regex_replace(value, std::regex("\\."), "\\.") +
                           "([^0-9]|$)");
    EXPECT_TRUE(std::regex_search(sentences, whole)) << name << ": no sentence says " << value;
  }
}

}  // namespace
}  // namespace odeum::study::trade_offs_test
