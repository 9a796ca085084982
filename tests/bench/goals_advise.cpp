// SPDX-License-Identifier: BSD-3-Clause
// The regret of advice: the time of the setting advised over that of the best of an exhaustive
// search on a ladder, both timed again side by side.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>

#include "goals.hpp"
#include "odeum/advise/race.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/core/glob.hpp"
#include "odeum/core/interrupt.hpp"

namespace odeum::bench {
namespace {

constexpr double errors[] = {1e-3, 1e-6, 1e-9};
constexpr double ladder = 4;  // settings a decade
constexpr std::size_t most_timed = 8;

/// A solver at the coarsest setting of the ladder that has the error.
struct Found {
  const Entrant* entrant;
  Request request;
  double ns;
};
using Answers = std::map<std::string, Found>;  // by solver and kind of setting

std::string key_of(const Entrant& entrant, Mode mode) {
  return fmt::format("{} --{}", entrant.info.id(), mode == Mode::fixed ? "step" : "tol");
}

/// NaN where the run fails.
double error_of(const Entrant& entrant, const Request& request, const judge::Judge& judge) {
  const Outcome outcome = entrant.solve(request);
  if (outcome.status != Status::ok) return nan;
  double error = 0;
  for (const judge::StopError& at : judge.errors(outcome))
    if (!(at.error_max <= error)) error = at.error_max;
  return error;
}

/// Climbs the ladder of one solver up to the error. A run of ten times the best time is stopped.
void climb(const Case& c, const Entrant& entrant, Mode mode, const judge::Judge& judge,
           double error, double& best_ns, Answers& answers) {
  const double order = std::isnan(entrant.info.order) ? 2 : std::max(1.0, entrant.info.order);
  const double ratio = std::pow(10, 1 / (mode == Mode::adaptive ? ladder : ladder * order / 4));
  const auto multiple = static_cast<double>(c.settings.steps_multiple);
  double fineness = mode == Mode::adaptive ? 10 : static_cast<double>(c.settings.coarsest_steps);
  // Where nobody may have the error, runs that fail early could go on to the finest steps for
  // hours.
  const double finest = mode == Mode::adaptive ? 1.1e14 : std::isfinite(best_ns) ? 1e8 : 1e5;
  for (; fineness < finest; fineness *= ratio) {
    Request request;
    request.mode = mode;
    request.stops = c.stops;
    if (mode == Mode::adaptive)
      set_tolerance(request, c, 1 / fineness);
    else
      request.steps = static_cast<std::uint64_t>(multiple * std::ceil(fineness / multiple));
    request.budget.seconds = std::clamp(1e-8 * best_ns, 2e-3, std::isfinite(best_ns) ? 0.5 : 0.05);
    const double start = study::thread_seconds();
    const double has = error_of(entrant, request, judge);
    const double ns = 1e9 * (study::thread_seconds() - start);
    if (has <= error) {
      if (!entrant.info.id().ends_with("exponential_propagator")) best_ns = std::min(best_ns, ns);
      answers.insert_or_assign(key_of(entrant, mode), Found{&entrant, request, ns});
      return;
    }
    if (ns > 1e9 * request.budget.seconds) return;
  }
}

/// `best_ns`: a time that is known to be enough, or infinite; it bounds the runs, no more.
Answers search_all(const Case& c, double error, double best_ns) {
  const judge::Judge judge(c, c.stops);
  Answers answers;
  for (std::size_t k = 0; k < c.entrants.size(); ++k) {
    const Entrant& entrant = c.entrants[k];
    if (!entrant.unfit.empty() || entrant.info.id().ends_with("exponential_propagator")) continue;
    if (entrant.info.adaptive) climb(c, entrant, Mode::adaptive, judge, error, best_ns, answers);
    if (entrant.info.fixed && c.settings.no_fixed_steps.empty())
      climb(c, entrant, Mode::fixed, judge, error, best_ns, answers);
  }
  return answers;
}

/// Least times in nanoseconds, timed in turn without the guard.
std::vector<double> times_of(const std::vector<Found>& runs) {
  std::vector<double> least(runs.size(), infinity);
  const study::Pinned pinned;
  for (int round = 0; round < 15; ++round)
    for (std::size_t k = 0; k < runs.size(); ++k) {
      Request request = runs[k].request;
      request.budget.watched = false;
      if (round > 2 && least[k] > 3e8) continue;
      least[k] = std::min(least[k],
                          study::time_call([&] { runs[k].entrant->solve(request); }, runs[k].ns));
    }
  return least;
}

struct Regret {
  std::string question;
  double advised = infinity;               ///< over the best; infinite without an answer
  double kept = nan;                       ///< error over that asked
  std::map<std::string, double> others{};  ///< of each solver that has the error
  std::string text{};
};

Regret regret_of(const Case& c, double error) {
  Regret regret{fmt::format("{} at {:g}", c.id, error)};
  advise::Wishes wishes;
  wishes.error = error;
  const advise::Advice advice = advise::advise({&c}, wishes);
  const Answers answers = search_all(
      c, error, advice.failure.empty() ? advice.candidates[advice.winner].found->ns : infinity);
  if (answers.empty() && !advice.failure.empty()) {
    regret.advised = nan;  // nobody has that error
    return regret;
  }
  std::vector<std::pair<double, std::string>> order;
  for (const auto& [id, found] : answers) order.emplace_back(found.ns, id);
  std::sort(order.begin(), order.end());
  std::vector<Found> timed;
  for (std::size_t k = 0; k < std::min(order.size(), most_timed); ++k)
    timed.push_back(answers.at(order[k].second));
  if (advice.failure.empty()) {
    const advise::Candidate& winner = advice.candidates[advice.winner];
    timed.push_back({winner.entrant, winner.found->request(), winner.found->ns});
    regret.kept =
        error_of(*winner.entrant, winner.found->request(), judge::Judge(c, c.stops)) / error;
  }
  const std::vector<double> least = times_of(timed);
  const double best = *std::min_element(least.begin(), least.end());
  for (const auto& [id, found] : answers) regret.others[id] = found.ns / order.front().first;
  for (std::size_t k = 0; k < std::min(order.size(), most_timed); ++k)
    regret.others[order[k].second] = least[k] / best;
  if (advice.failure.empty()) {
    regret.advised = least.back() / best;
    const std::size_t first = std::min_element(least.begin(), least.end()) - least.begin();
    regret.text = fmt::format("{} against {}, {:.3g} us", timed.back().entrant->info.id(),
                              timed[first].entrant->info.id(), 1e-3 * best);
  } else {
    regret.text = advice.failure;
  }
  return regret;
}

/// The value that the share of them does not exceed.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  if (values.empty()) return nan;
  return values[static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) -
                1];
}

Row row_of(const std::string& what, const std::vector<double>& values, double share, double goal,
           std::string note = {}) {
  return {.what = what,
          .goal = goal,
          .measured = quantile(values, share),
          .at_most = true,
          .note = std::move(note)};
}

/// What always the same solver costs; infinite where it has not the error.
std::vector<double> always(const std::vector<Regret>& all, const std::string& id) {
  std::vector<double> values;
  for (const Regret& regret : all) {
    const auto found = regret.others.find(id);
    values.push_back(found == regret.others.end() ? infinity : found->second);
  }
  return values;
}

std::string single_best(const std::vector<Regret>& all) {
  std::map<std::string, double> sums;
  // A question without an answer counts as a hundredfold time.
  for (const Regret& regret : all)
    for (const auto& [id, ratio] : regret.others) sums[id] += std::log(std::min(ratio / 100, 1.0));
  return std::min_element(sums.begin(), sums.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

}  // namespace

std::vector<Row> advise_rows() {
  std::vector<Regret> all;
  const char* only = std::getenv("ODEUM_ADVISE_CASES");
  std::size_t unanswered = 0;
  for (const std::string& id : known_ids()) {
    if (only && !any_glob_matches({only}, id)) continue;
    const Case& c = known_case(id);
    for (const double error : errors) {
      if (error <= c.truth.floor) continue;
      Regret regret = regret_of(c, error);
      if (std::isnan(regret.advised)) {
        ++unanswered;
        continue;
      }
      fmt::print("  {:<40} {:>8.3f} of the best, {:.2f} of the error  {}\n", regret.question,
                 regret.advised, regret.kept, regret.text);
      std::fflush(stdout);
      all.push_back(std::move(regret));
    }
  }
  if (all.empty()) return {};
  std::vector<double> advised, kept;
  for (const Regret& regret : all) {
    advised.push_back(regret.advised);
    kept.push_back(regret.kept <= 1 ? 1 : 0);
  }
  const auto worst = std::max_element(all.begin(), all.end(), [](const Regret& a, const Regret& b) {
    return a.advised < b.advised;
  });
  const double share = static_cast<double>(std::count(kept.begin(), kept.end(), 1)) /
                       static_cast<double>(all.size());
  std::vector<Row> rows{
      row_of(fmt::format("regret of advise, median of {} questions", all.size()), advised, 0.5,
             1.05, fmt::format("{} more that nobody here answers", unanswered)),
      row_of("regret of advise, nine of ten", advised, 0.9, 1.2),
      row_of("regret of advise, the worst", advised, 1, 1.5, worst->question + ": " + worst->text),
      {.what = "share that keeps the error asked", .goal = 0.99, .measured = share, .unit = ""}};
  const std::string best = single_best(all);
  for (const auto& [what, id] : std::map<std::string, std::string>{
           {"always a 5(4) pair", "odeum/dormand_prince54 --tol"},
           {"always cvode/bdf", "cvode/bdf --tol"},
           {"always velocity Verlet", "odeum/velocity_verlet --step"},
           {"the single best solver, " + best, best}})
    for (const double of : {0.5, 0.9})
      rows.push_back(row_of(fmt::format("{}: {}", what, of == 0.5 ? "median" : "nine of ten"),
                            always(all, id), of, nan));
  return rows;
}

}  // namespace odeum::bench
