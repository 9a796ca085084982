// SPDX-License-Identifier: BSD-3-Clause
// Writes reports/peers.md to standard output: the settings that the documentation of each library
// leaves open, measured over stiff cases with the library alone.
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
namespace {

constexpr double tolerances[] = {1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
constexpr double wanted_errors[] = {1e-2, 1e-4, 1e-6};
constexpr double unreached = std::numeric_limits<double>::infinity();

/// At the horizon, relative to the largest component there.
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

/// A solved run.
struct Solved {
  double error, time, evaluations;
};

/// The least cost of a run of at most that error; the cost on the line between two neighbouring
/// tolerances, in logarithms, where that is less.
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

/// `cited`: the documentation of the choice before, which is not printed again.
void write(const Choice& choice, const std::vector<const Case*>& cases, std::string& cited) {
  fmt::print("## {}: {}\n\n", choice.solver, choice.choice);
  if (choice.documentation != cited) fmt::print("{}\n\n", choice.documentation);
  cited = choice.documentation;
  fmt::print(
      "| setting | solved | steps | evaluations | errors reached | evaluations to them | time to "
      "them | |\n");
  fmt::print("|---|---|---|---|---|---|---|---|\n");
  Sums first;
  for (const Alternative& alternative : choice.alternatives) {
    const Sums sums = measure(alternative, cases);
    if (&alternative == &choice.alternatives.front()) first = sums;
    fmt::print("| {} | {} of {} | {} | {} | {} of {} | {:.2f} | {:.2f} | {} |\n",
               alternative.setting, sums.solved, sums.runs, sums.steps, sums.evaluations,
               sums.time_to.size(), cases.size() * std::size(wanted_errors),
               ratio(sums.evaluations_to, first.evaluations_to), ratio(sums.time_to, first.time_to),
               alternative.taken ? "taken" : "");
    std::fflush(stdout);
  }
  fmt::print("\n");
}

std::vector<const Case*> cases_of(std::initializer_list<const char*> ids) {
  std::vector<const Case*> cases;
  for (const char* id : ids) cases.push_back(&known_case(id));
  return cases;
}
std::string names_of(const std::vector<const Case*>& cases) {
  std::string names;
  for (const Case* c : cases) names += (names.empty() ? "" : " ") + c->id;
  return names;
}

constexpr const char* introduction =
    R"(# Settings of the peers

What the documentation of each library leaves to its user, the alternatives measured with the library
alone, and the one that the adapter takes; `odeum_peers` (tests/bench/peers) writes this file.

Implicit methods run on the cases {}; explicit ones on {}. Tolerances, relative and absolute, go from 1e-3
to 1e-9. A run is solved where the library reports success within 100,000 evaluations and the error at the
horizon is below a tenth of the largest component. Steps and evaluations are sums over the solved runs.
Errors reached are those of 1e-2, 1e-4 and 1e-6 in each case, at any tolerance. Evaluations and processor
time to these errors are the least, on the line between two tolerances in logarithms, as a geometric mean
relative to the first row over what both reach.

Times are processor times of SUNDIALS built by `scripts/sundials` and Debian's GSL with other programs
running: ratios of them below 1.1 say nothing. Runs on Robertson's reactions may drift away by
their last digits (reports/findings/sundials.md): three errors more or less are that. A citation holds for the
sections after it up to the next one.

Each library solves each case that it fits to a hundredth (test `Agreement.NoLibraryFailsACaseUnexplained`), but for
blow_up, whose solution ends at a pole. GSL and odeint have dense Jacobians alone, formed up to 128 unknowns here: they
solve brusselator_1d and medakzo by explicit methods, which `odeum precision` runs beyond the budget of the others
(302,628 and 61,995 evaluations by rk2 of GSL, 425,390 and 94,964 by odeint's Cash and Karp, to 1e-3).

)";

}  // namespace
}  // namespace odeum::peers

int main() {
  using namespace odeum;
  using peers::Choice;
  const auto stiff = peers::cases_of(
      {"robertson_40", "robertson", "vdp_mu1000", "vdp_eps1e_6", "hires", "oregonator"});
  const auto smooth = peers::cases_of({"kepler_e06", "lotka_volterra", "arenstorf", "pleiades",
                                       "brusselator2", "henon_heiles_regular"});
  fmt::print(fmt::runtime(peers::introduction), peers::names_of(stiff), peers::names_of(smooth));
  std::string cited;
  for (const auto& choices :
       {peers::sundials_choices(), peers::gsl_choices(), peers::odeint_choices()})
    for (const Choice& choice : choices)
      peers::write(choice, choice.smooth ? smooth : stiff, cited);
  peers::write_bullet();
}
