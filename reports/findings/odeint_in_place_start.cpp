// SPDX-License-Identifier: BSD-3-Clause
// Boost.odeint alone: do_step(system, x, t, dt) of extrapolation_stepper, and of adams_bashforth
// while it starts itself, against the same step out of place. y' = -y to t = 1; the order is that
// of the last doubling. Exits 0 while the in-place call loses its order.
#include <array>
#include <boost/numeric/odeint/stepper/adams_bashforth.hpp>
#include <boost/numeric/odeint/stepper/extrapolation_stepper.hpp>
#include <cmath>
#include <cstdio>

namespace od = boost::numeric::odeint;
using State = std::array<double, 1>;

template <class Stepper>
double error(int steps, bool in_place) {
  const auto rhs = [](const State& y, State& dydt, double) { dydt[0] = -y[0]; };
  Stepper stepper;
  State y{1}, next{};
  const double h = 1.0 / steps;
  for (int i = 0; i < steps; ++i) {
    if (in_place) {
      stepper.do_step(rhs, y, i * h, h);
    } else {
      stepper.do_step(rhs, y, i * h, next, h);
      y = next;
    }
  }
  return std::abs(y[0] - std::exp(-1.0));
}

template <class Stepper>
bool stands(const char* name, double claimed) {
  const double in = std::log2(error<Stepper>(32, true) / error<Stepper>(64, true));
  const double out = std::log2(error<Stepper>(32, false) / error<Stepper>(64, false));
  std::printf("%s: claimed order %g, in place %.2f (error %.1e), out of place %.2f (error %.1e)\n",
              name, claimed, in, error<Stepper>(64, true), out, error<Stepper>(64, false));
  return in < 1.5 && out > claimed - 0.5;
}

int main() {
  const bool extrapolation =
      stands<od::extrapolation_stepper<4, State>>("extrapolation_stepper<4>", 4);
  const bool adams = stands<od::adams_bashforth<4, State>>("adams_bashforth<4>", 4);
  return extrapolation && adams ? 0 : 1;
}
