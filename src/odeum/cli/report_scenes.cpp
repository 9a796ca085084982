// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/report_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "odeum/core/parallel.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/report/comparison.hpp"
#include "odeum/report/html.hpp"
#include "odeum/report/scene_files.hpp"
#include "odeum/scene/run/run.hpp"
#include "odeum/studies/runner.hpp"

namespace odeum::cli {
namespace {

constexpr std::uint64_t frame_count = 80;

struct Shown {
  const char* solver;
  std::uint64_t steps;  ///< 0: to the tolerance
  double tolerance;
  const char* why;
};
/// The first is drawn as exact: the truth is known at four times, where it is held against it.
constexpr Shown shown_runs[] = {
    {"odeum/verner98", 0, 1e-12, "exact"},
    {"odeum/cash_karp54", 0, 1e-3, "an explicit pair with step control"},
    {"odeum/symplectic_euler", 320, 0, "one evaluation a step, as games do"},
    {"odeum/implicit_euler", 320, 0, "the classic of cloth: it damps"},
    {"bullet/soft_body_force", 320, 0, "Bullet, springs as forces"},
    {"bullet/deformable_implicit", 320, 0, "Bullet, implicit deformable body"}};

struct Run {
  const Shown* what;
  const Entrant* entrant;
  Request request;
  Outcome outcome;
};

Request request_of(const Case& c, const Shown& what) {
  Request request;
  request.mode = what.steps ? Mode::fixed : Mode::adaptive;
  request.steps = what.steps;
  request.tolerance = what.tolerance;
  request.over_stops = true;
  request.budget.seconds = 20;
  const double length = c.stops.back() - c.t0;
  for (std::uint64_t k = 1; k <= frame_count; ++k)
    request.stops.push_back(
        k == frame_count ? c.stops.back() : c.t0 + static_cast<double>(k) * (length / frame_count));
  return request;
}

scene::RunResult frames_of(const Case& c, const scene::SceneProblem& problem, const Run& run) {
  scene::RunResult result;
  result.status = run.outcome.status;
  result.detail = run.outcome.detail;
  result.counters = run.outcome.counters;
  std::vector<std::size_t> ids(c.y0.size() / 6);
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = i;
  const auto keep = [&](double t, const double* y) {
    result.frames.push_back({.t = t,
                             .ids = ids,
                             .y = {y, y + c.y0.size()},
                             .kinetic = problem.kinetic(y),
                             .potential = problem.potential(y)});
    result.t = t;
  };
  keep(c.t0, c.y0.data());
  for (std::size_t k = 0; (k + 1) * c.y0.size() <= run.outcome.states.size(); ++k)
    keep(run.request.stops[k], run.outcome.states.data() + k * c.y0.size());
  return result;
}

std::vector<std::vector<double>> distances(const scene::RunResult& run,
                                           const scene::RunResult& exact) {
  std::vector<std::vector<double>> all;
  for (std::size_t k = 0; k < std::min(run.frames.size(), exact.frames.size()); ++k) {
    const std::vector<double>&a = run.frames[k].y, &b = exact.frames[k].y;
    auto& frame = all.emplace_back();
    for (std::size_t i = 0; i + 2 < a.size() / 2; i += 3)
      frame.push_back(std::hypot(a[i] - b[i], a[i + 1] - b[i + 1], a[i + 2] - b[i + 2]));
  }
  return all;
}

/// The largest difference to the truth, of a coordinate at the times at which it is known.
double from_truth(const Case& c, const Run& run) {
  double largest = 0;
  std::vector<double> y(c.y0.size());
  for (std::size_t k = 0; (k + 1) * y.size() <= run.outcome.states.size(); ++k) {
    if (!c.truth.at(run.request.stops[k], y.data())) continue;
    for (const std::size_t i : judge::measured_components(c))
      largest = std::fmax(largest, std::abs(run.outcome.states[k * y.size() + i] - y[i]));
  }
  return largest;
}

std::string setting_of(const Case& c, const Run& run) {
  return run.what->steps ? fmt::format("step {:.4g} s", (c.stops.back() - c.t0) /
                                                            static_cast<double>(run.what->steps))
                         : fmt::format("tolerance {:.0e}", run.what->tolerance);
}

/// Bullet's own bodies evaluate no right-hand side of ours.
std::string evaluations_of(const Run& run) {
  const std::uint64_t count = run.outcome.counters.rhs_evaluations;
  return count ? std::to_string(count) : "not counted";
}

/// Which run is nearest to the exact motion and which is farthest, with their costs.
std::string words_of(std::vector<std::pair<double, const Run*>> found) {
  if (found.size() < 2) return {};
  std::sort(found.begin(), found.end());
  const auto& [least, best] = found.front();
  const auto& [most, worst] = found.back();
  const auto count = [](const Run& run) {
    const Counters& counted = run.outcome.counters;
    return counted.rhs_evaluations ? report::show_count(counted.rhs_evaluations, "evaluation")
                                   : report::show_count(run.what->steps, "step");
  };
  return fmt::format(
      "<p><code>{}</code> stays within {} m of the exact motion, with {}; "
      "<code>{}</code> {}, with {}.</p>\n",
      best->entrant->info.id(), report::show_number(least), count(*best), worst->entrant->info.id(),
      std::isinf(most) ? std::string("does not reach the end")
                       : fmt::format("is off by up to {} m", report::show_number(most)),
      count(*worst));
}

}  // namespace

void add_replays(report::Page& page, const record::OutputFolder& folder, unsigned jobs) {
  const auto& on_page = page.facts().cases;
  if (std::none_of(on_page.begin(), on_page.end(),
                   [](const auto& c) { return c.id == replayed_case; }))
    return;
  const Case& c = study::find_case(replayed_case);
  const scene::SceneProblem problem(*c.problem.scene);
  std::vector<Run> runs;
  for (const Shown& what : shown_runs)
    for (const Entrant& entrant : c.entrants)
      if (entrant.info.id() == what.solver && entrant.unfit.empty())
        runs.push_back({&what, &entrant, request_of(c, what), {}});
  parallel_for(runs.size(), jobs,
               [&](std::size_t i) { runs[i].outcome = runs[i].entrant->solve(runs[i].request); });
  report::Comparison comparison;
  comparison.title = c.title + ", replayed";
  comparison.lead = c.id;
  const double checked = from_truth(c, runs.front());
  comparison.facts = {
      {"Equation", c.equation},
      {"Colour", "how far a particle is from its exact place, from a micrometre to a decimetre"},
      {"Exact",
       fmt::format("a run of {} to {:.0e}, within {:.1e} m of the truth ({}) at the times "
                   "at which that is known",
                   shown_runs[0].solver, shown_runs[0].tolerance, checked, c.truth.source)}};
  report::Table table("numbers");
  table.head({{"solver"}, {"setting"}, {"evaluations"}, {"largest error, m"}, {"status"}, {"is"}});
  const scene::RunResult exact = frames_of(c, problem, runs.front());
  std::vector<std::pair<double, const Run*>> found;  // the largest error of each
  for (const Run& run : runs) {
    const scene::RunResult result = frames_of(c, problem, run);
    const auto errors = distances(result, exact);
    double largest = 0;
    for (const auto& frame : errors)
      for (const double error : frame) largest = std::fmax(largest, error);
    if (run.outcome.status != Status::ok) largest = std::numeric_limits<double>::infinity();
    if (&run != &runs.front()) found.emplace_back(largest, &run);
    const std::string id = run.entrant->info.id(), name = &run == &runs.front() ? "exact" : id;
    table.row({name}, {{setting_of(c, run)},
                       {evaluations_of(run)},
                       {&run == &runs.front() ? "" : report::show_number(largest)},
                       {to_string(run.outcome.status)},
                       {run.what->why}});
    const std::string file = report::file_stem(id) + ".html";
    folder.write("replay/" + file,
                 report::replay_page(*c.problem.scene, result, {id, setting_of(c, run)}, errors));
    comparison.replays.push_back({name + ", " + setting_of(c, run), file});
  }
  comparison.table = table;
  folder.write("replay/cloth.html", report::comparison_page(comparison));
  page.section(
      {.id = "replays",
       .title = "The cloth, replayed in step",
       .place = 450,
       .html = words_of(found) +
               "<p><a href=\"replay/cloth.html\">Open the replays</a>: own integrators and "
               "Bullet's beside the exact motion, in step, the error as colour.</p>\n" +
               table.html(),
       .short_title = "Replays"});
}

}  // namespace odeum::cli
