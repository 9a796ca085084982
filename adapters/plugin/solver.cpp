// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/solver.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <utility>

#include "odeum/isolated/isolated_process.hpp"
#include "odeum/isolated/kept_arithmetic.hpp"
#include "odeum/isolated/loaded_processes.hpp"
#include "odeum/solvers/dense_jacobian.hpp"
#include "odeum/solvers/foreign_problem.hpp"

namespace odeum::adapters::plugin {
namespace {

/// The problem as the plug-in's callbacks reach it.
struct System {
  System(const OdeView& view, const Request& request)
      : guarded(view, request.budget, &request.tolerance), jacobian(guarded) {}
  GuardedView guarded;
  DenseJacobian jacobian;

  /// Whether a call at time t is a sign of work: the millionth at one time is none.
  bool goes_on(double t) {
    constexpr std::uint64_t most = 1'000'000;
    calls_ = t == time_ ? calls_ + 1 : 0;
    time_ = t;
    return calls_ < most;
  }

 private:
  double time_ = 0;
  std::uint64_t calls_ = 0;  ///< at that time
};

/// The callbacks' result: 0, or 1 once the budget is spent, after which calls are not a sign of
/// work.
int working(System& system, double t, int answer) {
  if (answer == 0 && system.goes_on(t)) isolated::alive(system.guarded.guard());
  return answer;
}

/// What the plug-in is given; `absolute` outlives it, empty at fixed steps.
odeum_system callbacks(System& system, const std::vector<double>& absolute) {
  const OdeView& view = system.guarded.view();
  odeum_system out{};
  out.dimension = view.dimension;
  out.data = &system;
  out.absolute_tolerances = absolute.empty() ? nullptr : absolute.data();
  out.rhs = [](void* data, double t, const double* y, double* dydt) {
    auto& system = *static_cast<System*>(data);
    return working(system, t, system.guarded.rhs(t, y, dydt));
  };
  out.jacobian = [](void* data, double t, const double* y, double* j) {
    auto& system = *static_cast<System*>(data);
    return working(system, t, system.jacobian(t, y, j));
  };
  out.time_derivative = [](void* data, double t, const double* y, double* dfdt) {
    static_cast<System*>(data)->guarded.time_derivative(t, y, dfdt);
    return 0;
  };
  if (!view.second_order()) return out;
  out.degrees_of_freedom = view.degrees_of_freedom;
  out.velocity_dependent = view.velocity_dependent;
  out.acceleration = [](void* data, double t, const double* q, const double* v, double* a) {
    auto& system = *static_cast<System*>(data);
    return working(system, t, system.guarded.acceleration(t, q, v, a));
  };
  return out;
}

std::vector<double> absolute_of(const Request& request, std::size_t n) {
  std::vector<double> absolute(request.mode == Mode::adaptive ? n : 0);
  for (std::size_t i = 0; i < absolute.size(); ++i) absolute[i] = request.tolerance.absolute(i);
  return absolute;
}

/// A state with numbers on either side that a solver must not change.
class Fenced {
 public:
  explicit Fenced(const std::vector<double>& y) : n_(y.size()), all_(n_ + 2 * width, fence) {
    std::ranges::copy(y, data());
  }
  double* data() { return all_.data() + width; }
  bool intact() const {
    const auto whole = [&](std::size_t from) {
      return std::all_of(all_.begin() + static_cast<std::ptrdiff_t>(from),
                         all_.begin() + static_cast<std::ptrdiff_t>(from + width),
                         [](double x) { return x == fence; });
    };
    return whole(0) && whole(n_ + width);
  }

 private:
  static constexpr std::size_t width = 16;
  static constexpr double fence = 3.25e77;
  std::size_t n_;
  std::vector<double> all_;
};

/// One solve, in the process of its own.
class Solve {
 public:
  Solve(const odeum_solver& solver, const ErasedContest& contest, const Request& request)
      : solver_(solver),
        contest_(contest),
        request_(request),
        system_(contest.view, request),
        absolute_(absolute_of(request, contest.view.dimension)),
        callbacks_(callbacks(system_, absolute_)),
        y_(*contest.y0) {}

  Outcome operator()() {
    void* const self = solver_.create(&callbacks_, contest_.t0, contest_.y0->data());
    if (!self) {
      fail(Status::refused, contest_.t0, "create returned a null pointer");
    } else {
      if (request_.mode == Mode::fixed)
        walk_fixed(self);
      else
        walk_adaptive(self);
      if (solver_.steps && request_.mode == Mode::adaptive)
        outcome_.counters.steps = solver_.steps(self);
      if (solver_.destroy) solver_.destroy(self);
    }
    system_.guarded.guard().conclude(request_, outcome_);
    return std::move(outcome_);
  }

 private:
  bool fail(Status status, double t, std::string why) {
    outcome_.status = status;
    outcome_.t = t;
    outcome_.detail = fmt::format("{}: {} at t = {}", solver_.name, std::move(why), t);
    return false;
  }
  /// Whether the solve goes on after a call of the plug-in.
  bool sound(int answer, double t) {
    if (system_.guarded.guard().tripped()) return false;
    if (answer == 0) return true;
    // Nothing is known of the reason, and no other status would be true of every method.
    return fail(Status::refused, t,
                fmt::format("{} returned {}, which says that it failed",
                            request_.mode == Mode::fixed ? "step" : "solve", answer));
  }
  bool fence_holds(double t) {
    return y_.intact() || fail(Status::refused, t, "wrote outside of its state");
  }

  void walk_fixed(void* self) {
    const FixedGrid grid(contest_.t0, request_);
    if (!grid.fits()) {
      fail(Status::refused, contest_.t0, "a stop is not on the grid of steps");
      return;
    }
    const std::size_t n = contest_.view.dimension;
    std::uint64_t& i = outcome_.counters.steps;
    for (std::size_t stop = 0; stop < grid.stop_count(); ++stop) {
      for (const std::uint64_t end = grid.index_of(stop); i < end; ++i) {
        const int answer = solver_.step(self, grid.t(i), grid.h(), y_.data());
        if (!sound(answer, grid.t(i))) return;
        if (!grid.checks(i) && i + 1 != end) continue;
        if (!fence_holds(grid.t(i))) return;
        if (!is_finite(y_.data(), n)) {
          fail(Status::non_finite, grid.t(i), "the state is not finite after the step");
          return;
        }
      }
      outcome_.record(request_.stops[stop], y_.data(), n);
    }
  }

  void walk_adaptive(void* self) {
    double t = contest_.t0;
    for (const double stop : request_.stops) {
      const double before = t;
      if (!sound(solver_.solve(self, &t, stop, request_.tolerance.relative, y_.data()), t)) return;
      if (!fence_holds(before)) return;
      if (t < before) {
        fail(Status::refused, t, fmt::format("moved t backwards from {}", before));
        return;
      }
      if (t != stop) {
        fail(Status::refused, t,
             fmt::format("success was reported short of or beyond the stop {}", stop));
        return;
      }
      outcome_.record(stop, y_.data(), contest_.view.dimension);
    }
  }

  const odeum_solver& solver_;
  const ErasedContest& contest_;
  const Request& request_;
  System system_;
  std::vector<double> absolute_;
  odeum_system callbacks_;
  Fenced y_;
  Outcome outcome_;
};

std::string unfit(const odeum_solver& solver, const OdeView& view) {
  if ((solver.needs & ODEUM_NEEDS_SEPARABLE) && (!view.second_order() || view.velocity_dependent))
    return "needs a second-order problem q'' = a(t, q) whose acceleration does not depend on the "
           "velocity";
  if ((solver.needs & ODEUM_NEEDS_SECOND_ORDER) && !view.second_order())
    return "needs a second-order problem q'' = a(t, q, v)";
  if ((solver.needs & ODEUM_NEEDS_JACOBIAN) && view.dimension > dense_dimension_limit)
    return fmt::format("needs a dense Jacobian, which is formed up to {} unknowns",
                       dense_dimension_limit);
  return {};
}

}  // namespace

std::string fault_of(const odeum_solver& solver) {
  if (std::string fault = foreign::fault_of_name("solver", solver.name); !fault.empty())
    return fault;
  const std::string who = fmt::format("solver {}: ", solver.name);
  if (!solver.create) return who + "create is a null pointer";
  if (!solver.step && !solver.solve) return who + "step and solve are both null pointers";
  if (solver.order <= 0 || solver.order > 100)
    return who + fmt::format("order: got {}, expected a positive number, or NaN where it varies",
                             solver.order);
  constexpr std::uint32_t known =
      ODEUM_NEEDS_JACOBIAN | ODEUM_NEEDS_SECOND_ORDER | ODEUM_NEEDS_SEPARABLE;
  if (solver.needs & ~known)
    return who + fmt::format("needs: {} has bits that mean nothing", solver.needs);
  return {};
}

Solver solver_of(const std::shared_ptr<const Plugin>& plugin, std::size_t number) {
  const odeum_solver& solver = plugin->image().solvers[number];
  SolverInfo info;
  info.library = plugin->image().name;
  info.method = solver.name;
  info.family = solver.family ? foreign::cleaned(solver.family) : "plugin";
  info.order = solver.order;
  info.fixed = solver.step != nullptr;
  info.adaptive = solver.solve != nullptr;
  if (info.adaptive) info.controller = "the plug-in's own";
  info.source = solver.source ? foreign::cleaned(solver.source) : "a plug-in";
  if (solver.needs & ODEUM_NEEDS_SEPARABLE)
    info.needs = "a second-order problem q'' = a(t, q)";
  else if (solver.needs & ODEUM_NEEDS_SECOND_ORDER)
    info.needs = "a second-order problem q'' = a(t, q, v)";
  else if (solver.needs & ODEUM_NEEDS_JACOBIAN)
    info.needs = "a dense Jacobian (differenced where there is none)";
  return {std::move(info), [plugin, number](const ErasedContest& contest, Entrant& entrant) {
            entrant.unfit = unfit(plugin->image().solvers[number], contest.view);
            if (!entrant.unfit.empty()) return;
            const isolated::LoadedWork work{
                contest.y0, contest.view.dimension, [plugin] { plugin->loaded(); },
                [plugin, contest](std::size_t solver, const Request& inner) {
                  const isolated::KeptArithmetic kept;
                  return Solve(plugin->loaded().solvers[solver], contest, inner)();
                }};
            entrant.solve = [plugin, number, work,
                             ended = std::make_shared<isolated::Ended>()](const Request& request) {
              return plugin->processes().solve(work, number, request, *ended);
            };
          }};
}

}  // namespace odeum::adapters::plugin
