// SPDX-License-Identifier: BSD-3-Clause
#include <odeum/api/integrate.hpp>
#include <odeum/methods/dormand_prince54.hpp>
#include <odeum/methods/rk4.hpp>
#include <odeum/methods/velocity_verlet.hpp>

#include <array>
#include <cmath>

struct Oscillator {
  using real = float;
  static constexpr std::size_t dimension = 2;
  static constexpr bool velocity_dependent = false;
  void acceleration(float, const float* q, const float*, float* a) const { a[0] = -q[0]; }
  void rhs(float, const float* y, float* dydt) const {
    dydt[0] = y[1];
    dydt[1] = -y[0];
  }
};

template <class Method, class Steps>
bool near_cosine(Steps steps, double within) {
  std::array<float, 2> y{1, 0};
  const odeum::RunEnd run = odeum::integrate(Oscillator{}, Method{}, y, 0, 10, steps);
  return run.ok() && std::abs(static_cast<double>(y[0]) - std::cos(10.0)) < within;
}

int main() {
  using namespace odeum::methods;
  // Rounding of single precision is 6e-8 a step; that of 1000 steps, and the error of Verlet.
  return near_cosine<rk4>(odeum::Step{0.01}, 2e-5) &&
                 near_cosine<dormand_prince54>(odeum::Tolerance{1e-5}, 1e-3) &&
                 near_cosine<velocity_verlet>(odeum::Step{0.01}, 1e-4)
             ? 0
             : 1;
}
