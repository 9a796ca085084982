// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odepack/library.hpp"
#include "odeum/linear/ordering.hpp"
#include "odeum/solvers/dense_jacobian.hpp"
#include "odeum/solvers/solver.hpp"

namespace odeum::adapters::odepack {

/// Leaves the Fortran code from a callback: it has no other way out, and begins anew at the next
/// run. The guard says why where the budget is spent.
struct Left {
  Status status = Status::over_budget;
};

/// The problem of a run as its callbacks see it.
class Problem {
 public:
  Problem(const ErasedContest& contest, const Request& request);

  static Problem& of(double* pointer) { return *reinterpret_cast<Problem*>(pointer); }
  double* pointer() { return reinterpret_cast<double*>(this); }

  int size() const { return static_cast<int>(n_); }
  GuardedView& guarded() { return guarded_; }
  /// A band takes the place of the full matrix where it has fewer entries.
  bool banded() const { return banded_; }
  int lower() const { return static_cast<int>(band_.lower); }
  int upper() const { return static_cast<int>(band_.upper); }
  /// Whether `fill` gives the Jacobian; of a band without a formula the integrators take their own
  /// differences.
  bool has_jacobian() const { return !banded_ || guarded_.view().jacobian_entries; }
  bool too_large() const { return !banded_ && n_ > dense_dimension_limit; }

  /// Throws Left where the budget is spent, as fill does, or where no value is a number any more:
  /// the integrators would shorten their step for as long as they may.
  void rhs(double t, const double* y, double* dydt);
  /// Column-major with `rows` rows, of a band its diagonals from the uppermost on.
  void fill(double t, const double* y, double* jacobian, int rows);

  /// The absolute tolerances, one or as many as components, which the integrators may change.
  std::vector<double> absolute(const Tolerance& tolerance) const;

 private:
  std::size_t n_;
  GuardedView guarded_;
  DenseJacobian dense_;
  linear::Band band_;
  bool banded_ = false, watched_;
  int not_finite_ = 0;  ///< evaluations one after the other
  std::vector<double> values_;
};

/// A multistep method of the library.
struct MultistepMethod {
  const char *library, *method, *name;
  Multistep Library::*run;
  Interpolate Library::*interpolate;
  bool stiff;     ///< solves with the Jacobian
  bool switches;  ///< LSODA: between the two
  const char* source;
};

/// Each runs as requested and never throws: a library's failure is an outcome.
Outcome solve(const MultistepMethod& method, const ErasedContest& contest, const Request& request);
Outcome solve_by_radau5(const ErasedContest& contest, const Request& request);

}  // namespace odeum::adapters::odepack
