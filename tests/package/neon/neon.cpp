// SPDX-License-Identifier: BSD-3-Clause
// Members in lanes against runs alone, to the last bit: compiled for a processor with NEON and run
// by an emulator, see neon.sh. Functions go lane by lane there.
#include <iostream>

#include "bench/ensemble_problems.hpp"
#include "odeum/api/ensemble.hpp"
#include "odeum/methods/dormand_prince54.hpp"
#include "odeum/methods/rk4.hpp"
#include "odeum/methods/rodas4.hpp"

namespace {

template <template <class> class P, class M, class How>
int others(M method, const How& how, double end, const odeum::State<P<double>>& start) {
  constexpr std::size_t count = 101;
  std::vector<P<double>> members(count);
  std::vector<odeum::State<P<double>>> together(count, start), alone;
  for (std::size_t k = 0; k < count; ++k) together[k][0] += 0.01 * static_cast<double>(k);
  alone = together;
  odeum::integrate_ensemble(members, method, together, 0, end, how);
  int different = 0;
  for (std::size_t k = 0; k < count; ++k) {
    odeum::integrate(members[k], method, alone[k], 0, end, how);
    different += together[k] != alone[k];
  }
  std::cout << M::info.id << ": " << different << " of " << count
            << " members differ from runs alone\n";
  return different;
}

}  // namespace

int main() {
  using namespace odeum;
  static_assert(Lanes::count == 2);
  const int different =
      others<bench::Lorenz>(methods::rk4{}, Step{0.01}, 1, {1, 2, 20}) +
      others<bench::Pendulum>(methods::rk4{}, Step{0.05}, 2, {1, 0.5}) +
      others<bench::Kepler>(methods::dormand_prince54{}, Tolerance{1e-6}, 2, {1, 0, 0, 0.8}) +
      others<bench::Robertson>(methods::rodas4{}, Tolerance{1e-6, 1e-10}, 40, {1, 0, 0});
  return different == 0 ? 0 : 1;
}
