// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/foreseen.hpp"

#include <fmt/format.h>

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

void Foreseen::add(const Request& request, std::uint64_t work, double ns) {
  const double setting = fineness_of(request);
  work_.push_back({setting, static_cast<double>(work)});
  ns_.push_back({setting, ns});
}

std::string Foreseen::excess(const Request& next) const {
  const char* const because = "not run: by coarser settings it takes more than";
  if (work(next) > static_cast<double>(next.budget.evaluations))
    return fmt::format("{} {} evaluations and products", because, next.budget.evaluations);
  if (foreseen_work(ns_, next) > 1e9 * next.budget.seconds)
    return fmt::format("{} {} s", because, next.budget.seconds);
  return {};
}

}  // namespace odeum::study
