// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/foreseen.hpp"

#include <cmath>

namespace odeum::study {

// At a fixed step work grows in proportion to the steps; adaptive work as it did between the last
// settings. Linear systems are solved in fewer products at smaller steps, hence the quarter less.
double foreseen_work(const std::vector<Cost>& coarser, const Request& next) {
  if (coarser.empty()) return 0;
  const Cost& last = coarser.back();
  double growth = 1;
  if (next.mode == Mode::fixed) {
    growth = static_cast<double>(next.steps) / last.setting;
  } else if (coarser.size() > 1) {
    const Cost& before = coarser[coarser.size() - 2];
    const double rate = std::log(last.work / before.work) / std::log(last.setting / before.setting);
    growth = std::pow(1 / next.tolerance.relative / last.setting, rate);
  }
  return 0.75 * growth * last.work;
}

}  // namespace odeum::study
