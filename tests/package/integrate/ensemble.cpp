// SPDX-License-Identifier: BSD-3-Clause
// The example of odeum/api/ensemble.hpp.
#include <odeum/api/ensemble.hpp>
#include <odeum/methods/dormand_prince54.hpp>
#include <odeum/methods/rk4.hpp>

template <class Real>
struct Lorenz {
  using real = Real;
  static constexpr std::size_t dimension = 3;
  Real s{10}, r{28}, b{8. / 3};
  void rhs(Real, const Real* y, Real* dydt) const {
    dydt[0] = s * (y[1] - y[0]);
    dydt[1] = y[0] * (r - y[2]) - y[1];
    dydt[2] = y[0] * y[1] - b * y[2];
  }
};

int main() {
  // Below r = 1 every solution decays, from r = 1 on to one of two points where x^2 = b (r - 1).
  constexpr int count = 100;
  std::vector<Lorenz<double>> members(count);
  std::vector<std::array<double, 3>> states(count, {1, 2, 3});
  for (int k = 0; k < count; ++k) members[k].r = 0.5 + 0.1 * k;
  auto adaptive = states;
  const auto ends =
      odeum::integrate_ensemble(members, odeum::methods::rk4{}, states, 0, 400, odeum::Step{0.02});
  odeum::integrate_ensemble(members, odeum::methods::dormand_prince54{}, adaptive, 0, 400,
                            odeum::Tolerance{1e-9});
  for (int k = 0; k < count; ++k) {
    if (k == 5) continue;  // r = 1: slower than any exponential
    const double x = members[k].r < 1 ? 0 : std::sqrt(members[k].b * (members[k].r - 1));
    if (!ends[k].ok() || ends[k].steps != 20000) return 1;
    if (std::abs(std::abs(states[k][0]) - x) > 1e-6) return 2;
    if (std::abs(std::abs(adaptive[k][0]) - x) > 1e-6) return 3;
  }
  return 0;
}
