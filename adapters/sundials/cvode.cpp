// SPDX-License-Identifier: BSD-3-Clause
#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <utility>

#include "sundials/cvode.hpp"
#include "sundials/newton.hpp"

namespace odeum::adapters::sundials {
namespace {

constexpr const char* constraints = "constraints";

/// The library's own constraints on all components, as the request's option asks for them. Its
/// interpolant does not keep them, so that steps end on the stops.
void constrain(Session& session) {
  const auto asked = session.request().options.find(constraints);
  if (asked == session.request().options.end()) return;
  const Vector all(N_VClone(session.y()));
  if (!all) throw Failure{CV_MEM_FAIL, "making the vector of constraints"};
  N_VConst(asked->second, all.get());
  check(CVodeSetConstraints(session.integrator(), all.get()), "setting the constraints");
  session.end_steps_on_stops();
}

}  // namespace

void create_cvode(Session& session, int family) {
  session.adopt(CVodeCreate(family, session.context()));
  check(CVodeInit(session.integrator(), Session::rhs, session.t0(), session.y()), "CVodeInit");
  if (family == CV_BDF) {
    attach_linear_solver(session);
    // The Jacobian anew at each setup of the matrix, not at each 51st step: with an exact one this
    // takes 0.6 to 0.8 of the time over the stiff cases, and no run fails (reports/peers.md).
    if (factorises(session))
      check(CVodeSetJacEvalFrequency(session.integrator(), 1),
            "setting the frequency of Jacobians");
  } else {
    NonlinearSolver solver(SUNNonlinSol_FixedPoint(session.y(), 0, session.context()));
    if (!solver) throw Failure{CV_MEM_FAIL, "creating the fixed-point iteration"};
    check(CVodeSetNonlinearSolver(session.integrator(), solver.get()),
          "attaching the fixed-point iteration");
    session.keep(std::move(solver));
  }
}

std::vector<Method> cvode_methods() {
  const auto method = [](int family, const char* name, const char* solves, const char* orders) {
    SolverInfo info;
    info.library = "cvode";
    info.method = name;
    info.family = "multistep";
    info.fixed = false;
    info.adaptive = true;
    info.common_use = CommonUse::tolerance;
    info.options = {
        {constraints,
         "CVodeSetConstraints for all states: 1 keeps them at least 0, 2 above 0, -1 at "
         "most 0, -2 below 0"}};
    info.controller = "variable order and step, local error test";
    info.source =
        std::string("CVODE user guide, mathematical considerations: ") + orders + ", " + solves;
    return Method{std::move(info), &cvode_module, [family](Session& session) {
                    create_cvode(session, family);
                    constrain(session);
                  }};
  };
  return {method(CV_ADAMS, "adams", "fixed-point iteration", "Adams-Moulton of orders 1 to 12"),
          method(CV_BDF, "bdf", "Newton iteration",
                 "backward differentiation of orders 1 to 5, fixed leading coefficient")};
}

}  // namespace odeum::adapters::sundials
