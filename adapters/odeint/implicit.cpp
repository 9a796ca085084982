// SPDX-License-Identifier: BSD-3-Clause
// C++17, and without uBLAS's own checks, which make it an order of magnitude slower.
#include "odeint/implicit.hpp"

#include <boost/numeric/odeint/stepper/rosenbrock4.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_controller.hpp>
#include <boost/numeric/odeint/stepper/rosenbrock4_dense_output.hpp>
#include <cstdlib>
#include <exception>

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
#include "odeint/walk.hpp"
#include "odeum/contest/dense_jacobian.hpp"
#include "odeum/contest/first_step.hpp"

namespace odeum::adapters::odeint {
namespace {

namespace od = boost::numeric::odeint;
namespace ublas = boost::numeric::ublas;
using Vector = ublas::vector<double>;

/// rosenbrock4 for the controller, which divides the estimate by one absolute tolerance and the
/// relative one: estimates scaled so that it then divides by the absolute tolerance of the
/// component.
class ByComponent : public od::rosenbrock4<double> {
 public:
  explicit ByComponent(const Tolerance& tolerance = Tolerance(1)) : tolerance_(tolerance) {}
  template <class System>
  void do_step(System system, const Vector& y, double t, Vector& y_new, double h, Vector& error) {
    od::rosenbrock4<double>::do_step(system, y, t, y_new, h, error);
    for (std::size_t i = 0; i < y.size(); ++i) {
      const double size = std::max(std::abs(y[i]), std::abs(y_new[i]));
      error[i] *= (1 + size) / (tolerance_.threshold(i) + size);
    }
  }

 private:
  Tolerance tolerance_;
};

template <class Stepper>
using Controller = od::rosenbrock4_controller<Stepper>;

/// Calls run(controller), of the request's tolerance.
template <class Run>
void with_controller(const Request& request, Run&& run) {
  const Tolerance tolerance = request.tolerances();
  if (request.by_component())
    run(Controller<ByComponent>(tolerance.relative, tolerance.relative, ByComponent(tolerance)));
  else
    run(Controller<od::rosenbrock4<double>>(tolerance.absolute(0), tolerance.relative));
}

using Matrix = ublas::matrix<double>;  // row-major, as the problem's own

struct Rhs {
  GuardedView* problem;
  void operator()(const Vector& y, Vector& dydt, double t) const {
    if (problem->rhs(t, &y[0], &dydt[0]) != 0) throw Tripped{};
  }
};

/// implicit_euler passes the time of the step's end; rosenbrock4 also needs df/dt.
struct Jacobian {
  GuardedView* problem;
  DenseJacobian* jacobian;
  void operator()(const Vector& y, Matrix& j, double t) const {
    if ((*jacobian)(t, &y[0], &j(0, 0)) != 0) throw Tripped{};
  }
  void operator()(const Vector& y, Matrix& j, double t, Vector& dfdt) const {
    (*this)(y, j, t);
    problem->time_derivative(t, &y[0], &dfdt[0]);
  }
};

using System = std::pair<Rhs, Jacobian>;

template <class Body>
Outcome attempt(const OdeView& view, const std::vector<double>& y0, const Request& request,
                Body&& body) {
  GuardedView problem(view, request.budget);
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
  constexpr int order = 4;
  return first_step(*system.first.problem, t0, y0, request.stops.back(), order,
                    request.tolerances());
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
  return attempt(view, y0, request, [&](const System& system, Vector& y, Outcome& outcome) {
    with_controller(request, [&](auto stepper) {
      walk_controlled(stepper, system, t0, first(system, t0, y0, request), request, y, outcome);
    });
  });
}

Outcome run_rosenbrock4_dense_output(const OdeView& view, double t0, const std::vector<double>& y0,
                                     const Request& request) {
  if (request.mode == Mode::fixed) return refuse_fixed();
  return attempt(view, y0, request, [&](const System& system, Vector& y, Outcome& outcome) {
    with_controller(request, [&](auto controller) {
      od::rosenbrock4_dense_output<decltype(controller)> stepper(controller);
      walk_dense(stepper, system, t0, first(system, t0, y0, request), request, y, outcome);
    });
  });
}

}  // namespace odeum::adapters::odeint
