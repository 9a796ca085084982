// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "odeum/core/guarded.hpp"
#include "odeum/linear/shifted_solver.hpp"
#include "odeum/solvers/solver.hpp"
#include "sundials/handles.hpp"
#include "sundials/module.hpp"

namespace odeum::adapters::sundials {

struct StructuredJacobian;

/// One solve: the guarded problem, its state as a vector of the library, and the integrator with
/// all that it points to.
class Session {
 public:
  Session(const Module& module, const ErasedContest& contest, const Request& request);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// Takes over a new integrator; throws Failure where it is null.
  void adopt(void* integrator);
  /// Keeps a linear solver, and a matrix where it has one, alive as long as the integrator.
  void keep(LinearSolver solver, Matrix matrix);
  void keep(NonlinearSolver solver);
  /// The problem's own solver of linear systems, where used instead of the library's.
  void keep(std::unique_ptr<ShiftedSolver> solver) { shifted_solver_ = std::move(solver); }
  ShiftedSolver* shifted_solver() const { return shifted_solver_.get(); }
  /// What fills the matrix of a sparse Jacobian, see structured.cpp.
  void keep(std::shared_ptr<StructuredJacobian> jacobian) { structured_ = std::move(jacobian); }
  StructuredJacobian* structured() const { return structured_.get(); }

  const Module& module() const { return module_; }
  const Request& request() const { return request_; }
  bool fixed_step() const { return request_.mode == Mode::fixed; }
  /// Has stops before the last interpolated where the request asks for that; returns whether.
  bool interpolate_outputs() { return interpolates_ = !fixed_step() && request_.over_stops; }
  /// No stop is interpolated, whatever the module does.
  void end_steps_on_stops() { ends_on_stops_ = true; }
  double t0() const { return t0_; }
  double t_end() const { return request_.stops.back(); }
  N_Vector y() const { return y_.get(); }
  SUNContext context() const { return context_; }
  void* integrator() const { return integrator_; }
  GuardedView& problem() { return problem_; }
  const OdeView& view() const { return problem_.view(); }
  std::size_t dimension() const { return state_.size(); }

  /// From t0 to the last stop, as the request says; throws Failure.
  void run(Outcome& outcome);
  /// A failure as status and detail of an outcome.
  void explain(const Failure& failure, Outcome& outcome);

  /// The right-hand side as the library calls it; `data` is the session. Fails unrecoverably once
  /// the guard has tripped, since no smaller step can help.
  static int rhs(double t, N_Vector y, N_Vector dydt, void* data);
  static int explicit_part(double t, N_Vector y, N_Vector f, void* data);

 private:
  /// Whether the library has warned, as often as it does at most (mxhnil), that t + h rounds to t.
  /// It would go on; a least step, the library's own cure, is one number for the whole run, and
  /// with a horizon of 1e11 that number forbids the steps which the start of a stiff problem needs.
  bool stuck() const { return warnings_ >= 10; }
  static void on_message(int code, const char* module, const char* function, char* message,
                         void* data);
  void run_fixed(Outcome& outcome);
  void run_adaptive(Outcome& outcome);
  void step_to(double stop, double end, Outcome& outcome);
  void set_tolerances();

  const Module& module_;
  const Request& request_;
  double t0_;
  double t_;
  GuardedView problem_;
  std::vector<double> state_;
  SUNContext context_;
  Vector y_;
  Matrix matrix_;
  LinearSolver linear_solver_;
  NonlinearSolver nonlinear_solver_;
  std::unique_ptr<ShiftedSolver> shifted_solver_;
  std::shared_ptr<StructuredJacobian> structured_;
  void* integrator_ = nullptr;
  bool interpolates_ = false, ends_on_stops_ = false;
  int warnings_ = 0;
  std::string message_;  ///< the library's last error message, kept from stderr
};

/// A solver of the library.
struct Method {
  SolverInfo info;
  const Module* module;
  /// Creates the integrator of a session and sets it up; tolerances, steps and stop times of the
  /// request are set afterwards. Throws Failure.
  std::function<void(Session&)> build;
  /// It takes the explicit and the implicit part of a problem; the session's right-hand side and
  /// Jacobian are then those of the implicit part.
  bool split = false;
};

Outcome solve(const Method& method, const ErasedContest& contest, const Request& request);

/// The solvers, by file.
std::vector<Method> cvode_methods();
std::vector<Method> cvode_held_methods();
std::vector<Method> arkode_explicit_methods();
std::vector<Method> arkode_implicit_methods();
std::vector<Method> arkode_imex_methods();

}  // namespace odeum::adapters::sundials
