// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gsl/gsl_odeiv2.h>

#include "odeum/solvers/solver.hpp"

namespace odeum::adapters::gsl {

/// What a stepper needs.
enum class Kind {
  explicit_rk,    ///< a right-hand side
  implicit_rk,    ///< a Jacobian, and a tolerance for its Newton iteration
  extrapolation,  ///< a Jacobian and df/dt
  adams,          ///< a tolerance for its corrector and its choice of order
  bdf             ///< a Jacobian, and a tolerance as above
};

struct Method {
  const char* name = nullptr;
  const gsl_odeiv2_step_type* const* type = nullptr;
  Kind kind = Kind::explicit_rk;
  double order = 0;  ///< as given by gsl_odeiv2_step_order; NaN where it varies
  const char* source = nullptr;
  CommonUse common_use = CommonUse::none;

  /// Weight of h |y'| in the error level, of |y| it is 1. For explicit methods it takes 0.7 to 1.0
  /// of the evaluations to an error; implicit ones gain nothing or lose (reports/peers.md).
  double a_dydt() const { return kind == Kind::explicit_rk ? 1 : 0; }
  bool multistep() const { return kind == Kind::adams || kind == Kind::bdf; }
  /// The order of the first step: a multistep method begins at order 1.
  int first_order() const {
    return multistep() ? 1 : kind == Kind::extrapolation ? 6 : static_cast<int>(order);
  }
  bool needs_jacobian() const { return kind != Kind::explicit_rk && kind != Kind::adams; }
};

/// Integrates as requested; never throws, since a library's failure is an outcome.
Outcome solve(const Method& method, const ErasedContest& contest, const Request& request);

}  // namespace odeum::adapters::gsl
