// SPDX-License-Identifier: BSD-3-Clause
#include "sundials/ida.hpp"

#include <fmt/format.h>
#include <ida/ida.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunmatrix/sunmatrix_dense.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <string>
#include <utility>

#include "odeum/core/guard.hpp"
#include "odeum/problem/implicit_form.hpp"
#include "sundials/handles.hpp"
#include "sundials/module.hpp"

namespace odeum::adapters::sundials {
namespace {

/// One solve: the residuals under guard, the state, its rates, and the integrator.
class Run {
 public:
  Run(const ErasedContest& contest, const Request& request)
      : form_(*contest.implicit),
        request_(request),
        guard_(form_.dimension, request.budget),
        t_(contest.t0),
        y_(*contest.y0),
        rates_(y_.size()),
        matrix_values_(y_.size() * y_.size()) {
    check(SUNContext_Create(nullptr, &context_), "creating the context");
    // The start is consistent to rounding, rates included: IDACalcIC would find it again.
    contest.view.rhs(contest.view.problem, t_, y_.data(), rates_.data());
    const auto n = static_cast<sunindextype>(y_.size());
    y_vector_.reset(N_VMake_Serial(n, y_.data(), context_));
    rates_vector_.reset(N_VMake_Serial(n, rates_.data(), context_));
    matrix_.reset(SUNDenseMatrix(n, n, context_));
    solver_.reset(SUNLinSol_Dense(y_vector_.get(), matrix_.get(), context_));
    memory_ = IDACreate(context_);
    if (!memory_ || !solver_) throw Failure{IDA_MEM_FAIL, "creating the integrator"};
    check(IDASetErrHandlerFn(memory_, on_message, this), "setting the error handler");
    check(IDASetUserData(memory_, this), "setting the user data");
    check(IDAInit(memory_, residual, t_, y_vector_.get(), rates_vector_.get()), "IDAInit");
    set_tolerances();
    if (form_.index > 1) leave_out_of_the_error_test();
    check(IDASetLinearSolver(memory_, solver_.get(), matrix_.get()), "setting the linear solver");
    check(IDASetJacFn(memory_, jacobian), "setting the Jacobian");
    // The guard's budget bounds the steps.
    check(IDASetMaxNumSteps(memory_, -1), "lifting the limit of steps");
    check(IDASetStopTime(memory_, request.stops.back()), "setting the stop time");
  }
  ~Run() {
    if (memory_) IDAFree(&memory_);
    solver_.reset(), matrix_.reset(), y_vector_.reset(), rates_vector_.reset();
    if (context_) SUNContext_Free(&context_);
  }
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  Outcome solve() {
    Outcome outcome;
    try {
      // A stop before the last comes from the polynomial of its step, as with CVODE.
      for (const double stop : request_.stops) {
        while (request_.record_steps && t_ < stop) {
          advance(stop, IDA_ONE_STEP);
          outcome.step_ends.push_back(t_);
        }
        if (t_ != stop) advance(stop, IDA_NORMAL);
        outcome.record(t_, y_.data(), y_.size());
      }
    } catch (const Failure& failure) {
      explain(failure, outcome);
    }
    count(outcome.counters);
    guard_.conclude(request_, outcome);
    return outcome;
  }

 private:
  void advance(double stop, int task) {
    check(IDASolve(memory_, stop, &t_, y_vector_.get(), rates_vector_.get(), task), "integrating");
  }

  void set_tolerances() {
    const Tolerance& tolerance = request_.tolerance;
    if (!tolerance.by_component())
      return check(IDASStolerances(memory_, tolerance.relative, tolerance.absolute(0)),
                   "setting the tolerances");
    const Vector by_component(N_VClone(y_vector_.get()));  // the library copies it
    if (!by_component) throw Failure{IDA_MEM_FAIL, "making the vector of absolute tolerances"};
    std::copy(tolerance.absolutes().begin(), tolerance.absolutes().end(),
              NV_DATA_S(by_component.get()));
    check(IDASVtolerances(memory_, tolerance.relative, by_component.get()),
          "setting the tolerances");
  }

  /// States of an index above 1, as the guide advises for problems of index 2.
  void leave_out_of_the_error_test() {
    const Vector is_tested(N_VClone(y_vector_.get()));  // the library copies it
    if (!is_tested) throw Failure{IDA_MEM_FAIL, "making the vector of algebraic states"};
    for (std::size_t i = 0; i < y_.size(); ++i)
      NV_DATA_S(is_tested.get())[i] = form_.indices.at(i) > 1 ? 0 : 1;
    check(IDASetId(memory_, is_tested.get()), "naming the algebraic states");
    check(IDASetSuppressAlg(memory_, SUNTRUE), "leaving them out of the error test");
  }

  static int residual(double t, N_Vector y, N_Vector rates, N_Vector r, void* data) {
    Run& run = *static_cast<Run*>(data);
    const int spent = run.guard_.evaluate(
        t, NV_DATA_S(r), [&] { return run.form_.dimension; }, false,
        [&] { run.form_.residual(t, NV_DATA_S(y), NV_DATA_S(rates), NV_DATA_S(r)); });
    if (spent) return -1;
    // A shorter step may stay where the residuals are finite.
    return is_finite(NV_DATA_S(r), run.form_.dimension) ? 0 : 1;
  }

  static int jacobian(double t, double alpha, N_Vector y, N_Vector rates, N_Vector,
                      SUNMatrix matrix, void* data, N_Vector, N_Vector, N_Vector) {
    Run& run = *static_cast<Run*>(data);
    if (run.guard_.tripped()) return -1;
    run.guard_.count_jacobian();
    run.form_.matrix(t, NV_DATA_S(y), NV_DATA_S(rates), alpha, run.matrix_values_.data());
    const std::size_t n = run.form_.dimension;
    double* const columns = SM_DATA_D(matrix);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j) columns[j * n + i] = run.matrix_values_[i * n + j];
    return 0;
  }

  static void on_message(int code, const char*, const char*, char* message, void* data) {
    if (code < 0) static_cast<Run*>(data)->message_ = message;
  }

  void explain(const Failure& failure, Outcome& outcome) {
    IDAGetCurrentTime(memory_, &t_);
    outcome.t = t_;
    const std::unique_ptr<char, void (*)(void*)> name(IDAGetReturnFlagName(failure.flag),
                                                      std::free);
    outcome.detail = fmt::format("{} when {} (t = {})", name.get(), failure.what, t_);
    if (!message_.empty()) outcome.detail += ": " + message_;
    switch (failure.flag) {
      case IDA_TOO_MUCH_WORK:
        outcome.status = Status::over_budget;
        break;
      case IDA_ERR_FAIL:
        outcome.status = Status::step_too_small;
        break;
      case IDA_CONV_FAIL:
      case IDA_LSETUP_FAIL:
      case IDA_LSOLVE_FAIL:
        outcome.status = Status::newton_failed;
        break;
      case IDA_RES_FAIL:
      case IDA_REP_RES_ERR:
      case IDA_FIRST_RES_FAIL:
        outcome.status = Status::non_finite;
        break;
      default:
        outcome.status = Status::refused;
    }
  }

  void count(Counters& counters) const {
    long steps = 0, error_failures = 0, solve_failures = 0;
    IDAGetNumSteps(memory_, &steps);
    IDAGetNumErrTestFails(memory_, &error_failures);
    IDAGetNumNonlinSolvConvFails(memory_, &solve_failures);
    counters.steps = static_cast<std::uint64_t>(steps);
    counters.rejected_steps = static_cast<std::uint64_t>(error_failures + solve_failures);
  }

  const ImplicitForm& form_;
  const Request& request_;
  Guard guard_;
  double t_;
  std::vector<double> y_, rates_, matrix_values_;
  SUNContext context_ = nullptr;
  Vector y_vector_, rates_vector_;
  Matrix matrix_;
  LinearSolver solver_;
  void* memory_ = nullptr;
  std::string message_;  ///< the library's last error message, kept from stderr
};

Outcome solve(const ErasedContest& contest, const Request& request) {
  if (request.mode == Mode::fixed)
    return refused("chooses its own steps: runs to a tolerance only");
  try {
    return Run(contest, request).solve();
  } catch (const Failure& failure) {
    return refused(fmt::format("flag {} when {}", failure.flag, failure.what));
  }
}

}  // namespace

void add_ida(std::vector<Solver>& all) {
  SolverInfo info;
  info.library = "ida";
  info.method = "bdf";
  info.family = "multistep";
  info.fixed = false;
  info.adaptive = true;
  info.common_use = CommonUse::tolerance;
  info.controller = "variable order and step, local error test";
  info.source =
      "IDA user guide, mathematical considerations: backward differentiation of orders 1 to 5, "
      "fixed leading coefficient, on R(t, y, y') = 0; Newton iteration";
  all.push_back(on_residuals(info, solve));
}

}  // namespace odeum::adapters::sundials
