// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/foreign_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/cases/study_steps.hpp"
#include "odeum/cases/text_truth.hpp"
#include "odeum/isolated/isolated_process.hpp"
#include "odeum/truth/foreign_reference.hpp"

namespace odeum::cases {
namespace {

/// A problem with what it needs.
struct Held {
  explicit Held(foreign::ProblemCallbacks from)
      : given(std::move(from)), problem(given.functions) {}
  foreign::ProblemCallbacks given;
  foreign::Problem problem;
};

Entrants enroll_isolated(const ErasedContest& contest, const std::vector<Entrant>& own) {
  const auto isolate = [n = contest.view.dimension](Entrant& entrant) {
    entrant.solve = [n, solve = std::move(entrant.solve),
                     ended = std::make_shared<isolated::Ended>()](const Request& request) {
      return isolated::solve_isolated(solve, request, n, *ended);
    };
  };
  Entrants entrants = enroll(contest, isolate);
  for (Entrant entrant : own) {
    isolate(entrant);
    entrants.add(std::move(entrant));
  }
  return entrants;
}

/// The truth of the case, and words for people; whether it was computed.
bool set_truth(Case& c, const std::shared_ptr<const Held>& held, const TruthBounds& bounds,
               std::string& words) {
  const foreign::ProblemCallbacks& given = held->given;
  c.truth.at = [held](double t, double* y) { return held->problem.exact(t, y); };
  // The foreign code's solution is known to its rounding.
  for (const double y : c.y0) c.truth.floor = std::max(c.truth.floor, 1e-15 * std::abs(y));
  if (given.functions.exact) {
    c.truth.source = given.provider + "'s exact solution";
    words = "exact solution";
    return false;
  }
  std::string why = given.no_truth;
  std::optional<truth::Reference> reference;
  if (why.empty())
    reference =
        truth::kept_or_computed("foreign, sampled " + given.content, c.y0.size(), c.stops, c.units,
                                bounds, [&] { return truth::reference_of(given, why, bounds); });
  if (reference && !reference->times.empty()) {
    const std::string assumed = fmt::format("; assuming that nothing in it is shorter than {:.2g}",
                                            truth::shortest_seen * (c.stops.back() - c.t0));
    const TextTruth known = truth_from(std::move(*reference), c.stops, c.units, given.source);
    c.truth = known.truth;
    c.truth.source += assumed;
    cut_stops(c, known.stops);
    words = known.words + assumed;
    return true;
  }
  if (reference) why = reference->end;
  words = fmt::format("none: {} has no exact solution, and no reference was computed: {}",
                      given.provider, why);
  c.truth.source = words;
  c.settings.no_convergence = "no truth is known: " + given.provider +
                              " has no exact solution, and no reference was computed: " + why;
  return false;
}

/// Chooses the steps with which plug-ins' exact solutions are compared, without running foreign
/// code.
void usual_steps(Case& c) {
  const std::uint64_t multiple = steps_multiple(c.t0, c.stops);
  c.settings.steps_multiple = std::max<std::uint64_t>(multiple, 1);
  if (multiple == 0)
    c.settings.no_fixed_steps = "no number of equal steps up to 1000 meets every stop";
  c.settings.coarsest_steps = std::max<std::uint64_t>(16, c.settings.steps_multiple);
  c.settings.finest_steps = std::max<std::uint64_t>(16384, 64 * c.settings.steps_multiple);
}

void compute_truth(Case& c, const std::shared_ptr<const Held>& held, const TruthBounds& bounds) {
  std::string words;
  if (set_truth(c, held, bounds, words))
    choose_steps(c, false, true);
  else
    usual_steps(c);
  if (c.nature.stiff) c.facts.emplace_back("found", "stiff: explicit methods need many more steps");
  c.facts.emplace_back("truth", words);
}

Case foreign_case(const std::shared_ptr<const Held>& held) {
  const foreign::ProblemCallbacks& given = held->given;
  const odeum_problem& p = given.functions;
  Case c;
  c.nature.autonomous = !p.time_derivative;
  c.equation = given.equation;
  c.source = given.source;
  c.components = given.components;
  c.units.scale = given.scale;
  c.t0 = p.t0;
  c.y0.assign(p.y0, p.y0 + p.dimension);
  c.stops.assign(p.stops, p.stops + p.stop_count);
  if (p.energy) c.energy = [held](const double* y) { return held->problem.energy(y); };
  c.problem = {view_of(held->problem), held, c.t0,
               std::make_shared<const std::vector<double>>(c.y0), nullptr};
  c.problem.events = given.events;
  if (!given.switches.empty())
    c.problem.switches = [held](double from, double to) {
      std::vector<Switch> between;
      std::ranges::copy_if(held->given.switches, std::back_inserter(between),
                           [&](const Switch& at) { return at.t >= from && at.t <= to; });
      return between;
    };
  c.entrants = enroll_isolated(c.problem, given.own_solvers);
  c.facts = given.facts;
  c.truth = unknown_truth("not computed");
  c.compute_truth = [held](Case& later, const TruthBounds& bounds) {
    compute_truth(later, held, bounds);
  };
  return c;
}

}  // namespace

Statement foreign_statement(foreign::ProblemCallbacks from) {
  const auto held = std::make_shared<const Held>(std::move(from));
  const foreign::ProblemCallbacks& given = held->given;
  Statement statement{.id = given.id, .title = given.title, .tags = {given.tag}, .make = [held] {
                        return foreign_case(held);
                      }};
  if (given.functions.acceleration) statement.tags.emplace_back("second_order");
  return statement;
}

}  // namespace odeum::cases
