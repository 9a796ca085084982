// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <optional>
#include <set>

#include "odeum/cases/conditions.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/cli/run.hpp"
#include "odeum/cli/run_rows.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/core/standard_streams.hpp"
#include "odeum/input/yaml_tree.hpp"
#include "odeum/problem/events.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/report/text.hpp"
#include "odeum/studies/convergence/settings.hpp"
#include "odeum/trajectories/run_page.hpp"
#include "odeum/truth/computed_truth.hpp"
#include "odeum/why/why_answer.hpp"

namespace odeum::cli {
namespace {

using trajectories::CaseRun;

/// Where the truth ends before a run without outputs does, adds the last time on its grid at which
/// the error is known; whether there is one.
bool stop_at_last_truth(Request& request, const Case& c) {
  if (c.end() == c.stops.back() || request.stops.size() > 1) return false;
  const double end = request.stops.back();
  for (std::size_t k = c.stops.size(); k-- > 0;) {
    if (c.stops[k] >= end) continue;
    Request with = request;
    with.stops = {c.stops[k], end};
    if (with.mode == Mode::fixed && !FixedGrid(c.t0, with).fits()) continue;
    request = with;
    request.over_stops = true;
    return true;
  }
  return false;
}

// The stops at which the study measures the error; empty: no study is named.
std::vector<double> stops_of(const Case& c, const std::string& study) {
  if (study.empty()) return {};
  return study == "speed" ? c.timed_stops() : study::convergence_stops(c);
}

CaseRun prepare(const Case& c, const std::string& solver, const RunOptions& options) {
  const Entrant& entrant = find_entrant(c.entrants, c.id, solver);
  const std::vector<double> stops = stops_of(c, options.stops);
  const double end = stops.empty() ? c.end() : stops.back();
  CaseRun run{&entrant, make_request(options.settings, c.t0, end, c.y0.size(), entrant.info), {}};
  run.request.options = library_options(options, entrant.info);
  if (!stops.empty())
    run.request.stops = stops;
  else if (!options.out.empty() || options.settings.every)
    ask_for_output(run.request, options.settings, c.t0, c.y0.size());
  return run;
}

// Computes the truth at the outputs where the case does not know it. On stiff problems that takes
// many seconds, and is done only where nothing is known at the end.
Truth truth_of(const Case& c, const std::vector<CaseRun>& runs) {
  constexpr std::size_t most = 5000;  // outputs, of which a reference costs a second
  std::set<double> times(c.stops.begin(), c.stops.end());
  double end = c.t0;
  for (const CaseRun& run : runs) {
    const std::vector<double>& stops = run.request.stops;
    end = std::max(end, stops.back());
    const std::size_t apart = 1 + stops.size() / most;
    for (std::size_t k = stops.size(); k > 0; k -= std::min(k, apart)) times.insert(stops[k - 1]);
  }
  times.erase(times.upper_bound(end), times.end());
  std::vector<double> state(c.y0.size());
  const auto known = [&](double t) { return c.truth.at(t, state.data()); };
  if (c.nature.stiff && known(end)) return c.truth;
  // What ended the truth once would end it again.
  if (c.end() > c.stops.back() &&
      std::all_of(times.begin(), times.upper_bound(c.stops.back()), known))
    return c.truth;
  return truth::truth_at(c, {times.begin(), times.end()});
}

std::string events_text(const Events& events, const Outcome& outcome) {
  constexpr std::size_t most = 12;
  const std::size_t count = outcome.events.size();
  std::string text = fmt::format("events  {}", count);
  for (std::size_t k = 0; k < count; ++k) {
    if (count > most && k == most - 1) {
      text += ", ...";
      k = count - 1;
    }
    const EventMet& met = outcome.events[k];
    text += fmt::format("{}{} at t = {}", k == 0 ? ": " : ", ", events.names[met.event],
                        record::format_number(met.t));
  }
  return text + "\n";
}

std::string describe(const Case& c, const CaseRun& run, const RunRow& row) {
  const Outcome& outcome = run.outcome;
  const double end = run.request.stops.back();
  std::string text = fmt::format("solver  {}\n", run.entrant->info.id());
  text += run.request.mode == Mode::fixed
              ? fmt::format("step    {:.12g}, {} steps to t = {:.12g}\n",
                            step_of(run.request, c.t0), run.request.steps, end)
              : fmt::format("tol     {}, {} steps and {} rejected to t = {:.12g}\n",
                            text_of_tolerance(run.request), outcome.counters.steps,
                            outcome.counters.rejected_steps, end);
  if (run.request.mode == Mode::adaptive && run.request.stops.size() > 1 &&
      run.entrant->info.library != "odeum")
    text += fmt::format(
        "output  at {} times, on which a peer may end its steps: counts and the end are those of "
        "a run without output\n",
        run.request.stops.size());
  text += fmt::format("status  {}{}{}\n", to_string(outcome.status),
                      outcome.detail.empty() ? "" : ": ", outcome.detail);
  text += "cost    " + cost_text(outcome.counters) + "\n";
  if (c.problem.events) text += events_text(*c.problem.events, outcome);
  if (outcome.status != Status::ok) return text;
  const std::size_t n = c.y0.size();
  if (n <= 8) {
    text += "state  ";
    for (std::size_t i = 0; i < n; ++i)
      text += " " + record::format_number(outcome.states[(run.reached(n) - 1) * n + i]);
    text += "\n";
  }
  text += error_text(c, run, row);
  if (const double difference = trajectories::difference_to_scheme(c, run); !std::isnan(difference))
    text += fmt::format("scheme  {:.3g} at most from its own closed form\n", difference);
  return text;
}

// Why a run failed: in a few seconds' time where it cost little, and the command that says more.
std::string why_text(const Case& c, const CaseRun& run, const RunOptions& options) {
  constexpr std::uint64_t cheap = 500'000;
  constexpr double seconds = 5;
  if (c.problem.events && c.problem.events->isolated) return {};
  Request request = run.request;
  request.stops = {request.stops.back()};
  const std::string solver = run.entrant->info.id();
  std::string text;
  if (run.outcome.counters.work < cheap)
    text = "why     " +
           why::first_line(why::why(c, solver, request, seconds, cases::conditions_of(c))) + "\n";
  return text + fmt::format("more    odeum why {}{} --solver {} {}\n", shell_word(options.what),
                            options.more, solver, why::setting_of(request, c));
}

/// Writes the files of the runs and their page; returns the lines that name them.
std::string write_files(const record::OutputFolder& folder, const Case& c,
                        const std::vector<CaseRun>& runs, const std::vector<RunRow>& rows,
                        const RunOptions& options, bool from_file) {
  trajectories::RunTexts texts{
      .title = c.title,
      .lead = c.id,
      .facts = {{"Equation", c.equation}, {"Source", c.source}, {"Truth", c.truth.source}}};
  // The page has the truth of every case.
  for (const auto& fact : c.facts)
    if (from_file && fact.first != "truth" && fact.first != "code") texts.facts.push_back(fact);
  for (const Parameter& parameter : c.parameters)
    texts.facts.emplace_back(parameter.name, record::format_number(parameter.value) +
                                                 (parameter.meaning.empty() ? "" : ", ") +
                                                 parameter.meaning);
  const CaseRun& first = runs.front();
  texts.facts.emplace_back(
      "Setting", first.request.mode == Mode::fixed
                     ? fmt::format("step {:.12g}",
                                   options.settings.step.value_or(step_of(first.request, c.t0)))
                     : "tolerance " + text_of_tolerance(first.request));
  const bool page = trajectories::write_case_page(folder, c, runs, rows, texts);
  remark_on_page(page);
  std::string text;
  for (const std::string file : {"solution.csv", "trajectory.csv", "steps.csv", "index.html"})
    if (page || file != "index.html")
      text += fmt::format("file    {}\n", (folder.path() / file).string());
  return text;
}

void solve(CaseRun& run) {
  run.outcome = trajectories::solve_with_outputs(*run.entrant, run.request);
}

/// Solves before the truth is known, which may take much longer, says how each run ended, and
/// writes the files.
void solve_before_truth(std::vector<CaseRun>& runs, const Case& c, const RunOptions& options,
                        const std::optional<record::OutputFolder>& folder, bool from_file) {
  for (CaseRun& run : runs) {
    const std::clock_t begin = std::clock();
    solve(run);
    remark(
        first_text(run, c.y0.size(), static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC));
    if (interrupted) return;
  }
  if (!folder || runs.empty()) return;
  std::vector<RunRow> rows;
  for (const CaseRun& run : runs) rows.push_back(trajectories::row_of(c, run));
  write_files(*folder, c, runs, rows, options, from_file);
}

/// What was found in a file, for people.
std::string text_of_file(const Case& c, const RunOptions& options) {
  std::string text =
      fmt::format("{:<9}  {} ({})\n", "problem", report::plain(c.title), report::plain(c.source));
  for (const auto& [name, fact] : c.facts)
    text += fmt::format("{:<9}  {}\n", name, report::plain(fact));
  for (const std::string& line : describe_fits(c.entrants, options.verbose)) text += line + "\n";
  return text;
}

void require_solver_and_setting(const RunOptions& options) {
  if (options.solvers.empty())
    throw UsageError("--solver is required; a scene's own is taken without --stops");
  if (!has_setting(options.settings))
    throw UsageError("run needs --step or --tol, or --rtol and --atol");
}

std::vector<CaseRun> runs_of(const Case& c, const RunOptions& options) {
  require_solver_and_setting(options);
  std::vector<CaseRun> runs;
  for (const std::string& solver : those_that_fit(c.entrants, options))
    runs.push_back(prepare(c, solver, options));
  return runs;
}

int print_code(const Case& c, const RunOptions& options) {
  require_solver_and_setting(options);
  if (options.solvers.size() != 1) throw UsageError("--code takes one --solver");
  const Entrant& entrant = find_entrant(c.entrants, c.id, options.solvers.front());
  Request request = make_request(options.settings, c.t0, c.end(), c.y0.size(), entrant.info);
  request.options = library_options(options, entrant.info);
  print(code_of(c, struct_of(c, entrant.info), entrant, request));
  return success;
}

}  // namespace

int run_case(Session& session, const cases::Named& what, const RunOptions& given) {
  RunOptions options = given;
  const cases::Kind* const kind = cases::kind_of(what);
  const bool from_file = kind && !kind->has_frames, rows = options.format != "table";
  Case c = case_before_truth(session, what, options.problems);
  options.settings = settings_for(c, options.settings);
  if (options.code) return print_code(c, options);
  // Beside rows, what people read goes where remarks go.
  const auto say = [&](const std::string& text) { rows ? tell(text) : print(text); };
  const bool only_found = from_file && !rows && options.solvers.empty() &&
                          !has_setting(given.settings) && options.out.empty();
  std::vector<CaseRun> runs;
  if (!only_found) runs = runs_of(c, options);
  std::optional<record::OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out);
  const bool waits = options.truth && c.compute_truth;
  if (waits) {
    solve_before_truth(runs, c, options, folder, from_file);
    if (interrupted) return interrupted_code;
    complete(c);
  }
  if (from_file) say(text_of_file(c, options));
  if (only_found) return success;
  if (!from_file)
    for (const auto& [name, value] : assignments("--set", options.problems.sets))
      say(fmt::format("set     {} = {}\n", name, value));
  say(fmt::format("case    {}: {}\n", c.id, c.equation));
  for (CaseRun& run : runs) {
    // A run that ends beyond the truth is made again with an output where that ends.
    if (stop_at_last_truth(run.request, c) || !waits) solve(run);
    if (interrupted) return interrupted_code;
  }
  if (options.truth) {
    c.truth.source = cases::with_proof(c);
    c.truth = truth_of(c, runs);
  }
  std::vector<RunRow> all;
  for (const CaseRun& run : runs) {
    const RunRow& row = all.emplace_back(trajectories::row_of(c, run));
    say(describe(c, run, row));
    if (run.outcome.status != Status::ok) say(why_text(c, run, options));
  }
  if (folder) say(write_files(*folder, c, runs, all, options, from_file));
  if (rows) print_rows(all, options.format, &c, runs);
  return std::ranges::any_of(all, &RunRow::stands) ? success : solver_failed;
}

}  // namespace odeum::cli
