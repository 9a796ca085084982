// SPDX-License-Identifier: BSD-3-Clause
// Libraries against one another: the same tableau takes about the same steps in all of them, and no
// case is failed by a whole library without an explanation.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "odeum/cases/set_problem.hpp"
#include "odeum/judge/errors.hpp"
#include "problems/hires.hpp"
#include "support/catalogue.hpp"

namespace odeum::tests::agreement_test {
namespace {

struct SameTableau {
  const char* name;
  std::vector<const char*> solvers;
};

const SameTableau tableaus[] = {
    {"Dormand and Prince 5(4)",
     {"odeum/dormand_prince54", "odeint/runge_kutta_dopri5", "arkode/erkstep_dormand_prince_7_4_5",
      "arkode/arkstep_dormand_prince_7_4_5"}},
    {"Cash and Karp 5(4)",
     {"odeum/cash_karp54", "gsl/rkck", "odeint/runge_kutta_cash_karp54",
      "arkode/erkstep_cash_karp_6_4_5", "arkode/erkstep_user_cash_karp54"}},
    {"Fehlberg 4(5)", {"odeum/fehlberg45", "gsl/rkf45", "arkode/erkstep_fehlberg_6_4_5"}},
    {"Fehlberg 7(8)",
     {"odeum/fehlberg78", "odeint/runge_kutta_fehlberg78", "arkode/arkstep_fehlberg_13_7_8"}},
};

// What controllers explain of the number of steps: the norm of the scaled error (root mean square
// or maximum: up to sqrt(2) for two components), what it is scaled by (odeint adds h |y'|) and
// safety factors from 0.9 to 0.96. Errors enter to the power 1/5 or less, so that these come to 1.5
// at most; a tolerance that is taken for another, an estimate that is missing a factor or a step
// that is limited without need changes the count by more.
constexpr double explained = 1.6;
// ARKODE's controller keeps a step that could grow by less than 1.5, which it computes from the
// error to the power of about 0.47/4 (order 5) or 0.47/7: errors of 1/30 or 1/400 of the tolerance
// leave a step as it is, a factor of 2 in the steps; and over the 7 to 16 steps that others take of
// order 8 on Kepler's ellipse it does not grow to its own length. Of Fehlberg's 7(8) ERKStep takes
// twice ARKStep's steps, since it evaluates the first stage at another state
// (reports/findings/sundials.md).
constexpr double explained_arkode = 3.2;

TEST(Agreement, SameTableauSameSteps) {
  std::size_t compared = 0;
  for (const char* id : {"lotka_volterra", "kepler_e06", "brusselator2", "vdp_mu1"}) {
    const Case& c = find_case(id);
    for (const SameTableau& tableau : tableaus)
      for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
        double least = std::numeric_limits<double>::infinity(), most = 0, most_arkode = 0;
        std::string counts;
        for (const Entrant& entrant : c.entrants) {
          if (std::none_of(tableau.solvers.begin(), tableau.solvers.end(),
                           [&](const char* solver) { return entrant.info.id() == solver; }))
            continue;
          const Outcome outcome = entrant.solve(adaptive_request(tolerance, {c.stops.back()}));
          ASSERT_EQ(outcome.status, Status::ok) << entrant.info.id() << ' ' << outcome.detail;
          const auto steps = static_cast<double>(outcome.counters.steps);
          least = std::min(least, steps);
          double& largest = entrant.info.library == "arkode" ? most_arkode : most;
          largest = std::max(largest, steps);
          counts += ' ' + entrant.info.id() + ' ' + std::to_string(outcome.counters.steps);
          ++compared;
        }
        EXPECT_LT(most, explained * least)
            << tableau.name << " on " << id << " at " << tolerance << counts;
        EXPECT_LT(most_arkode, explained_arkode * least)
            << tableau.name << " on " << id << " at " << tolerance << counts;
      }
  }
  EXPECT_GT(compared, 30U);
}

/// HIRES without its Jacobian.
struct RightHandSideOnly {
  static constexpr std::size_t dimension = 8;
  void rhs(double t, const double* y, double* f) const { cases::Hires().rhs(t, y, f); }
};

// Differences of the right-hand side cost eight evaluations each: where the case has a Jacobian
// they are not made.
TEST(Agreement, ImplicitPeersTakeTheJacobianThatACaseHas) {
  const Case& exact = find_case("hires");
  Case differenced = exact;
  cases::set_problem(differenced, RightHandSideOnly());
  const auto evaluations = [](const Case& c, const std::string& id) -> std::uint64_t {
    for (const Entrant& entrant : c.entrants) {
      if (entrant.info.id() != id) continue;
      const Outcome outcome = entrant.solve(adaptive_request(1e-5, {c.stops.back()}));
      EXPECT_EQ(outcome.status, Status::ok) << id << ' ' << outcome.detail;
      return outcome.counters.rhs_evaluations;
    }
    return 0;
  };
  for (const char* id : {"cvode/bdf", "arkode/arkstep_kvaerno_5_3_4", "gsl/bsimp", "gsl/rk4imp",
                         "odeint/rosenbrock4"}) {
    if (const std::uint64_t with = evaluations(exact, id); with > 0) {
      EXPECT_GT(evaluations(differenced, id), with + 64U) << id;
    }
  }
}

/// Cases on which no solver of a library ends within a hundredth, and why.
struct Explained {
  const char *library, *id, *why;
};
const Explained known[] = {
    {"", "blow_up", "the solution ends at a pole"},
    // RADAU5 alone has full matrices and bands; a cloth has 726 unknowns in no narrow band.
    {"radau5", "cloth11_two_way", "more unknowns than a full matrix may have"},
    {"radau5", "cloth11_tension_only", "more unknowns than a full matrix may have"},
    {"radau5", "cloth11_two_way_k1e3", "more unknowns than a full matrix may have"},
};

bool is_explained(const std::string& library, const std::string& id) {
  for (const Explained& one : known)
    if (id == one.id && (*one.library == '\0' || library == one.library)) return true;
  return false;
}

bool solves(const Case& c, const Entrant& entrant, double tolerance, std::uint64_t budgets = 1) {
  Request request;
  request.stops = c.stops;
  request.budget.evaluations = budgets * c.settings.evaluation_budget;
  request.budget.seconds = 30;
  if (entrant.info.adaptive) {
    request.mode = Mode::adaptive;
    set_tolerance(request, c, tolerance);
  } else {
    if (!c.settings.no_fixed_steps.empty()) return false;
    // Within the budget at up to four evaluations a step.
    const double steps =
        std::min(static_cast<double>(c.settings.coarsest_steps) * std::sqrt(1e-2 / tolerance),
                 static_cast<double>(c.settings.evaluation_budget) / 4);
    request.steps = c.settings.steps_multiple *
                    static_cast<std::uint64_t>(
                        std::ceil(steps / static_cast<double>(c.settings.steps_multiple)));
  }
  const Outcome outcome = entrant.solve(request);
  if (outcome.status != Status::ok) return false;
  const judge::Judge judge(c, request.stops);
  return judge.errors(outcome).back().error_max < 0.01 * judge.scale();
}

TEST(Agreement, NoLibraryFailsACaseUnexplained) {
  std::size_t pairs = 0;
  for (const Case& c : all_cases()) {
    std::set<std::string> libraries, solved;
    // Solvers for stiff problems first: they solve the others as well.
    std::vector<const Entrant*> order;
    for (const bool implicit : {true, false})
      for (const Entrant& entrant : c.entrants)
        if (entrant.unfit.empty() && entrant.info.library != "odeum" &&
            implicit == (c.nature.stiff && entrant.info.family != "explicit_rk"))
          order.push_back(&entrant);
    for (const double tolerance : {1e-5, 1e-8})
      for (const Entrant* entrant : order) {
        const std::string& library = entrant->info.library;
        libraries.insert(library);
        if (!solved.contains(library) && !is_explained(library, c.id) &&
            solves(c, *entrant, tolerance))
          solved.insert(library);
      }
    // GSL and odeint have dense Jacobians alone, of up to 128 unknowns here: on brusselator_1d and
    // medakzo explicit methods end beyond the budget, as `odeum precision` runs them then.
    for (const Entrant* entrant : order)
      if (const std::string& library = entrant->info.library;
          entrant->info.adaptive && !solved.contains(library) && !is_explained(library, c.id) &&
          solves(c, *entrant, 1e-4, 30))
        solved.insert(library);
    for (const std::string& library : libraries) {
      if (is_explained(library, c.id)) continue;
      ++pairs;
      EXPECT_TRUE(solved.contains(library)) << library << " solves " << c.id << " by no solver";
    }
  }
  EXPECT_GT(pairs, 50U);
}

}  // namespace
}  // namespace odeum::tests::agreement_test
