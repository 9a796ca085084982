// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/scene_case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "odeum/cases/parameters.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/cases/study_steps.hpp"
#include "odeum/truth/scene_system.hpp"

namespace odeum::cases {
namespace {

Contest<scene::SceneProblem> contest_of(const std::shared_ptr<const scene::SceneProblem>& problem) {
  Contest<scene::SceneProblem> contest;
  contest.problem = problem;
  contest.y0 = {problem, &problem->start()};
  if (problem->lives().empty()) contest.scene = problem->scene();
  return contest;
}

// The exact motion in closed form, as a solver without steps.
Entrant exact_entrant(const std::shared_ptr<const scene::SceneProblem>& problem) {
  Entrant entrant{.info = {}, .unfit = {}, .solve = {}};
  entrant.info.library = "odeum";
  entrant.info.method = "closed_form";
  entrant.info.family = "exact";
  entrant.info.adaptive = true;
  entrant.info.controller = "none: exact at any time";
  entrant.info.needs = "free particles under a constant force";
  entrant.info.source = "q = q0 + v0 t + g t^2 / 2";
  if (!problem->structure().closed_form) {
    entrant.unfit = "needs " + entrant.info.needs;
    return entrant;
  }
  entrant.solve = [problem](const Request& request) {
    require_sound(request, 0, problem->size());
    Outcome outcome;
    std::vector<double> y(problem->size());
    for (const double t : request.stops) {
      problem->closed_form(t, problem->start().data(), y.data());
      outcome.record(t, y.data(), y.size());
    }
    return outcome;
  };
  return entrant;
}

/// Components by particle, positions before velocities.
std::vector<std::string> names_of(std::size_t particles) {
  std::vector<std::string> names;
  for (const char* const prefix : {"", "v"})
    for (std::size_t i = 0; i < particles; ++i)
      for (const char axis : {'x', 'y', 'z'})
        names.push_back(fmt::format("{}{}{}", prefix, axis, i));
  return names;
}

Facts facts_of(const scene::Structure& s) {
  Facts facts;
  facts.emplace_back("particles", fmt::format("{}, {} of them fixed", s.particles, s.fixed));
  for (const scene::TermInfo& term : s.terms)
    facts.emplace_back("term",
                       fmt::format("{}: {} {}, {}", term.name, term.count, term.unit, term.law));
  facts.emplace_back("kernel", s.kernel);
  return facts;
}

/// What a solve may cost: some seconds of a processor, as foreseen from the number of terms, so
/// that it is the same on each machine.
std::uint64_t budget_of(const scene::SceneProblem& problem, std::uint64_t usual) {
  constexpr double operations = 2e10;
  const double evaluations = operations / truth::work_of(problem);
  return std::min(usual, static_cast<std::uint64_t>(std::max(evaluations, 2000.0)));
}

/// The truth of the case, and steps of studies to match.
void compute_truth(Case& c, const std::shared_ptr<const scene::SceneProblem>& problem,
                   const std::string& text, const std::string& file, const TruthBounds& bounds) {
  const TextTruth known = scene_truth(problem, c.stops, text, file, bounds);
  c.truth = known.truth;
  c.facts.emplace_back("truth", known.words);
  if (known.stops.empty()) c.settings.no_convergence = "no truth is known: " + known.words;
  cut_stops(c, known.stops);
  // A trial step of an implicit method factors a large matrix: only where explicit ones have
  // failed.
  constexpr std::size_t small = 64;
  choose_steps(c, problem->structure().order_kept > scene::order_at_kinks, !known.stops.empty(),
               problem->size() <= small ? many_trial_steps : most_trial_steps);
  c.settings.evaluation_budget = budget_of(*problem, c.settings.evaluation_budget);
}

Case make_scene(const std::string& file, const std::string& text, const scene::Scene& scene,
                const Span& span) {
  const auto problem =
      whole_problem(scene, std::isnan(span.until) ? *scene.duration : span.until, file);
  const scene::Structure& structure = problem->structure();
  Case c;
  c.equation = "m q'' = the sum of the scene's forces";
  c.source = file;
  c.tags = {"second_order", "mechanical", "scene"};
  c.nature.linear = structure.linear;
  c.nature.autonomous = problem->lives().empty();
  c.nature.highest_order = structure.order_kept;
  c.facts = facts_of(structure);
  if (!scene.emitters.empty())
    c.facts.emplace_back("emitted",
                         fmt::format("{} of the particles, which fly straight before their birth "
                                     "and after their death",
                                     structure.particles - scene.size()));
  c.y0 = problem->start();
  c.components = names_of(structure.particles);
  for (std::size_t i = 0; i < 3 * structure.particles; ++i)
    if (problem->bodies().free(i / 3)) c.measured.push_back(i);
  c.measures_particles = true;
  for (const int quarter : {1, 2, 3, 4}) c.stops.push_back(*scene.duration * quarter / 4);
  c.stops = stops_of(span, 0, c.stops);
  // Particles without a force have no energy of gravity.
  if (problem->lives().empty())
    c.energy = [problem](const double* y) { return problem->energy(y); };
  c.problem = erase(contest_of(problem));
  c.entrants = enroll_scene(problem);
  c.settings.evaluation_budget = budget_of(*problem, c.settings.evaluation_budget);
  c.truth = unknown_truth("not computed");
  c.compute_truth = [problem, text, file](Case& later, const TruthBounds& bounds) {
    compute_truth(later, problem, text, file, bounds);
  };
  return c;
}

}  // namespace

std::shared_ptr<const scene::SceneProblem> whole_problem(const scene::Scene& scene, double until,
                                                         const std::string& file) {
  constexpr double most = 4000;
  double emitted = 0;
  for (const scene::Emitter& emitter : scene.emitters) emitted += emitter.rate * until;
  const auto refuse = [&](const std::string& reason, const char* expected) {
    throw InputError(fmt::format("{}: emitters: {}; expected {} (odeum run takes this scene)", file,
                                 reason, expected));
  };
  if (emitted > most)
    refuse(fmt::format("{:.0f} particles are emitted, all of which a study computes", emitted),
           "at most 4000");
  if (!scene.emitters.empty())
    for (const scene::Contact& contact : scene.contacts)
      if (std::holds_alternative<scene::ParticleContact>(contact))
        refuse("those emitted may touch others, and the problem of a study has them from the start",
               "no contact between particles");
  scene::WholeScene whole = scene::with_all_particles(scene, until);
  if (scene.emitters.empty()) whole.lives.clear();
  return std::make_shared<const scene::SceneProblem>(whole.scene, std::move(whole.lives));
}

double extent_of(const double* y, std::size_t particles) {
  double largest = 0;
  for (std::size_t axis = 0; axis < 3 && particles > 0; ++axis) {
    double low = y[axis], high = y[axis];
    for (std::size_t i = 1; i < particles; ++i) {
      low = std::min(low, y[3 * i + axis]);
      high = std::max(high, y[3 * i + axis]);
    }
    largest = std::max(largest, high - low);
  }
  return largest;
}

TextTruth scene_truth(const std::shared_ptr<const scene::SceneProblem>& problem,
                      const std::vector<double>& times, const std::string& content,
                      const std::string& what, const TruthBounds& bounds) {
  if (problem->structure().closed_form) {
    TextTruth known;
    known.truth.at = [problem](double t, double* y) {
      problem->closed_form(t, problem->start().data(), y);
      return true;
    };
    double largest = 0;
    std::vector<double> y(problem->size());
    for (const double t : times) {
      known.truth.at(t, y.data());
      for (const double x : y) largest = std::max(largest, std::abs(x));
    }
    known.truth.floor = 4 * 0x1p-53 * largest;  // of a few operations
    known.truth.source = "the closed form of free particles";
    known.truth.closed_form = true;
    known.words = fmt::format("closed form of free particles; known to {:.1e}", known.truth.floor);
    known.stops = times;
    known.known_until = times.back();
    return known;
  }
  const auto reference = truth::kept_or_computed(
      "scene " + content, problem->size(), times, {}, bounds,
      [&] { return std::optional(truth::reference_of(problem, times, bounds)); });
  return truth_from(*reference, times, {}, what);
}

Statement scene_statement(std::string id, std::string file, std::string text, scene::Scene scene,
                          const Span& span) {
  std::string title = scene.name.empty() ? id : scene.name;
  return {.id = std::move(id),
          .title = std::move(title),
          .tags = {},
          .make = [file = std::move(file), text = std::move(text), scene = std::move(scene), span] {
            return make_scene(file, text, scene, span);
          }};
}

Entrants enroll_scene(const std::shared_ptr<const scene::SceneProblem>& problem) {
  Entrants entrants = enroll(erase(contest_of(problem)));
  entrants.add(exact_entrant(problem));
  return entrants;
}

}  // namespace odeum::cases
