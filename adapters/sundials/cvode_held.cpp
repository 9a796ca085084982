// SPDX-License-Identifier: BSD-3-Clause
#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>

#include <utility>

#include "sundials/cvode.hpp"
#include "sundials/newton.hpp"

namespace odeum::adapters::sundials {
namespace {

// CVODE has no fixed-step mode. Its step is fixed by equal initial, least and largest steps and by
// tolerances that every step meets; the convergence coefficient keeps the iteration accurate.
//
// Only order 1 can be run so: CVODE changes its order only together with its step
// (reports/findings/sundials.md), so that a larger maximal order would have no effect.
void hold(Session& session) {
  void* const cvode = session.integrator();
  const double h = FixedGrid(session.t0(), session.request()).h();
  const double never_missed = 1e6;
  check(CVodeSStolerances(cvode, never_missed, never_missed), "setting the tolerances");
  check(CVodeSetNonlinConvCoef(cvode, exact_solve_tolerance(session) / never_missed),
        "setting the convergence coefficient");
  check(CVodeSetMaxNonlinIters(cvode, max_exact_iterations), "setting the limit of iterations");
  check(CVodeSetInitStep(cvode, h), "setting the first step");
  check(CVodeSetMaxStep(cvode, h), "setting the largest step");
  // Slightly less than h: CVODE compares the two by way of 1 / h.
  check(CVodeSetMinStep(cvode, h * (1 - 1e-12)), "setting the least step");
  check(CVodeSetMaxOrd(cvode, 1), "setting the order");
}

}  // namespace

std::vector<Method> cvode_held_methods() {
  const auto method = [](int family, const char* name, const char* solves) {
    SolverInfo info;
    info.library = "cvode";
    info.method = name;
    info.family = "multistep";
    info.order = 1;
    info.source = std::string(
                      "CVODE with a held step, which it has no mode for: init = min = max "
                      "step, error test in effect disabled, order 1 (backward Euler), ") +
                  solves;
    return Method{std::move(info), &cvode_module, [family](Session& session) {
                    create_cvode(session, family);
                    hold(session);
                    if (family == CV_ADAMS) return;
                    // A new matrix in each step.
                    void* const cvode = session.integrator();
                    check(CVodeSetLSetupFrequency(cvode, 1), "setting the frequency of setups");
                    check(CVodeSetJacEvalFrequency(cvode, 1), "setting the frequency of Jacobians");
                  }};
  };
  return {method(CV_ADAMS, "adams_held_1", "fixed-point iteration"),
          method(CV_BDF, "bdf_held_1", "Newton iteration")};
}

}  // namespace odeum::adapters::sundials
