// SPDX-License-Identifier: BSD-3-Clause
#include <odeum/api/integrate.hpp>
#include <odeum/methods/dormand_prince54.hpp>
#include <odeum/methods/rodas4.hpp>
#include <odeum/methods/verner98.hpp>

#include "pendulum.hpp"

template <class Method>
bool keeps_energy_everywhere(double tolerance, double drift) {
  std::vector<double> times;
  for (int i = 0; i <= 1000; ++i) times.push_back(0.02 * i);
  std::array<double, 2> y{1, 0};
  double worst = 0;
  std::size_t asked = 0;
  const auto look = [&](double, const auto& state) {
    ++asked;
    worst = std::max(worst, std::abs(Pendulum::energy(state) + std::cos(1.0)));
  };
  const odeum::RunEnd run = odeum::integrate(
      Pendulum{}, Method{}, y, 0, 20, odeum::Tolerance{tolerance}, odeum::at_times(times, look));
  std::array<double, 2> alone{1, 0};
  const odeum::RunEnd undisturbed =
      odeum::integrate(Pendulum{}, Method{}, alone, 0, 20, odeum::Tolerance{tolerance});
  // The output steers no step, and is as accurate between the steps as at their ends.
  return run.steps == undisturbed.steps && y == alone && asked == 1001 && worst < drift;
}

/// y' = -1e6 (y - cos t) - sin t, y = cos t: f magnifies an error of y a million times, so that
/// slopes at the ends of a step tell nothing of the states between them.
struct Stiff {
  static constexpr std::size_t dimension = 1;
  void rhs(double t, const double* y, double* dydt) const {
    dydt[0] = -1e6 * (y[0] - std::cos(t)) - std::sin(t);
  }
};

bool follows_a_stiff_solution() {
  std::vector<double> times;
  for (int i = 0; i < 1000; ++i) times.push_back(0.003 + 0.01 * i);
  std::array<double, 1> y{1};
  double worst = 0;
  const auto look = [&](double t, const auto& state) {
    worst = std::max(worst, std::abs(state[0] - std::cos(t)));
  };
  const odeum::RunEnd run = odeum::integrate(Stiff{}, odeum::methods::rodas4{}, y, 0, 10,
                                             odeum::Tolerance{1e-6}, odeum::at_times(times, look));
  return run.ok() && worst < 1e-5;
}

int main() {
  using namespace odeum::methods;
  if (!follows_a_stiff_solution()) return 1;
  return keeps_energy_everywhere<dormand_prince54>(1e-8, 1e-6) &&
                 keeps_energy_everywhere<verner98>(1e-12, 1e-10)
             ? 0
             : 1;
}
