// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/precision/precision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <map>

#include "odeum/contest/inlined.hpp"
#include "odeum/core/glob.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/core/progress.hpp"
#include "odeum/judge/errors.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::study {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint64_t most_repetitions = 15;
constexpr double longest_repeated_ns = 2e7;

/// A setting of a solver: its row, and the data for a timed run.
struct Trial {
  PrecisionRow row;
  Request request;
  std::vector<double> states;
  double guarded_ns = 0;  ///< of the guarded run: an estimate
  bool far = false;       ///< see mark_far
  Times times;

  bool ok() const { return row.status == to_string(Status::ok); }
};

/// A solver on a case in one mode, with its settings from coarse to fine.
struct Contender {
  const Entrant* entrant;
  Mode mode;
  const Entrant* inlined;  ///< the same for timed runs; null where there is none
  std::vector<Trial> trials;
};

struct Stage {
  const Case& c;
  std::vector<double> stops;
  double floor;
  judge::Judge judge;
  judge::Amplification amplification;

  explicit Stage(const Case& each)
      : c(each),
        stops(each.timed_stops()),
        floor(each.timed_floor()),
        judge(each, stops),
        amplification(judge::measure_amplification(each, stops)) {}

  /// The ratio of the horizon to that of other studies.
  double stretch() const { return std::max(1.0, (stops.back() - c.t0) / (c.stops.back() - c.t0)); }
};

std::vector<Request> settings_of(const Stage& stage, Mode mode, double seconds) {
  std::vector<Request> requests;
  Request request;
  request.stops = stage.stops;
  request.budget.evaluations = stage.c.settings.evaluation_budget;
  const bool many = stage.c.y0.size() > dense_dimension_limit;
  request.budget.evaluations =
      many ? request.budget.evaluations / 8
           : std::min<std::uint64_t>(
                 400'000, static_cast<std::uint64_t>(
                              stage.stretch() * static_cast<double>(request.budget.evaluations)));
  request.budget.seconds = seconds;
  request.mode = mode;
  if (mode == Mode::adaptive) {
    // Errors grow along a long horizon: the smallest reachable error needs tolerances near
    // rounding.
    const int finest = stage.stretch() > 1 ? 14 : 12;
    for (int exponent = 3; exponent <= finest; ++exponent) {
      set_tolerance(request, stage.c, std::pow(10.0, -exponent));
      requests.push_back(request);
    }
    return requests;
  }
  const double coarsest = static_cast<double>(stage.c.settings.coarsest_steps) * stage.stretch();
  for (int k = 0; k < 8; ++k) {
    const auto units =
        std::ceil(std::ldexp(coarsest, k) / static_cast<double>(stage.c.settings.steps_multiple));
    request.steps = static_cast<std::uint64_t>(units) * stage.c.settings.steps_multiple;
    requests.push_back(request);
  }
  return requests;
}

PrecisionRow blank_row(const Stage& stage, const SolverInfo& info, Mode mode) {
  auto row = named_row<PrecisionRow>(stage.c, info);
  row.mode = mode;
  row.setting = row.error = row.wall_ns_min = row.wall_ns_median = nan;
  return row;
}

/// The guarded run, which counts and measures the error.
Trial run_guarded(const Stage& stage, const Entrant& entrant, const Request& request) {
  Trial trial{.row = blank_row(stage, entrant.info, request.mode),
              .request = request,
              .states = {},
              .times = {}};
  trial.row.setting = request.mode == Mode::adaptive ? request.tolerance
                                                     : (request.stops.back() - stage.c.t0) /
                                                           static_cast<double>(request.steps);
  const auto start = std::chrono::steady_clock::now();
  Outcome outcome = entrant.solve(request);
  trial.guarded_ns =
      std::chrono::duration<double, std::nano>(std::chrono::steady_clock::now() - start).count();
  trial.row.status = to_string(outcome.status);
  trial.row.detail = outcome.detail;
  trial.row.counters = outcome.counters;
  trial.row.judged.answer = judge::Answer::none;
  if (!trial.ok()) return trial;
  trial.row.error = 0;
  const std::vector<judge::StopError> errors = stage.judge.errors(outcome);
  for (const judge::StopError& error : errors)
    trial.row.error = std::max(trial.row.error, error.error_max);
  trial.row.judged =
      request.mode == Mode::fixed
          ? judge::judge_fixed_answer(errors, stage.judge.scale())
          : judge::judge_answer(errors, stage.amplification, request.largest_tolerance(),
                                static_cast<double>(outcome.counters.steps), stage.floor,
                                stage.judge.scale());
  if (trial.row.error <= stage.floor) trial.row.detail = "at the truth's floor";
  trial.states = std::move(outcome.states);
  return trial;
}

/// Tolerances looser than the first, while that still reaches the largest error compared: a solver
/// that is more accurate than its tolerance gets there by a looser one.
void run_looser(const Stage& stage, Contender& contender) {
  for (int more = 0; more < 2; ++more) {
    const Trial& coarsest = contender.trials.front();
    if (!coarsest.ok() || !(coarsest.row.error < largest_compared_error)) return;
    Request request = coarsest.request;
    set_tolerance(request, stage.c, 10 * request.tolerance);
    Trial looser = run_guarded(stage, *contender.entrant, request);
    contender.trials.insert(contender.trials.begin(), std::move(looser));
  }
}

void run_guarded(const Stage& stage, Contender& contender, double seconds) {
  const Entrant& entrant = *contender.entrant;
  const std::string& reason = entrant.unfit.empty() && contender.mode == Mode::fixed
                                  ? stage.c.settings.no_fixed_steps
                                  : entrant.unfit;
  if (!reason.empty()) {
    contender.trials.emplace_back().row =
        not_applicable(blank_row(stage, entrant.info, contender.mode), reason);
    return;
  }
  for (const Request& request : settings_of(stage, contender.mode, seconds)) {
    contender.trials.push_back(run_guarded(stage, entrant, request));
    // Finer settings cost more and are not needed.
    if (contender.trials.back().row.status == to_string(Status::over_budget)) break;
  }
  if (contender.mode == Mode::adaptive) run_looser(stage, contender);
}

/// Times a trial once with the bare right-hand side, and checks that it ends at the state of the
/// counted run: to a tenth of that run's error, or to rounding.
void time_once(const Stage& stage, const Contender& contender, Trial& trial) {
  const auto& solve = contender.inlined ? contender.inlined->solve : contender.entrant->solve;
  trial.row.inlined = contender.inlined != nullptr;
  Request request = trial.request;
  request.budget.watched = false;
  Outcome outcome;
  trial.times.ns.push_back(time_call([&] { outcome = solve(request); }, trial.times.ns.empty()
                                                                            ? trial.guarded_ns / 2
                                                                            : trial.times.min()));
  double apart = outcome.states.size() == trial.states.size() ? 0 : nan;
  for (std::size_t i = 0; i < trial.states.size() && !std::isnan(apart); ++i)
    apart = std::max(apart, std::abs(outcome.states[i] - trial.states[i]));
  const double allowed = 0.1 * trial.row.error + stage.floor + 1e-12 * stage.judge.scale();
  if (!(apart <= allowed))
    trial.row.detail = fmt::format("the timed run ended {:.2g} away from the counted one", apart);
}

/// So many times behind another one of its library in guarded runs, a trial cannot be the fastest
/// at its error: guard and pointer cost up to 4.5 times an inlined right-hand side, little where
/// evaluations are long, and other programs may double a single time.
double far_behind(const Case& c) { return c.y0.size() > dense_dimension_limit ? 4 : 10; }

void mark_far(const Case& c, std::vector<Contender>& contenders) {
  std::vector<std::pair<const std::string*, Trial*>> trials;
  for (Contender& contender : contenders)
    for (Trial& trial : contender.trials)
      if (trial.ok()) trials.emplace_back(&contender.entrant->info.library, &trial);
  const auto smaller = [](auto& a, auto& b) { return a.second->row.error < b.second->row.error; };
  std::stable_sort(trials.begin(), trials.end(), smaller);
  std::map<std::string, double> least;  // by library, of those of no larger error
  for (const auto& [library, trial] : trials) {
    double& known = least.try_emplace(*library, trial->guarded_ns).first->second;
    known = std::min(known, trial->guarded_ns);
    trial->far = trial->guarded_ns > far_behind(c) * known;
  }
}

/// Interleaved repetitions: round after round over all solvers at a setting; one of what is far.
void time_all(const Stage& stage, std::vector<Contender>& contenders, double seconds) {
  mark_far(stage.c, contenders);
  double once = 0;
  std::size_t most_settings = 0;
  for (const Contender& contender : contenders) {
    most_settings = std::max(most_settings, contender.trials.size());
    for (const Trial& trial : contender.trials)
      if (trial.ok() && !trial.far) once += std::max(trial.guarded_ns, 20'000.0);
  }
  const auto rounds = static_cast<std::uint64_t>(
      std::clamp(seconds * 1e9 / std::max(once, 1.0), 2.0, double(most_repetitions)));
  const Pinned pinned;
  for (std::size_t k = 0; k < most_settings; ++k)
    for (std::uint64_t round = 0; round < rounds; ++round)
      for (Contender& contender : contenders) {
        if (k >= contender.trials.size() || !contender.trials[k].ok()) continue;
        if (interrupted) throw Interrupted();
        Trial& trial = contender.trials[k];
        if (round > 0 && trial.far) continue;
        // A long run averages disturbances: two repetitions suffice.
        if (round > 1 && trial.guarded_ns > longest_repeated_ns) continue;
        time_once(stage, contender, trial);
      }
}

/// Whether a solver is timed in a mode. One that has both is run at fixed steps too where these may
/// be faster: on smooth problems of few unknowns.
bool runs(const Case& c, const SolverInfo& info, Mode mode) {
  if (mode == Mode::adaptive) return info.adaptive;
  const bool worth = c.y0.size() <= dense_dimension_limit && c.settings.no_fixed_steps.empty() &&
                     !c.has_tag("stiff");
  return info.fixed && (!info.adaptive || worth);
}

std::vector<PrecisionRow> measure_case(const Case& c, const Options& options,
                                       const Runner& runner) {
  const Stage stage(c);
  const std::vector<Entrant> inlined = inlined_solvers(c);
  std::vector<Contender> contenders;
  for (const Entrant& entrant : c.entrants) {
    const std::string id = entrant.info.id();
    if (!any_glob_matches(options.solvers, id)) continue;
    const auto same = std::find_if(inlined.begin(), inlined.end(),
                                   [&](const Entrant& e) { return e.info.id() == id; });
    for (const Mode mode : {Mode::adaptive, Mode::fixed})
      if (runs(c, entrant.info, mode))
        contenders.push_back({&entrant, mode, same == inlined.end() ? nullptr : &*same, {}});
  }
  parallel_for(contenders.size(), runner.jobs(), [&](std::size_t i) {
    run_guarded(stage, contenders[i], options.number("solve-seconds", 2));
  });

  Conditions conditions;
  for (int attempt = 0; attempt < options.number("attempts", 2); ++attempt) {
    for (Contender& contender : contenders)
      for (Trial& trial : contender.trials) trial.times.ns.clear();
    const ConditionsMeter meter;
    time_all(stage, contenders, options.number("seconds", 4));
    conditions = meter.end();
    if (!disturbed(conditions.drift, conditions.processor_share)) break;
  }
  std::vector<PrecisionRow> rows;
  for (Contender& contender : contenders)
    for (Trial& trial : contender.trials) {
      PrecisionRow& row = trial.row;
      row.wall_ns_min = trial.times.min();
      row.wall_ns_median = trial.times.median();
      row.repetitions = trial.times.ns.size();
      row.measured = conditions.measured;
      if (row.repetitions) {
        row.drift = conditions.drift;
        row.processor_share = conditions.processor_share;
      }
      if (disturbed(row.drift, row.processor_share)) {
        if (!row.detail.empty()) row.detail += "; ";
        row.detail += fmt::format(
            "disturbed: the machine's speed drifted by {:.0f} %, and the timed runs had "
            "the processor for {:.0f} % of the time",
            100 * row.drift, 100 * row.processor_share);
      }
      rows.push_back(std::move(row));
    }
  mark_pareto(rows);
  return rows;
}

}  // namespace

PrecisionResult measure_precision(const Options& options, const Runner& runner) {
  const std::vector<const Case*> cases = select_cases(options.cases);
  PrecisionResult result;
  Progress progress("precision", static_cast<double>(cases.size()));
  for (const Case* c : cases) {
    PrecisionResult of_case;
    of_case.rows = measure_case(*c, options, runner);
    for (const PrecisionRow& row : of_case.rows)
      if (row.mode == Mode::adaptive && row.status == to_string(Status::ok))
        of_case.tolerances.push_back(
            {row.case_id, row.library, row.solver, row.setting, row.error, row.judged.answer});
    of_case.summary = summarise(of_case.rows, c->timed_floor());
    of_case.fastest = fastest(of_case.rows, c->timed_floor());
    record::append(result, std::move(of_case));
    progress.advance();
  }
  return result;
}

}  // namespace odeum::study
