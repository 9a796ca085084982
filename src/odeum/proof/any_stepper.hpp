// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "odeum/core/status.hpp"
#include "odeum/problem/function_problem.hpp"
#include "odeum/tableau/interpreter.hpp"

namespace odeum::proof {

/// The steps of a method on a problem behind one interface, so that own methods, interpreted
/// tableaus and mutants of both go through the same checks.
class AnyStepper {
 public:
  virtual ~AnyStepper() = default;
  /// Call it before the first step, and where (t, y, h) do not continue the last one.
  virtual void start(double /*t*/, double /*h*/, const std::vector<double>& /*y*/) {}
  /// Makes a step, with the error estimate where one is asked for; refused where there is none.
  virtual Status step(double t, double h, std::vector<double>& y,
                      std::vector<double>* error = nullptr) = 0;
};

/// Makes a new stepper on a problem, which must outlive it. Empty: the method does not fit.
template <class P>
using MakeStepper = std::function<std::unique_ptr<AnyStepper>(const P&)>;

/// A stepper of a method file, type erased.
template <class Stepper, class P>
class ErasedStepper : public AnyStepper {
 public:
  explicit ErasedStepper(const P& problem) : stepper_(problem) {}
  void start(double t, double h, const std::vector<double>& y) override {
    if constexpr (requires { stepper_.start(t, h, y); }) stepper_.start(t, h, y);
  }
  Status step(double t, double h, std::vector<double>& y, std::vector<double>* error) override {
    if (!error) return stepper_.step(t, h, y);
    if constexpr (requires { stepper_.step(t, h, y, *error); }) {
      error->resize(y.size());
      return stepper_.step(t, h, y, *error);
    }
    return Status::refused;
  }

 private:
  Stepper stepper_;
};

class InterpretedStepper : public AnyStepper {
 public:
  InterpretedStepper(const DynamicTableau<double>& tableau, const FunctionProblem& problem)
      : embedded_(tableau.embedded()), interpreter_(tableau, problem) {}
  Status step(double t, double h, std::vector<double>& y, std::vector<double>* error) override {
    if (!error) return interpreter_.step(t, h, y);
    return embedded_ ? interpreter_.step(t, h, y, *error) : Status::refused;
  }

 private:
  bool embedded_;
  TableauInterpreter interpreter_;
};

/// The tableau must outlive the result.
inline MakeStepper<FunctionProblem> interpreted(const DynamicTableau<double>& tableau) {
  return [&tableau](const FunctionProblem& problem) {
    return std::make_unique<InterpretedStepper>(tableau, problem);
  };
}

}  // namespace odeum::proof
