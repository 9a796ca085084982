// SPDX-License-Identifier: BSD-3-Clause
#include <odeum/api/integrate.hpp>
#include <odeum/methods/dormand_prince853.hpp>
#include <odeum/methods/rk4.hpp>

#include "pendulum.hpp"

template <class Method, class Steps>
double time_of_second_return(Steps steps) {
  std::array<double, 2> y{1, 0};
  // The angle rises through zero after three quarters of a period.
  const auto angle = [](double, const std::array<double, 2>& state) { return state[0]; };
  const odeum::RunEnd run = odeum::integrate(Pendulum{}, Method{}, y, 0, 100, steps,
                                             odeum::until_event(angle, odeum::Crossing::rising));
  return run.event && std::abs(y[0]) < 1e-12 ? run.t : -1;
}

int main() {
  const double exact = 0.75 * Pendulum::period();
  using namespace odeum::methods;
  const double tight = time_of_second_return<dormand_prince853>(odeum::Tolerance{1e-11}) - exact;
  const double coarse = time_of_second_return<rk4>(odeum::Step{0.1}) - exact;
  const double fine = time_of_second_return<rk4>(odeum::Step{0.05}) - exact;
  // The time of the event has the order of the method: halving the step divides its error by 16.
  const double order = std::log2(coarse / fine);
  return std::abs(tight) < 1e-9 && order > 3.5 && order < 4.5 ? 0 : 1;
}
