// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "odeum/core/numbers.hpp"
#include "odeum/problem/function_problem.hpp"

/// The test problems of the proofs: small ones with closed solutions, so that all methods and
/// thousands of mutants can be measured in seconds.
namespace odeum::proof {

template <class P>
struct TestProblem {
  std::string id;  ///< linear, nonlinear, non_autonomous, ...
  P problem;
  double t0 = 0, horizon = 2;  ///< of a run; solutions last for four times that
  std::vector<double> y0;
  std::function<void(double t, double* y)> truth;  ///< the exact solution through (t0, y0)
};

/// An acceleration and its derivatives by q, v and t, each dense and row-major over the degrees of
/// freedom; a_v and a_t may be empty: zero.
struct Accelerations {
  using Function = std::function<void(double t, const double* q, const double* v, double* out)>;
  Function a, a_q, a_v{}, a_t{};
};
/// The problem with its first-order form filled in.
template <bool Velocity>
FunctionMechanics<Velocity> mechanics(std::size_t degrees, const Accelerations& d);

/// - `linear`: z' = M z, a damped rotation that is not normal;
/// - `nonlinear`: the same flow in curvilinear coordinates y = (z_1, z_2 + g(z_1)), in which every
///   elementary differential occurs;
/// - `non_autonomous`: the same in a time of varying rate, and a quadrature
///   y_3' = cos 3t, in which a wrong node shows alone.
const std::vector<TestProblem<FunctionProblem>>& test_problems();

/// Separable problems q'' = a(t, q): `linear`, an oscillator; `nonlinear`, Kepler's ellipse with
/// e = 0.3; `non_autonomous`, a driven pendulum.
const std::vector<TestProblem<FunctionMechanics<false>>>& separable_test_problems();

/// With velocities in the acceleration: `linear`, a damped oscillator; `nonlinear`, a rotation
/// under a force that grows with the speed; `non_autonomous`, a driven pendulum with damping.
const std::vector<TestProblem<FunctionMechanics<true>>>& second_order_test_problems();

}  // namespace odeum::proof
