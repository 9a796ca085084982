// SPDX-License-Identifier: BSD-3-Clause
// Boost.odeint alone: the order of adams_bashforth_moulton<K>, with its default start and with the
// one of adams_bashforth. q'' = -q to t = 2. The header's comment claims K + 1, order() returns K.
// Exits 0 while it is K, and 5 for K = 8 with the default start.
#include <array>
#include <boost/numeric/odeint/stepper/adams_bashforth_moulton.hpp>
#include <cmath>
#include <cstdio>

namespace od = boost::numeric::odeint;
using State = std::array<double, 2>;
template <std::size_t K>
using Default = od::adams_bashforth_moulton<K, State>;
template <std::size_t K>
using WellStarted = od::adams_bashforth_moulton<
    K, State, double, State, double, od::algebra_dispatcher<State>::algebra_type,
    od::operations_dispatcher<State>::operations_type, od::initially_resizer,
    typename od::adams_bashforth<K, State>::initializing_stepper_type>;

template <class Stepper>
double error(int steps) {
  const auto rhs = [](const State& y, State& dydt, double) { dydt = {y[1], -y[0]}; };
  Stepper stepper;
  State y{1, 0}, next{};
  const double h = 2.0 / steps;
  for (int i = 0; i < steps; ++i) {
    stepper.do_step(rhs, y, i * h, next, h);
    y = next;
  }
  return std::abs(y[0] - std::cos(2.0));
}

template <class Stepper>
double order(int steps) {
  return std::log2(error<Stepper>(steps) / error<Stepper>(2 * steps));
}

int main() {
  const double three = order<Default<3>>(1024), eight = order<Default<8>>(64),
               six_well = order<WellStarted<6>>(64);
  std::printf("K = 3: %.2f; K = 8, default start: %.2f; K = 6, adams_bashforth's start: %.2f\n",
              three, eight, six_well);
  const auto is = [](double measured, double expected) {
    return std::abs(measured - expected) < 0.3;
  };
  return is(three, 3) && is(eight, 5) && is(six_well, 6) ? 0 : 1;
}
