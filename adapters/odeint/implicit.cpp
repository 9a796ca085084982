// SPDX-License-Identifier: BSD-3-Clause
// C++17, and without uBLAS's own checks, which make it an order of magnitude slower.
#include "odeint/implicit.hpp"

#include <cstdlib>
#include <exception>

#include "odeint/rosenbrock.hpp"

// implicit_euler ends the process with std::exit(0) where its matrix is singular. That call, in its
// header only (everything it includes is included above), becomes an exception.
namespace odeum::adapters::odeint {
struct SingularMatrix {};
}  // namespace odeum::adapters::odeint
#define exit(status) \
  rethrow_exception(std::make_exception_ptr(odeum::adapters::odeint::SingularMatrix{}))
#include <boost/numeric/odeint/stepper/implicit_euler.hpp>
#undef exit

#include "odeint/tripped.hpp"
#include "odeum/solvers/dense_jacobian.hpp"

namespace odeum::adapters::odeint {
namespace {

struct Rhs {
  GuardedView* problem;
  void operator()(const Vector& y, Vector& dydt, double t) const {
    if (problem->rhs(t, y.data().begin(), dydt.data().begin()) != 0) throw Tripped{};
  }
};

/// implicit_euler passes the time of the step's end; rosenbrock4 also needs df/dt.
struct Jacobian {
  GuardedView* problem;
  DenseJacobian* jacobian;
  void operator()(const Vector& y, Matrix& j, double t) const {
    if ((*jacobian)(t, y.data().begin(), &j(0, 0)) != 0) throw Tripped{};
  }
  void operator()(const Vector& y, Matrix& j, double t, Vector& dfdt) const {
    (*this)(y, j, t);
    problem->time_derivative(t, y.data().begin(), dfdt.data().begin());
  }
};

using System = std::pair<Rhs, Jacobian>;

template <class Body>
Outcome attempt(const OdeView& view, const std::vector<double>& y0, const Request& request,
                Body&& body) {
  GuardedView problem(view, request.budget, &request.tolerance);
  DenseJacobian jacobian(problem);
  Outcome outcome;
  Vector y(y0.size());
  std::copy(y0.begin(), y0.end(), y.begin());
  try {
    body(System{Rhs{&problem}, Jacobian{&problem, &jacobian}}, y, outcome);
  } catch (const SingularMatrix&) {
    outcome.status = Status::newton_failed;
    outcome.detail = "implicit_euler: singular matrix (where the library calls std::exit(0))";
  } catch (...) {
    explain_exception(outcome);
  }
  problem.guard().conclude(request, outcome);
  return outcome;
}

double first(const System& system, double t0, const std::vector<double>& y0,
             const Request& request) {
  return first_step(*system.first.problem, t0, y0, request.stops.back(), rosenbrock4_order,
                    request.tolerance);
}

template <class Stepper>
Outcome run_fixed(const OdeView& view, double t0, const std::vector<double>& y0,
                  const Request& request) {
  return attempt(view, y0, request, [&](const System& system, Vector& y, Outcome& outcome) {
    Stepper stepper;
    walk_fixed(t0, request, y, outcome,
               [&](Vector& state, double t, double h) { stepper.do_step(system, state, t, h); });
  });
}

}  // namespace

Outcome run_implicit_euler(const OdeView& view, double t0, const std::vector<double>& y0,
                           const Request& request) {
  if (request.mode == Mode::adaptive) return refuse_adaptive();
  return run_fixed<od::implicit_euler<double>>(view, t0, y0, request);
}

Outcome run_rosenbrock4(const OdeView& view, double t0, const std::vector<double>& y0,
                        const Request& request) {
  if (request.mode == Mode::fixed) return run_fixed<od::rosenbrock4<double>>(view, t0, y0, request);
  if (request.over_stops) return run_rosenbrock4_dense_output(view, t0, y0, request);
  return attempt(view, y0, request, [&](const System& system, Vector& y, Outcome& outcome) {
    walk_rosenbrock4(system, t0, first(system, t0, y0, request), request, y, outcome);
  });
}

Outcome run_rosenbrock4_dense_output(const OdeView& view, double t0, const std::vector<double>& y0,
                                     const Request& request) {
  if (request.mode == Mode::fixed) return refuse_fixed();
  return attempt(view, y0, request, [&](const System& system, Vector& y, Outcome& outcome) {
    walk_rosenbrock4_dense_output(system, t0, first(system, t0, y0, request), request, y, outcome);
  });
}

}  // namespace odeum::adapters::odeint
