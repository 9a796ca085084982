// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/study.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "odeum/advise/race.hpp"
#include "odeum/studies/convergence/pair_runs.hpp"
#include "odeum/studies/convergence/settings.hpp"
#include "odeum/studies/precision/timing.hpp"
#include "odeum/truth/computed_truth.hpp"
#include "odeum/why/why_answer.hpp"

namespace odeum::sweep {
namespace {

std::vector<Quantity> measured(const std::vector<std::string>& names) {
  std::vector<Quantity> all;
  for (const std::string& name : names)
    all.push_back({.name = name, .kind = Quantity::Kind::measured, .component = all.size()});
  return all;
}

MemberRow order_of(Case& c, const StudyWishes& wishes) {
  MemberRow row{.solver = wishes.solver};
  const Entrant& entrant = fitting(c.entrants, wishes.solver);
  truth::know_truth(c, study::convergence_stops(c));
  const study::Pair pair{&c, &entrant, entrant.info.fixed ? Mode::fixed : Mode::adaptive};
  study::CaseMeasures measures{.gain = judge::perturbation_gain(c)};
  if (pair.mode == Mode::adaptive)
    measures.amplification = judge::measure_amplification(c, study::convergence_stops(c));
  const std::string& reason = study::reason_against(pair);
  const study::ConvergenceResult result =
      reason.empty() ? study::converge_pair(pair, measures, wishes.quick_orders)
                     : study::not_measured(pair, reason);
  const judge::OrderFit& fit = result.orders.front().fit;
  double least = nan;
  for (const study::ConvergenceRow& run : result.rows) {
    row.evaluations += run.counters.rhs_evaluations;
    if (!(run.error >= least)) least = run.error;
  }
  row.answer = judge::to_string(fit.verdict);
  if (std::isnan(fit.order)) row.status = row.answer;
  row.detail = row.answer + (fit.reason.empty() ? "" : ": " + fit.reason);
  row.values = {fit.order, fit.low, fit.high, least};
  return row;
}

constexpr std::array compared{1e-3, 1e-6, 1e-9};

MemberRow times_of(Case& c, const StudyWishes& wishes) {
  MemberRow row{.solver = wishes.solver};
  const Entrant& entrant = fitting(c.entrants, wishes.solver);
  truth::know_truth(c, c.timed_stops());
  constexpr double usual = 0.5, seconds_of_solve = 2;
  const double seconds = wishes.seconds > 0 ? wishes.seconds : usual;
  const study::TimedCase stage(c);
  std::vector<study::TimedSolver> solvers{
      {&entrant, entrant.info.adaptive ? Mode::adaptive : Mode::fixed, nullptr}};
  study::run_guarded(stage, solvers.front(), seconds_of_solve);
  study::time_all(stage, solvers, seconds / 2);
  if (study::settle_errors(stage, solvers, 1)) study::time_all(stage, solvers, seconds / 2);
  study::check_fastest(stage, solvers, 1);
  std::vector<study::PrecisionRow> rows;
  for (const study::TimedRun& trial : solvers.front().trials) {
    rows.push_back(trial.row);
    row.evaluations += trial.row.counters.rhs_evaluations;
  }
  row.values.assign(compared.size(), nan);
  std::size_t reached = 0;
  for (const study::FastestRow& best : study::fastest(rows, stage.floor))
    for (std::size_t k = 0; k < compared.size(); ++k)
      if (std::abs(best.compared / compared[k] - 1) < 0.01) {
        row.values[k] = best.wall_ns_min;
        ++reached;
      }
  row.answer = fmt::format("{} of {} errors reached", reached, compared.size());
  row.detail = row.answer;
  if (reached == 0) row.status = "not_reached";
  return row;
}

MemberRow advice_for(Case& c, const StudyWishes& wishes) {
  advise::Wishes asked;
  asked.error = wishes.error;
  asked.seconds = wishes.seconds;
  if (!wishes.solver.empty()) asked.solvers = {wishes.solver};
  truth::know_truth(c, c.stops);
  const advise::Advice advice = advise::advise({&c}, asked);
  MemberRow row{.solver = wishes.solver};
  row.values.assign(2, nan);
  if (!advice.failure.empty()) {
    row.status = row.answer = "no_answer";
    row.detail = advice.failure;
    return row;
  }
  const advise::Candidate& winner = advice.candidates[advice.winner];
  row.solver = row.answer = winner.entrant->info.id();
  row.detail = why::setting_of(winner.found->request(), c);
  row.values = {winner.times.min(), winner.found->error};
  row.evaluations = winner.found->counters().rhs_evaluations;
  return row;
}

}  // namespace

std::shared_ptr<const MemberStudy> member_study(const std::string& name,
                                                const StudyWishes& wishes) {
  MemberStudy study{.name = name};
  const auto by = [&](MemberRow (*measure)(Case&, const StudyWishes&)) {
    return [=](Case& member) { return measure(member, wishes); };
  };
  if (name == "converge") {
    study.quantities = measured({"order", "order_low", "order_high", "least_error"});
    study.measure = by(order_of);
  } else if (name == "precision") {
    study.quantities = measured({"ns_to_1e-3", "ns_to_1e-6", "ns_to_1e-9"});
    study.measure = by(times_of);
    study.timed = true;
  } else if (name == "advise") {
    study.words = fmt::format("--error {}", wishes.error);
    if (wishes.seconds > 0) study.words += fmt::format(" --seconds {}", wishes.seconds);
    study.quantities = measured({"ns", "error"});
    study.measure = by(advice_for);
    study.timed = true;
  } else {
    return nullptr;
  }
  return std::make_shared<const MemberStudy>(std::move(study));
}

}  // namespace odeum::sweep
