// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <mutex>
#include <string>

namespace odeum::adapters::odepack {

/// The callbacks of LSODA, LSODE and VODE, whose last two arguments are passed on: `problem` is a
/// pointer of the caller's. A Jacobian is column-major with `rows` rows, of a band by diagonals.
using Rhs = void (*)(const int* n, const double* t, const double* y, double* dydt, double* problem,
                     const int*);
using Jacobian = void (*)(const int* n, const double* t, const double* y, const int* lower,
                          const int* upper, double* jacobian, const int* rows, double* problem,
                          const int*);
/// LSODA, LSODE and VODE: the arguments are those of their documentation, the last ones passed on.
using Multistep = void (*)(Rhs, int* n, double* y, double* t, double* t_out, int* kind_of_tolerance,
                           double* relative, double* absolute, int* task, int* state, int* optional,
                           double* work, int* work_length, int* integers, int* integers_length,
                           Jacobian, int* method, double* problem, int*);
/// Their polynomial of the last step, or a derivative of it, at a time within the step.
using Interpolate = void (*)(double* t, int* derivative, double* history, int* n, double* y,
                             int* flag);

/// RADAU5 as changed by the authors of deSolve: its Jacobian has the arguments of LSODE's.
using RadauMass = void (*)(const int* n, double* mass, const int* rows, double* problem,
                           const int*);
using RadauStep = void (*)(const int* number, const double* t_old, const double* t, const double* y,
                           double* continuous, int* length, int* n, double* problem, const int*,
                           int* interrupt);
using Radau = void (*)(int* n, Rhs, double* t, double* y, double* t_end, double* h,
                       double* relative, double* absolute, int* kind_of_tolerance, Jacobian,
                       int* has_jacobian, int* lower, int* upper, RadauMass, int* has_mass,
                       int* mass_lower, int* mass_upper, RadauStep, int* calls_step, double* work,
                       int* work_length, int* integers, int* integers_length, double* problem, int*,
                       int* flag);
/// Its collocation polynomial, all components.
using RadauContinuous = void (*)(int* n, double* t, double* continuous, int* length, double* y);

/// The integrators, loaded at the first use. They keep their state in Fortran's common blocks, so
/// that one run at a time may hold `in_use` from its start to its end.
struct Library {
  std::string failure;  ///< why it could not be loaded; empty where it was
  std::mutex in_use;
  Multistep lsoda = nullptr, lsode = nullptr, vode = nullptr;
  Interpolate of_odepack = nullptr, of_vode = nullptr;
  Radau radau5 = nullptr;
  RadauContinuous continuous = nullptr;
};
Library& library();

}  // namespace odeum::adapters::odepack
