// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "odeum/cases/set_problem.hpp"
#include "odeum/formula/text_ode.hpp"
#include "odeum/why/why.hpp"

/// Runs that fail or crawl for causes that are known by how they were made.
namespace odeum::tests {

struct MadeFailure {
  std::string name, text, solver;
  double step = 0;  ///< 0: by tolerance
  double relative = 1e-6;
  std::vector<double> absolute = {1e-9};
  std::set<why::Cause> causes;     ///< true by construction; each has to be said
  std::set<why::Cause> also = {};  ///< true besides, and may be said
  double wrong_jacobian = 1;       ///< by which the entries are multiplied
  std::vector<double> end = {};    ///< the solution at the end, computed apart; empty: unknown
};

/// The case of a text, interpreted, without a truth.
inline Case made_case(const MadeFailure& made) {
  const auto ode = std::make_shared<const formula::TextOde>(
      formula::read_problem(made.name, made.text), formula::TextOde::Code::interpreted);
  const formula::Problem& problem = ode->problem();
  Case c;
  c.id = made.name;
  c.t0 = static_cast<double>(problem.t0);
  c.y0.assign(problem.y0.begin(), problem.y0.end());
  c.stops = problem.stops;
  c.components = problem.states;
  c.truth.at = [](double, double*) { return false; };
  struct Wrong {
    std::shared_ptr<const formula::TextOde> ode;
    double factor;
  };
  const auto wrong = std::make_shared<const Wrong>(Wrong{ode, made.wrong_jacobian});
  OdeView view = ode->view();
  std::shared_ptr<const void> keep = ode;
  if (made.wrong_jacobian != 1) {
    OdeView by_hand;
    by_hand.problem = wrong.get();
    by_hand.dimension = view.dimension;
    by_hand.rhs = [](const void* p, double t, const double* y, double* f) {
      static_cast<const Wrong*>(p)->ode->rhs(t, y, f);
    };
    by_hand.jacobian = [](const void* p, double t, const double* y, double* j) {
      const auto& self = *static_cast<const Wrong*>(p);
      const OdeView& right = self.ode->view();
      right.jacobian(right.problem, t, y, j);
      for (std::size_t k = 0; k < right.dimension * right.dimension; ++k) j[k] *= self.factor;
    };
    view = by_hand;
    keep = wrong;
  }
  c.problem = {view, keep, c.t0, std::make_shared<const std::vector<double>>(c.y0), nullptr};
  c.entrants = cases::enroll(c.problem);
  return c;
}

inline why::Why why_of(const MadeFailure& made, const Case& c, const Request& request,
                       double seconds) {
  return why::why(c, made.solver, request, seconds,
                  cases::conditions_of(formula::read_problem(made.name, made.text)));
}

inline Request made_request(const MadeFailure& made, const Case& c) {
  Request request;
  request.stops = {c.stops.back()};
  // Runs across a jump again and again go on for hundreds of millions.
  request.budget.evaluations = 500'000;
  if (made.step > 0) {
    request.steps = static_cast<std::uint64_t>(std::llround((c.stops.back() - c.t0) / made.step));
  } else {
    request.mode = Mode::adaptive;
    request.tolerance = Tolerance(made.relative, made.absolute);
  }
  return request;
}

std::vector<MadeFailure> brought_failures();
std::vector<MadeFailure> failures_of_two_causes();
/// All failures: the ones above, and the ones with one cause.
const std::vector<MadeFailure>& made_failures();

}  // namespace odeum::tests
