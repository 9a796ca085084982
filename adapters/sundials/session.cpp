// SPDX-License-Identifier: BSD-3-Clause
#include "sundials/session.hpp"

#include <cvode/cvode.h>
#include <fmt/format.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <algorithm>
#include <utility>

namespace odeum::adapters::sundials {
namespace {

// One context per thread: the library does not allow sharing between threads, and creating one per
// solve would slow short solves.
SUNContext context_of_this_thread() {
  struct Context {
    SUNContext handle = nullptr;
    Context() { check(SUNContext_Create(nullptr, &handle), "creating the context"); }
    ~Context() { SUNContext_Free(&handle); }
  };
  thread_local Context context;
  return context.handle;
}

}  // namespace

Session::Session(const Module& module, const ErasedContest& contest, const Request& request)
    : module_(module),
      request_(request),
      t0_(contest.t0),
      t_(contest.t0),
      problem_(contest.view, request.budget, &request.tolerance),
      state_(*contest.y0),
      context_(context_of_this_thread()),
      y_(N_VMake_Serial(static_cast<sunindextype>(state_.size()), state_.data(), context_)) {
  if (!y_) throw Failure{CV_MEM_FAIL, "making the state vector"};
}

Session::~Session() {
  if (integrator_) module_.free(&integrator_);
}

void Session::adopt(void* integrator) {
  if (!integrator) throw Failure{CV_MEM_FAIL, "creating the integrator"};
  integrator_ = integrator;
  check(module_.set_error_handler(integrator_, on_message, this), "setting the error handler");
  check(module_.set_user_data(integrator_, this), "setting the user data");
}

void Session::keep(LinearSolver solver, Matrix matrix) {
  linear_solver_ = std::move(solver);
  matrix_ = std::move(matrix);
}

void Session::keep(NonlinearSolver solver) { nonlinear_solver_ = std::move(solver); }

int Session::rhs(double t, N_Vector y, N_Vector dydt, void* data) {
  auto& session = *static_cast<Session*>(data);
  if (session.stuck()) return -1;
  return -session.problem_.rhs(t, NV_DATA_S(y), NV_DATA_S(dydt));
}

int Session::explicit_part(double t, N_Vector y, N_Vector f, void* data) {
  auto& session = *static_cast<Session*>(data);
  if (session.stuck()) return -1;
  return -session.problem_.explicit_part(t, NV_DATA_S(y), NV_DATA_S(f));
}

void Session::on_message(int code, const char*, const char*, char* message, void* data) {
  auto& session = *static_cast<Session*>(data);
  if (code < 0) session.message_ = message;
  if (code == CV_WARNING) ++session.warnings_;
}

void Session::run(Outcome& outcome) {
  // The guard's budget bounds the steps; the library's own limit (500) is disabled.
  check(module_.set_max_steps(integrator_, -1), "lifting the limit of steps");
  if (fixed_step())
    run_fixed(outcome);
  else
    run_adaptive(outcome);
}

void Session::run_fixed(Outcome& outcome) {
  const FixedGrid grid(t0_, request_);
  if (module_.set_fixed_step)
    check(module_.set_fixed_step(integrator_, grid.h()), "setting the fixed step");
  // Half a step beyond the end, so that the last step is like the others: a step that ends at the
  // stop time is shortened by rounding, and its state comes from an interpolant, which at order 1
  // differs from the step's result (reports/findings/sundials.md).
  const double stop_time = t_end() + grid.h() / 2;
  check(module_.set_stop_time(integrator_, stop_time), "setting the stop time");
  std::uint64_t i = 0;
  for (std::size_t stop = 0; stop < grid.stop_count(); ++stop) {
    for (const std::uint64_t end = grid.index_of(stop); i < end; ++i) {
      check(module_.evolve(integrator_, stop_time, y_.get(), &t_, CV_ONE_STEP), "stepping");
      // The library accumulates its time with rounding errors; a larger deviation is a wrong step.
      if (std::abs(t_ - grid.t(i + 1)) > 1e-3 * grid.h())
        throw Failure{CV_ILL_INPUT, "stepping, which did not end on the grid"};
      if (!is_finite(state_.data(), state_.size()))
        return outcome.record(grid.t(i), state_.data(), state_.size());
    }
    outcome.record(request_.stops[stop], state_.data(), state_.size());
  }
}

void Session::set_tolerances() {
  const Tolerance& tolerance = request_.tolerance;
  if (!tolerance.by_component()) {
    check(module_.set_tolerances(integrator_, tolerance.relative, tolerance.absolute(0)),
          "setting the tolerances");
    return;
  }
  const Vector by_component(N_VClone(y_.get()));  // the library copies it
  if (!by_component) throw Failure{CV_MEM_FAIL, "making the vector of absolute tolerances"};
  std::copy(tolerance.absolutes().begin(), tolerance.absolutes().end(),
            NV_DATA_S(by_component.get()));
  check(module_.set_tolerances_by_component(integrator_, tolerance.relative, by_component.get()),
        "setting the tolerances");
}

// The same steps, one a call. The first step follows from `end`, which outputs must not move.
void Session::step_to(double stop, double end, Outcome& outcome) {
  std::vector<double>& ends = outcome.step_ends;
  while (t_ < stop) {
    check(module_.evolve(integrator_, end, y_.get(), &t_, CV_ONE_STEP), "integrating");
    // After an interpolated state the step around it is returned again.
    if (request_.record_steps && (ends.empty() || t_ > ends.back())) ends.push_back(t_);
  }
}

void Session::run_adaptive(Outcome& outcome) {
  set_tolerances();
  const bool interpolates = (module_.interpolates_stops || interpolates_) && !ends_on_stops_;
  for (const double stop : request_.stops) {
    const double end = interpolates ? t_end() : stop;
    check(module_.set_stop_time(integrator_, end), "setting the stop time");
    if (request_.record_steps || request_.over_stops) step_to(stop, end, outcome);
    if (t_ != stop)
      check(module_.evolve(integrator_, stop, y_.get(), &t_, CV_NORMAL), "integrating");
    outcome.record(t_, state_.data(), state_.size());
  }
}

void Session::explain(const Failure& failure, Outcome& outcome) {
  if (integrator_) module_.current_time(integrator_, &t_);  // some failures do not return it
  outcome.status = status_of(failure.flag);
  outcome.t = t_;
  outcome.detail =
      fmt::format("{} when {} (t = {})", name_of(module_, failure.flag), failure.what, t_);
  if (!message_.empty()) outcome.detail += ": " + message_;
  if (!stuck()) return;
  outcome.status = Status::step_too_small;
  outcome.detail = fmt::format("step at the rounding of t = {}", t_);
}

Outcome solve(const Method& method, const ErasedContest& contest, const Request& request) {
  if (request.mode == Mode::fixed ? !method.info.fixed : !method.info.adaptive)
    return refused(request.mode == Mode::fixed ? "chooses its own steps: runs to a tolerance only"
                                               : "runs at a fixed step only");
  Outcome outcome;
  try {
    Session session(*method.module, contest, request);
    try {
      method.build(session);
      session.run(outcome);
    } catch (const Failure& failure) {
      session.explain(failure, outcome);
    }
    if (session.integrator()) {
      long steps = 0, error_failures = 0, solve_failures = 0;
      method.module->steps(session.integrator(), &steps);
      method.module->error_test_failures(session.integrator(), &error_failures);
      if (method.module->solve_failures)
        method.module->solve_failures(session.integrator(), &solve_failures);
      outcome.counters.steps = static_cast<std::uint64_t>(steps);
      outcome.counters.rejected_steps = static_cast<std::uint64_t>(error_failures + solve_failures);
    }
    session.problem().guard().conclude(request, outcome);
    // The library differences by itself where the problem has no Jacobian: its evaluations of the
    // right-hand side passed the guard, its Jacobians did not.
    long jacobians = 0;
    if (method.module->jacobians && session.integrator() &&
        method.module->jacobians(session.integrator(), &jacobians) == 0)
      outcome.counters.jacobian_evaluations =
          std::max(outcome.counters.jacobian_evaluations, static_cast<std::uint64_t>(jacobians));
  } catch (const Failure& failure) {  // the session could not be created
    outcome.status = status_of(failure.flag);
    outcome.detail = fmt::format("{} when {}", name_of(*method.module, failure.flag), failure.what);
  }
  return outcome;
}

}  // namespace odeum::adapters::sundials
