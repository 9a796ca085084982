// SPDX-License-Identifier: BSD-3-Clause
#include <odeum/api/integrate.hpp>
#include <odeum/methods/radau_iia5.hpp>

#include <array>
#include <cmath>

/// Van der Pol's equation, stiff: the state at t = 2 to 16 digits is in cases/reference.
struct VanDerPol {
  static constexpr std::size_t dimension = 2;
  void rhs(double, const double* y, double* dydt) const {
    dydt[0] = y[1];
    dydt[1] = ((1 - y[0] * y[0]) * y[1] - y[0]) * 1e6;
  }
};

int main() {
  std::array<double, 2> y{2, 0};
  const odeum::RunEnd run =
      odeum::integrate(VanDerPol{}, odeum::methods::radau_iia5{}, y, 0, 2, odeum::Tolerance{1e-8});
  return run.ok() && std::abs(y[0] - 1.706167732170465) < 1e-6 ? 0 : 1;
}
