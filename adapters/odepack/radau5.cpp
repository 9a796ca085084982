// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "odepack/run.hpp"
#include "odeum/solvers/first_step.hpp"

namespace odeum::adapters::odepack {
namespace {

/// The run that the callback of a step belongs to.
struct Radau5Run {
  Problem& problem;
  const Request& request;
  Outcome& outcome;
  std::size_t stop = 0;  ///< the next to be recorded, where stops do not limit the steps
};

Radau5Run& run_of(void* pointer) { return *static_cast<Radau5Run*>(pointer); }

void rhs_of_radau5(const int*, const double* t, const double* y, double* dydt, double* run,
                   const int*) {
  run_of(run).problem.rhs(*t, y, dydt);
}

void jacobian_of_radau5(const int*, const double* t, const double* y, const int*, const int*,
                        double* j, const int* rows, double* run, const int*) {
  run_of(run).problem.fill(*t, y, j, *rows);
}

void no_mass(const int*, double*, const int*, double*, const int*) {}

/// Called with the start, too, as the step 1.
void after_step(const int* number, const double*, const double* t, const double*,
                double* continuous, int* length, int* n, double* pointer, const int*,
                int* interrupt) {
  Radau5Run& run = run_of(pointer);
  *interrupt = 0;
  if (*number == 1) return;
  if (run.request.record_steps) run.outcome.step_ends.push_back(*t);
  if (!run.request.over_stops) return;
  std::vector<double> inside(static_cast<std::size_t>(*n));
  for (; run.stop + 1 < run.request.stops.size() && run.request.stops[run.stop] < *t; ++run.stop) {
    double stop = run.request.stops[run.stop];
    library().continuous(n, &stop, continuous, length, inside.data());
    run.outcome.record(stop, inside.data(), inside.size());
  }
}

Status status_of_idid(int flag) {
  return flag == -2   ? Status::over_budget
         : flag == -3 ? Status::step_too_small
         : flag == -4 ? Status::newton_failed
                      : Status::refused;
}

const char* meaning_of_idid(int flag) {
  return flag == -2   ? "more steps than were allowed"
         : flag == -3 ? "the step size becomes too small"
         : flag == -4 ? "the matrix is repeatedly singular"
                      : "the input is not consistent";
}

/// From t to t_end with a first step h, which becomes the next one; returns the flag.
int to(double t_end, double& t, double& h, std::vector<double>& y, Radau5Run& run,
       std::vector<double>& work, std::vector<int>& integers) {
  Problem& problem = run.problem;
  const Tolerance& tolerance = run.request.tolerance;
  // Both arrays, or both numbers; it changes them.
  std::vector<double> absolute = problem.absolute(tolerance),
                      relative(absolute.size(), tolerance.relative);
  int n = problem.size(), kind = absolute.size() > 1 ? 1 : 0, given = problem.has_jacobian();
  int lower = problem.banded() ? problem.lower() : n, upper = problem.upper(), flag = 0, none = 0;
  int calls = run.request.over_stops || run.request.record_steps;
  int work_length = static_cast<int>(work.size()), length = static_cast<int>(integers.size());
  std::fill_n(work.begin(), 20, 0.0);
  std::fill_n(integers.begin(), 20, 0);
  // The guard's budget ends a run before.
  integers[1] = static_cast<int>(
      std::min<std::uint64_t>(run.request.budget.evaluations, std::numeric_limits<int>::max()));
  library().radau5(&n, rhs_of_radau5, &t, y.data(), &t_end, &h, relative.data(), absolute.data(),
                   &kind, jacobian_of_radau5, &given, &lower, &upper, no_mass, &none, &none, &none,
                   after_step, &calls, work.data(), &work_length, integers.data(), &length,
                   reinterpret_cast<double*>(&run), &none, &flag);
  run.outcome.counters.steps += static_cast<std::uint64_t>(integers[16]);
  run.outcome.counters.rejected_steps += static_cast<std::uint64_t>(integers[17]);
  return flag;
}

void to_the_end(const ErasedContest& contest, Radau5Run& run) {
  const Request& request = run.request;
  Problem& problem = run.problem;
  const auto n = static_cast<std::size_t>(problem.size());
  const std::size_t band = static_cast<std::size_t>(problem.lower() + problem.upper() + 1),
                    factors = band + static_cast<std::size_t>(problem.lower());
  std::vector<double> work(20 + n * (12 + (problem.banded() ? band + 3 * factors : 4 * n)));
  std::vector<int> integers(20 + 3 * n);
  std::vector<double> y = *contest.y0;
  double t = contest.t0;
  constexpr int order = 5;
  double h = first_step(problem.guarded(), t, y, request.stops.back(), order, request.tolerance);
  // Its polynomial is of degree 3: where errors are measured, steps end on the stops.
  for (std::size_t k = request.over_stops ? request.stops.size() - 1 : 0; k < request.stops.size();
       ++k) {
    const int flag = to(request.stops[k], t, h, y, run, work, integers);
    if (flag != 1) {
      run.outcome.status = status_of_idid(flag);
      run.outcome.t = t;
      run.outcome.detail =
          fmt::format("RADAU5 returned idid = {} ({}) at t = {}", flag, meaning_of_idid(flag), t);
      return;
    }
    run.outcome.record(request.stops[k], y.data(), n);
  }
}

}  // namespace

Outcome solve_by_radau5(const ErasedContest& contest, const Request& request) {
  if (request.mode == Mode::fixed) return refused("RADAU5 has no fixed-step mode");
  if (contest.view.dimension == 0) return refused("the library has no vectors of length 0");
  Library& all = library();
  if (!all.failure.empty()) return refused(all.failure);
  const std::lock_guard alone(all.in_use);  // before the clock of the budget starts
  Problem problem(contest, request);
  if (problem.too_large()) return dense_over_budget(contest.view.dimension);
  Outcome outcome;
  Radau5Run run{problem, request, outcome};
  try {
    to_the_end(contest, run);
  } catch (const Left& left) {
    outcome.status = left.status;
  }
  problem.guarded().guard().conclude(request, outcome);
  return outcome;
}

}  // namespace odeum::adapters::odepack
