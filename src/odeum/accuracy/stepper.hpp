// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/solvers/enroll_method.hpp"
#include "odeum/solvers/runtime_library.hpp"

/// A stepper from another project as a solver of the laboratory.
namespace odeum::accuracy {

/// `void step(F& f, double t, double h, std::vector<double>& y)` advances y from t to t + h; it
/// calls f(t, y.data(), dydt.data()), both of y.size() numbers. One object makes one run.
template <class Stepper>
concept PlainStepper = requires(Stepper& stepper, void (*f)(double, const double*, double*),
                                std::vector<double>& y) {
  stepper.step(f, 0.0, 0.0, y);
};

/// A plain stepper with the interface of a method's Stepper.
template <class Plain>
struct Adapted {
  template <class P>
  class Stepper {
   public:
    explicit Stepper(const P& problem) : problem_(problem) {}
    Status step(double t, double h, State<P>& y) {
      const auto f = [this](double time, const double* state, double* slope) {
        problem_.rhs(time, state, slope);
      };
      const std::size_t n = y.size();
      plain_.step(f, t, h, y);
      return y.size() == n ? Status::ok : Status::refused;
    }

   private:
    const P& problem_;
    Plain plain_{};
  };
};

/// The library `user` with the one solver `name` of the claimed order.
template <class Solver>
RuntimeLibrary library_of(const std::string& name, double order) {
  SolverInfo info;
  if constexpr (PlainStepper<Solver>)
    info.family = "own";
  else
    info = info_of_own<Solver>();
  info.library = "user";
  info.method = name;
  info.order = order;
  RuntimeLibrary library;
  library.info = {
      .name = "user", .libraries = {"user"}, .option = "", .built = true, .version = ""};
  library.solvers.push_back(
      {info, [](const ErasedContest& contest, Entrant& entrant) {
         if constexpr (PlainStepper<Solver>)
           entrant.solve = [contest](const Request& request) {
             const auto shared = shared_contest<SharedOde>(contest);
             Guard guard(shared.problem->size(), request.budget);
             const Guarded<SharedOde> problem(*shared.problem, guard);
             Outcome outcome =
                 run_fixed<typename Adapted<Solver>::template Stepper<Guarded<SharedOde>>>(
                     problem, shared.t0, *shared.y0, request);
             guard.conclude(request, outcome);
             return outcome;
           };
         else
           enroll_method<Solver>(contest, entrant);
       }});
  return library;
}

/// The program of odeum_add_accuracy_test: `order CASE FOLDER [SOLVER...]`, with solvers to
/// compare with, or `stability AXIS LIMIT`. Returns
/// its exit code: 0 the claim holds, 1 it does not, 2 usage, 77 no verdict is possible.
int run(RuntimeLibrary library, int argc, char** argv);

}  // namespace odeum::accuracy
