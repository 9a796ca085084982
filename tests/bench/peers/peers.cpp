// SPDX-License-Identifier: BSD-3-Clause
// Writes reports/measured/peers.csv to standard output: the settings that the documentation of each
// library leaves open, measured with the library alone; with the argument `bullet`
// reports/measured/peers_bullet.csv, with `sundials_defaults` that file.
#include "bench/peers/peers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <iterator>
#include <limits>
#include <map>

#include "odeum/cases/catalogue.hpp"

namespace odeum::peers {

double error_at_end(const Case& c, const std::vector<double>& y) {
  std::vector<double> exact(y.size());
  c.truth.at(c.stops.back(), exact.data());
  double error = 0, size = 0;
  for (std::size_t i = 0; i < y.size(); ++i) {
    error = std::max(error, std::abs(y[i] - exact[i]));
    size = std::max(size, std::abs(exact[i]));
  }
  return std::isfinite(error) ? error / size : unreached;
}

double cost_of(double error, const std::vector<Solved>& runs, double Solved::*cost) {
  double best = unreached;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (runs[k].error <= error) best = std::min(best, runs[k].*cost);
    if (k == 0 || !(runs[k - 1].error > error && runs[k].error < error)) continue;
    const double part =
        std::log(runs[k - 1].error / error) / std::log(runs[k - 1].error / runs[k].error);
    best = std::min(
        best, std::exp((1 - part) * std::log(runs[k - 1].*cost) + part * std::log(runs[k].*cost)));
  }
  return best;
}

namespace {

double processor_microseconds() { return 1e6 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// The best of three, processor time in microseconds: other programs do not count.
double timed(const Alternative& alternative, const Case& c, double tolerance, Run& run,
             Counted& counted) {
  double best = unreached;
  for (int repetition = 0; repetition < 3; ++repetition) {
    counted = {c.problem.view};
    const double start = processor_microseconds();
    run = alternative.run(c, tolerance, counted);
    best = std::min(best, processor_microseconds() - start);
  }
  return best;
}

/// What it costs to reach an error, by case and error.
using Costs = std::map<std::string, double>;

struct Sums {
  int runs = 0, solved = 0;
  long steps = 0, evaluations = 0;
  Costs time_to, evaluations_to;
};

Sums measure(const Alternative& alternative, const std::vector<const Case*>& cases) {
  Sums sums;
  for (const Case* c : cases) {
    std::vector<Solved> solved;
    for (const double tolerance : tolerances) {
      Run run;
      Counted counted{c->problem.view};
      const double time = timed(alternative, *c, tolerance, run, counted);
      const double error = run.ok ? error_at_end(*c, run.y) : unreached;
      ++sums.runs;
      if (!(error < 0.1)) continue;
      ++sums.solved;
      sums.steps += run.steps;
      sums.evaluations += counted.evaluations;
      solved.push_back({error, time, static_cast<double>(counted.evaluations)});
    }
    for (const double wanted : wanted_errors) {
      const double time = cost_of(wanted, solved, &Solved::time);
      if (!std::isfinite(time)) continue;
      const std::string key = fmt::format("{} {}", c->id, wanted);
      sums.time_to[key] = time;
      sums.evaluations_to[key] = cost_of(wanted, solved, &Solved::evaluations);
    }
  }
  return sums;
}

/// Geometric mean over the cases and errors that both reach.
double ratio(const Costs& costs, const Costs& first) {
  double sum = 0;
  int count = 0;
  for (const auto& [key, cost] : costs) {
    const auto other = first.find(key);
    if (other == first.end()) continue;
    sum += std::log(cost / other->second);
    ++count;
  }
  return std::exp(sum / count);
}

void add_rows(record::Records& table, const Choice& choice, const std::vector<const Case*>& cases) {
  Sums first;
  for (const Alternative& alternative : choice.alternatives) {
    const Sums sums = measure(alternative, cases);
    if (&alternative == &choice.alternatives.front()) first = sums;
    const auto number = [](auto value) { return static_cast<double>(value); };
    table.rows.push_back({choice.solver, choice.choice, alternative.setting, number(sums.solved),
                          number(sums.runs), number(sums.steps), number(sums.evaluations),
                          number(sums.time_to.size()),
                          number(cases.size() * std::size(wanted_errors)),
                          fmt::format("{:.2f}", ratio(sums.evaluations_to, first.evaluations_to)),
                          fmt::format("{:.2f}", ratio(sums.time_to, first.time_to)),
                          std::string(alternative.taken ? "yes" : "no"), choice.documentation});
    fmt::print(stderr, ".");
  }
}

std::vector<const Case*> cases_of(std::initializer_list<const char*> ids) {
  std::vector<const Case*> cases;
  for (const char* id : ids) cases.push_back(&known_case(id));
  return cases;
}

}  // namespace
}  // namespace odeum::peers

int main(int argc, char** argv) {
  using namespace odeum;
  using peers::Choice;
  const auto stiff = peers::cases_of(
      {"robertson_40", "robertson", "vdp_mu1000", "vdp_eps1e_6", "hires", "oregonator"});
  const auto smooth = peers::cases_of({"kepler_e06", "lotka_volterra", "arenstorf", "pleiades",
                                       "brusselator2", "henon_heiles_regular"});
  if (argc > 1 && std::string(argv[1]) == "bullet") {
    fmt::print("{}", peers::bullet_rows().csv());
    return 0;
  }
  if (argc > 1 && std::string(argv[1]) == "sundials_defaults") {
    fmt::print("{}", peers::sundials_default_rows().csv());
    return 0;
  }
  record::Records table{{"solver", "choice", "setting", "solved", "runs", "steps", "evaluations",
                         "errors_reached", "errors", "evaluations_to_errors", "time_to_errors",
                         "taken", "documentation"}};
  for (const auto& choices :
       {peers::sundials_choices(), peers::gsl_choices(), peers::odeint_choices()})
    for (const Choice& choice : choices)
      peers::add_rows(table, choice, choice.smooth ? smooth : stiff);
  fmt::print("{}", table.csv());
}
