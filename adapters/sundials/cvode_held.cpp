// SPDX-License-Identifier: BSD-3-Clause
#include <cvode/cvode.h>
#include <cvode/cvode_ls.h>
#include <sundials/sundials_nvector.h>

#include <algorithm>
#include <utility>

#include "odeum/kernel/iteration.hpp"
#include "sundials/cvode.hpp"
#include "sundials/newton.hpp"

namespace odeum::adapters::sundials {
namespace {

constexpr double never_missed = 1e6;  // a tolerance

// Error weights relative to the largest component of the state and of its change over a step at the
// present slope: the predictor's rounding is that of their sum, and corrections are no smaller.
// From rest, where both are of no size, relative to 1.
int weigh(N_Vector y, N_Vector weights, void* data) {
  const auto& session = *static_cast<Session*>(data);
  void* const cvode = session.integrator();
  long steps = 0;
  double t = session.t0();
  CVodeGetNumSteps(cvode, &steps);
  if (steps > 0) CVodeGetCurrentTime(cvode, &t);
  // Before the first step the library has no slope to give.
  const int failed =
      steps > 0 ? CVodeGetDky(cvode, t, 1, weights) : Session::rhs(t, y, weights, data);
  if (failed != 0) return -1;
  const double h = FixedGrid(session.t0(), session.request()).h();
  double size = std::max(N_VMaxNorm(y), h * N_VMaxNorm(weights));
  if (steps == 0) size = std::max(size, 1.0);
  if (size < smallest_state) size = 1;
  N_VConst(1 / (never_missed * size), weights);
  return 0;
}

// CVODE has no fixed-step mode. Its step is fixed by equal initial, least and largest steps and by
// tolerances that every step meets; the convergence coefficient keeps the iteration accurate.
//
// Only order 1 can be run so: CVODE changes its order only together with its step
// (reports/findings/sundials.md), so that a larger maximal order would have no effect.
void hold(Session& session) {
  void* const cvode = session.integrator();
  const double h = FixedGrid(session.t0(), session.request()).h();
  check(CVodeWFtolerances(cvode, weigh), "setting the tolerances");
  check(CVodeSetNonlinConvCoef(cvode, exact_solve_tolerance(session) / never_missed),
        "setting the convergence coefficient");
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
                    void* const cvode = session.integrator();
                    // Fixed-point iteration contracts by h L: at the usual limit of iterations it
                    // would end at h L = 0.5, and not near 1, where it diverges.
                    const int most = family == CV_ADAMS ? 20'000 : max_exact_iterations;
                    check(CVodeSetMaxNonlinIters(cvode, most), "setting the limit of iterations");
                    if (family == CV_ADAMS) return;
                    // A new matrix in each step.
                    check(CVodeSetLSetupFrequency(cvode, 1), "setting the frequency of setups");
                    check(CVodeSetJacEvalFrequency(cvode, 1), "setting the frequency of Jacobians");
                  }};
  };
  return {method(CV_ADAMS, "adams_held_1", "fixed-point iteration"),
          method(CV_BDF, "bdf_held_1", "Newton iteration")};
}

}  // namespace odeum::adapters::sundials
