// SPDX-License-Identifier: BSD-3-Clause
// Own methods on R(t, y, y') = 0 as it is stated.
#include <utility>

#include "odeum/kernel/residual_stages.hpp"
#include "odeum/methods/radau_iia5.hpp"
#include "odeum/methods/radau_iia9.hpp"
#include "odeum/solvers/enroll_method.hpp"

namespace odeum {
namespace {

/// The residuals of a contest under a guard. An evaluation of them counts like one of the rates.
class GuardedResiduals {
 public:
  static constexpr std::size_t dimension = dynamic;

  GuardedResiduals(const ErasedContest& contest, Guard& guard)
      : form_(*contest.implicit), ordinary_(contest.view), guard_(guard) {}

  std::size_t size() const { return form_.dimension; }
  void rhs(double t, const double* y, double* rates) const {
    evaluate(t, rates, [&] { ordinary_.rhs(ordinary_.problem, t, y, rates); });
  }
  void residual(double t, const double* y, const double* rates, double* r) const {
    evaluate(t, r, [&] { form_.residual(t, y, rates, r); });
  }
  void matrix(double t, const double* y, const double* rates, double alpha, double* j) const {
    if (alpha == 0) guard_.count_jacobian();  // the other is of the same point
    form_.matrix(t, y, rates, alpha, j);
  }
  bool tripped() const { return guard_.tripped(); }

 private:
  template <class Call>
  void evaluate(double t, double* values, Call&& call) const {
    guard_.evaluate(
        t, values, [&] { return size(); }, false, std::forward<Call>(call));
  }

  const ImplicitForm& form_;
  const OdeView& ordinary_;
  Guard& guard_;
};

template <class M>
Outcome solve_residuals(const ErasedContest& contest, const Request& request) {
  Guard guard(contest.implicit->dimension, request.budget, &request.tolerance);
  Outcome outcome =
      run_method<M>(GuardedResiduals(contest, guard), contest.t0, *contest.y0, request);
  guard.conclude(request, outcome);
  return outcome;
}

/// The same method as on y' = f(t, y), under an id of its own.
template <class M>
Solver residual_method(const char* id) {
  SolverInfo info = info_of_own<M>();
  info.method = id;
  info.needs = "residuals that are not solved for all rates, R(t, y, y') = 0";
  info.source += "; on residuals, VI.1";
  return {info, [](const ErasedContest& contest, Entrant& entrant) {
            if (!contest.implicit)
              entrant.unfit = "needs " + entrant.info.needs;
            else if (contest.implicit->dimension > dense_dimension_limit)
              entrant.unfit = "takes dense matrices here, of 128 unknowns at most";
            else
              entrant.solve = [contest](const Request& request) {
                return solve_residuals<M>(contest, request);
              };
          }};
}

}  // namespace

void add_residual_methods(std::vector<Solver>& all) {
  all.push_back(residual_method<methods::radau_iia5>("radau_iia5_residual"));
  all.push_back(residual_method<methods::radau_iia9>("radau_iia9_residual"));
}

}  // namespace odeum
