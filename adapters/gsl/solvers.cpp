// SPDX-License-Identifier: BSD-3-Clause
#include "gsl/solvers.hpp"

#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include <limits>
#include <memory>

#include "gsl/method.hpp"

namespace odeum::adapters::gsl {
namespace {

constexpr double varies = std::numeric_limits<double>::quiet_NaN();
constexpr const char* manual = "GSL 2.7 reference manual, Ordinary Differential Equations: ";

const Method methods[] = {
    {"rk2", &gsl_odeiv2_step_rk2, Kind::explicit_rk, 2, "explicit embedded Runge-Kutta (2, 3)"},
    {"rk4", &gsl_odeiv2_step_rk4, Kind::explicit_rk, 4,
     "explicit 4th order (classical) Runge-Kutta, error by step doubling; the two half steps are "
     "kept",
     CommonUse::fixed_step},
    {"rkf45", &gsl_odeiv2_step_rkf45, Kind::explicit_rk, 5, "embedded Runge-Kutta-Fehlberg (4, 5)"},
    {"rkck", &gsl_odeiv2_step_rkck, Kind::explicit_rk, 5, "embedded Runge-Kutta Cash-Karp (4, 5)"},
    {"rk8pd", &gsl_odeiv2_step_rk8pd, Kind::explicit_rk, 8,
     "embedded Runge-Kutta Prince-Dormand (8, 9)", CommonUse::tolerance},
    {"rk1imp", &gsl_odeiv2_step_rk1imp, Kind::implicit_rk, 1,
     "implicit Euler, error by step doubling; the two half steps are kept"},
    {"rk2imp", &gsl_odeiv2_step_rk2imp, Kind::implicit_rk, 2,
     "implicit mid-point rule, error by step doubling; the two half steps are kept"},
    {"rk4imp", &gsl_odeiv2_step_rk4imp, Kind::implicit_rk, 4,
     "implicit Gaussian 4th order Runge-Kutta, error by step doubling; the two half steps are "
     "kept"},
    {"bsimp", &gsl_odeiv2_step_bsimp, Kind::extrapolation, varies,
     "implicit Bulirsch-Stoer method of Bader and Deuflhard; its order follows from the dimension"},
    {"msadams", &gsl_odeiv2_step_msadams, Kind::adams, varies,
     "variable-coefficient Adams method in Nordsieck form, orders 1 to 12", CommonUse::tolerance},
    {"msbdf", &gsl_odeiv2_step_msbdf, Kind::bdf, varies,
     "variable-coefficient BDF method in Nordsieck form, orders 1 to 5"},
};

/// The order that the library reports for a stepper; bsimp fixes it at creation, from the
/// dimension.
double order_of(const Method& method, std::size_t dimension) {
  if (method.kind != Kind::extrapolation || dimension == 0 || dimension > dense_dimension_limit)
    return method.order;
  const std::unique_ptr<gsl_odeiv2_step, decltype(&gsl_odeiv2_step_free)> step(
      gsl_odeiv2_step_alloc(*method.type, dimension), gsl_odeiv2_step_free);
  return step ? gsl_odeiv2_step_order(step.get()) : method.order;
}

SolverInfo describe(const Method& method) {
  SolverInfo info;
  info.library = "gsl";
  info.method = method.name;
  switch (method.kind) {
    case Kind::explicit_rk:
      info.family = "explicit_rk";
      break;
    case Kind::implicit_rk:
      info.family = "implicit_rk";
      break;
    case Kind::extrapolation:
      info.family = "extrapolation";
      break;
    case Kind::adams:
    case Kind::bdf:
      info.family = "multistep";
  }
  info.order = method.order;
  info.fixed = !method.multistep();  // its order follows from a tolerance, see solve
  info.adaptive = true;
  info.common_use = method.common_use;
  info.controller = fmt::format(
      "gsl_odeiv2_driver_alloc_standard_new (scaled_new where absolute tolerances "
      "differ): error within abs + rel |y|{}",
      method.a_dydt() > 0 ? " + rel h |y'|" : "");
  if (method.needs_jacobian()) info.needs = "a dense Jacobian (differenced where there is none)";
  info.source = std::string(manual) + method.source;
  return info;
}

}  // namespace

void add_solvers(std::vector<Solver>& all) {
  // The library's default handler aborts the process. It is global: disabled once, and before any
  // call of the library.
  static const gsl_error_handler_t* const previous = gsl_set_error_handler_off();
  static_cast<void>(previous);
  for (const Method& method : methods)
    all.push_back({describe(method), [&method](const ErasedContest& contest, Entrant& entrant) {
                     entrant.info.order = order_of(method, contest.view.dimension);
                     entrant.solve = [&method, contest](const Request& request) {
                       return gsl::solve(method, contest, request);
                     };
                   }});
}

}  // namespace odeum::adapters::gsl
