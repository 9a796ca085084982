// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "odeum/contest/case.hpp"
#include "plugin/evaluator.hpp"
#include "plugin/plugin.h"

namespace odeum::adapters::plugin {

/// A plug-in's problem: called directly in a process of a solve, through an Evaluator elsewhere.
class Problem {
 public:
  explicit Problem(const odeum_problem& description);
  Problem(const Problem&) = delete;
  Problem& operator=(const Problem&) = delete;

  /// The problem behind function pointers; it must outlive the view.
  OdeView view() const;
  /// False where the solution is not known there.
  bool exact(double t, double* y) const;
  double energy(const double* y) const;
  /// A sentence where a function cannot be called from the initial state to the horizon; to be
  /// called in a process of its own.
  std::string fault() const;

 private:
  enum Function { rhs, jacobian, time_derivative, acceleration, energy_of, exact_at };
  int direct(int function, double t, const double* in, double* out) const;
  void evaluate(Function function, double t, const double* in, std::size_t n_in, double* out,
                std::size_t n_out) const;
  int dense(double t, const double* y, double* j) const;
  bool has_jacobian() const;
  std::string fault_of_exact() const;

  odeum_problem p_;
  mutable std::vector<double> values_;  ///< of a banded or sparse Jacobian
  std::shared_ptr<Evaluator> evaluator_;
};

/// What is wrong with the description, in a sentence; empty where nothing is.
std::string fault_of(const odeum_problem& problem);

/// The case of a problem, without entrants.
Case case_of(const odeum_problem& problem, const std::string& library);

}  // namespace odeum::adapters::plugin
