// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <stdexcept>

#include "micro.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/solvers/inlined.hpp"

namespace odeum::bench {
namespace {

/// A run with as many steps as it takes: fixed where `steps` says how many, else to a tolerance.
struct Run {
  const char *case_id, *method;
  std::uint64_t steps;  ///< 0: to the tolerance
};
constexpr double tolerance = 1e-6;

// Explicit methods on an orbit, linearly implicit and implicit ones on small stiff systems.
constexpr Run runs[] = {{"kepler_e06", "rk4", 10'000},
                        {"kepler_e06", "dormand_prince54", 10'000},
                        {"kepler_e06", "dormand_prince853", 10'000},
                        {"kepler_e06", "velocity_verlet", 10'000},
                        {"kepler_e06", "dormand_prince54", 0},
                        {"kepler_e06", "dormand_nystroem86", 0},
                        {"kepler_e06", "gragg_bulirsch_stoer", 0},
                        {"robertson_40", "rodas4", 0},
                        {"robertson_40", "radau_iia5", 0},
                        {"robertson_40", "bdf_variable", 0},
                        {"robertson_40", "seulex", 0},
                        {"hires", "rodas4", 0},
                        {"hires", "radau_iia5", 0},
                        {"hires", "bdf_variable", 0},
                        {"hires", "seulex", 0}};

const Entrant& find_solver(const std::vector<Entrant>& entrants, const std::string& id) {
  const auto found = std::find_if(entrants.begin(), entrants.end(),
                                  [&](const Entrant& e) { return e.info.id() == id; });
  if (found == entrants.end()) throw std::runtime_error("no solver " + id + " of this case");
  return *found;
}

struct Stage {
  Entrant entrant;
  Request request;
  double steps;  ///< attempted ones, rejected included
};

// One guarded run: checks that it ends ok, and counts its steps.
Stage stage_of(const Run& run) {
  const Case& c = known_case(run.case_id);
  const std::string id = std::string("odeum/") + run.method;
  Stage stage{find_solver(inlined_solvers(c), id), {}, 0};
  Request& request = stage.request;
  request.stops = {c.timed_stops().back()};
  request.mode = run.steps == 0 ? Mode::adaptive : Mode::fixed;
  request.steps = run.steps;
  request.tolerance = tolerance;
  const Entrant* const guarded = c.entrants.find(id);
  if (!guarded) throw std::runtime_error("no solver " + id + " of this case");
  const Outcome outcome = guarded->solve(request);
  if (outcome.status != Status::ok)
    throw std::runtime_error(id + " on " + run.case_id + ": " + outcome.detail);
  stage.steps = static_cast<double>(outcome.counters.steps + outcome.counters.rejected_steps);
  request.budget.watched = false;
  return stage;
}

void time_solves(benchmark::State& state, const Stage& stage) {
  for (auto _ : state) {
    Outcome outcome = stage.entrant.solve(stage.request);
    benchmark::DoNotOptimize(outcome.states.data());
  }
  state.counters["a_step"] =
      benchmark::Counter(stage.steps * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["steps"] = stage.steps;
}

}  // namespace

void register_steps() {
  for (const Run& run : runs) {
    const std::string name = fmt::format("step/{}/{}/{}", run.case_id, run.method,
                                         run.steps == 0 ? "tolerance" : "fixed");
    // Set up inside, so that benchmarks excluded by a filter cost nothing.
    benchmark::RegisterBenchmark(name.c_str(), [run](benchmark::State& state) {
      time_solves(state, stage_of(run));
    })->Unit(benchmark::kMicrosecond);
  }
}

}  // namespace odeum::bench
