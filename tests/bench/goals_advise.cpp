// SPDX-License-Identifier: BSD-3-Clause
// The regret of advice: the time of the setting advised over that of the best of an exhaustive
// search on a ladder, both timed again side by side.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <complex>
#include <csignal>
#include <cstdlib>
#include <map>
#include <optional>
#include <sstream>

#include "odeum/advise/race.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/scene_case.hpp"
#include "odeum/cases/spectrum.hpp"
#include "odeum/core/glob.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"
#include "regret.hpp"

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

/// A run of the search is dear; then a question takes minutes, and a case is asked one.
constexpr double dear_ns = 1e7, very_dear_ns = 1e8;

/// How long a run of the search may take, in seconds: so many times the best one. Enough to know
/// what is done without a measurement, too; less where that takes hours.
double most_seconds(double best_ns) {
  if (!std::isfinite(best_ns)) return 0.05;
  const double times = best_ns < 1e6 ? 10 : best_ns < dear_ns ? 3 : 1.5;
  return std::max(2e-3, 1e-9 * times * best_ns);
}

/// The rungs of the ladder of one solver, coarsest first; 0: beyond the last.
class Ladder {
 public:
  Ladder(const Case& c, const Entrant& entrant, Mode mode, double best_ns) : c_(c), mode_(mode) {
    const double order = std::isnan(entrant.info.order) ? 2 : std::max(1.0, entrant.info.order);
    ratio_ = std::pow(10, 1 / (mode == Mode::adaptive ? ladder : ladder * order / 4));
    // Where nobody may have the error, runs that fail early could go on to the finest steps for
    // hours.
    finest_ = mode == Mode::adaptive ? 1.1e14 : std::isfinite(best_ns) ? 1e8 : 1e5;
  }
  /// Nothing beyond the last rung.
  std::optional<Request> request(int rung) const {
    const double coarsest =
        mode_ == Mode::adaptive ? 10 : static_cast<double>(c_.settings.coarsest_steps);
    const double fineness = coarsest * std::pow(ratio_, rung);
    if (!(fineness < finest_)) return {};
    Request request;
    request.mode = mode_;
    request.stops = c_.stops;
    const auto multiple = static_cast<double>(c_.settings.steps_multiple);
    if (mode_ == Mode::adaptive)
      set_tolerance(request, c_, 1 / fineness);
    else
      request.steps = static_cast<std::uint64_t>(multiple * std::ceil(fineness / multiple));
    return request;
  }

 private:
  const Case& c_;
  Mode mode_;
  double ratio_, finest_;
};

/// Climbs the ladder of one solver up to the error.
void climb(const Case& c, const Entrant& entrant, Mode mode, const judge::Judge& judge,
           double error, double& best_ns, Answers& answers) {
  const Ladder rungs(c, entrant, mode, best_ns);
  // The error has been reached; else the run took too long, or there is no such rung.
  bool ended = false;
  const auto reaches = [&](int rung) {
    std::optional<Request> request = rungs.request(rung);
    ended = !request;
    if (ended) return false;
    request->budget.seconds = most_seconds(best_ns);
    const double start = study::thread_seconds();
    const double has = error_of(entrant, *request, judge);
    const double ns = 1e9 * (study::thread_seconds() - start);
    if (has <= error) {
      if (!entrant.info.id().ends_with("exponential_propagator")) best_ns = std::min(best_ns, ns);
      answers.insert_or_assign(key_of(entrant, mode), Found{&entrant, *request, ns});
      return true;
    }
    ended = ns > 1e9 * request->budget.seconds;
    return false;
  };
  // Dear runs: a decade at a time, and then the rungs between.
  const int stride = best_ns > dear_ns && std::isfinite(best_ns) ? 4 : 1;
  int rung = 0;
  while (!reaches(rung) && !ended) rung += stride;
  for (int between = std::max(0, rung - stride + 1); between < rung; ++between)
    if (reaches(between) || ended) return;
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

/// As estimated by the fastest decay: a step of its size is far shorter than the run.
bool is_stiff(const Case& c) {
  constexpr double many = 1000;
  double fastest = 0;
  for (const std::complex<double>& z : cases::spectrum_of(c).eigenvalues)
    if (-z.real() > std::abs(z.imag())) fastest = std::max(fastest, -z.real());
  return fastest * (c.stops.back() - c.t0) > many;
}

Regret regret_of(const Case& c, double error) {
  Regret regret{.case_id = c.id, .error = error};
  advise::Wishes wishes;
  wishes.error = error;
  const advise::Advice advice = advise::advise({&c}, wishes);
  regret.seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - wishes.start).count();
  regret.states = c.y0.size();
  regret.scene = c.measures_particles;
  regret.stiff = is_stiff(c);
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
  const double best = regret.best_ns = *std::min_element(least.begin(), least.end());
  for (const auto& [id, found] : answers) regret.others[id] = found.ns / order.front().first;
  for (std::size_t k = 0; k < std::min(order.size(), most_timed); ++k)
    regret.others[order[k].second] = least[k] / best;
  if (advice.failure.empty()) {
    regret.advised = least.back() / best;
    const std::size_t first = std::min_element(least.begin(), least.end()) - least.begin();
    regret.advised_id = timed.back().entrant->info.id();
    regret.best_id = timed[first].entrant->info.id();
  } else {
    regret.failure = advice.failure;
  }
  return regret;
}

/// Null where a scene is not a problem of ordinary differential equations, which is printed.
const Case* case_or_scene(const std::string& id) {
  for (const cases::SceneText& text : cases::all_scenes())
    if (text.name == id) {
      scene::ReadOptions options;
      options.need_solver = false;
      const std::string content(text.text);
      try {
        return &add_user_case(cases::scene_statement(
            id, id + ".yaml", content, scene::read_scene(id + ".yaml", content, options).scene));
      } catch (const InputError& error) {
        fmt::print(stderr, "  {}: {}\n", id, error.what());
        return nullptr;
      }
    }
  return &known_case(id);
}

/// The questions about one case. Throws Interrupted.
void ask(const std::string& id, std::vector<Regret>& all, std::size_t& unanswered) {
  const Case* const c = case_or_scene(id);
  if (c == nullptr) return;
  for (const double error : errors) {
    if (error <= c->truth.floor) continue;
    Regret regret = regret_of(*c, error);
    if (interrupted) throw Interrupted();
    if (std::isnan(regret.advised)) {
      ++unanswered;
      continue;
    }
    fmt::print(stderr, "  {:<40} {:>8.3f} of the best, {:.2f} of the error, {:.0f} s  {}\n",
               regret.question(), regret.advised, regret.kept, regret.seconds, regret.text());
    const bool last = regret.best_ns > very_dear_ns;
    all.push_back(std::move(regret));
    if (last) break;
  }
}

}  // namespace

std::vector<Row> advise_rows() {
  std::vector<Regret> all;
  std::vector<std::string> only;
  if (const char* given = std::getenv("ODEUM_ADVISE_CASES")) {
    std::istringstream stream(given);
    for (std::string glob; std::getline(stream, glob, ',');) only.push_back(glob);
  }
  std::size_t unanswered = 0;
  std::vector<std::string> ids = known_ids();
  for (const cases::SceneText& scene : cases::all_scenes()) ids.emplace_back(scene.name);
  // In the order of the globs.
  if (!only.empty()) {
    std::vector<std::string> chosen;
    for (const std::string& glob : only)
      for (const std::string& id : ids)
        if (any_glob_matches({glob}, id)) chosen.push_back(id);
    ids = std::move(chosen);
  }
  // An interrupt ends the questions, and the table is that of those asked.
  std::signal(SIGINT, [](int) { interrupted = true; });
  for (const std::string& id : ids) {
    try {
      ask(id, all, unanswered);
    } catch (const Interrupted&) {
      break;
    }
  }
  if (const char* file = std::getenv("ODEUM_REGRET_ROWS")) write_regret(all, file);
  return regret_rows(all, unanswered);
}

}  // namespace odeum::bench
