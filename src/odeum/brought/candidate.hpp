// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "odeum/core/numbers.hpp"
#include "odeum/problem/function_problem.hpp"
#include "odeum/proof/any_stepper.hpp"
#include "odeum/solvers/case.hpp"

namespace odeum::brought {

/// The problem of a case as own methods of any family take it. The case has to outlive it.
class Problem {
 public:
  explicit Problem(const Case& c);
  /// Its address is kept by the functions.
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  const FunctionProblem& first_order() const { return mechanics_; }
  /// The problem of second order, y = [q, v]; null where it is of first order.
  const FunctionMechanics<true>* second_order() const {
    return of_second_order_ ? &mechanics_ : nullptr;
  }
  /// The same where the acceleration does not depend on velocities; else null.
  const FunctionMechanics<false>* separable() const {
    return separable_ ? separable_.get() : nullptr;
  }
  std::size_t size() const { return mechanics_.unknowns; }

 private:
  OdeView view_;
  bool of_second_order_ = false;
  FunctionMechanics<true> mechanics_;
  std::unique_ptr<FunctionMechanics<false>> separable_;
};

/// Consecutive rows of a run, equally far apart.
struct Rows {
  double t = 0, h = 0;  ///< of the first row; of a step
  std::size_t steps_a_row = 1;
  std::vector<const double*> y;  ///< `history` + 1 states
};

/// A way to get from rows to the next one: a method, or a method with a mistake.
struct Candidate {
  std::string method;   ///< the id of an own method, or a name
  std::string mistake;  ///< a clause that says what is done otherwise; empty: nothing is
  double order = 0;     ///< the method's
  std::size_t history = 1;
  /// The last row without what the rows before it give, in the components' units; false: the
  /// candidate can't take the step.
  std::function<bool(const Problem&, const Rows&, double* defect)> defect;
};

/// Every own one-step method, and linear multistep formulas.
std::vector<Candidate> known_methods();
/// What people get wrong in an explicit Runge-Kutta method, in one of second order, or in a
/// multistep formula: of the method, or where it is empty of those that are taught.
std::vector<Candidate> known_mistakes(const std::string& method);

/// A step of a method that has no file.
using Step = std::function<bool(const Problem&, double t, double h, std::vector<double>& y)>;
Candidate one_step(std::string method, std::string mistake, double order, Step step);
/// The same of a tableau.
Candidate of_tableau(std::string method, std::string mistake, DynamicTableau<double> tableau);

/// The formula sum_j alpha_j y_{n+j} = h sum_j beta_j f_{n+j}.
Candidate multistep(std::string method, std::string mistake, double order,
                    std::vector<double> alpha, std::vector<double> beta);

}  // namespace odeum::brought
