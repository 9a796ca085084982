// SPDX-License-Identifier: BSD-3-Clause
#include <iterator>

#include "odeum/studies/cost/cost.hpp"

namespace odeum::study {
namespace {

constexpr std::size_t sides[] = {11, 32, 64, 128, 256, 512};
const Option largest_cloth =
    whole_number("most", sides[0], *std::rbegin(sides),
                 "particles along an edge of the largest cloth", *std::rbegin(sides));

// Own engines are not enrolled as solvers, so that a choice of solvers excludes them.
CostResult measure_cost(const Options& options, const Runner&) {
  CostResult result;
  if (!options.solvers.empty()) return result;
  const double most = options.number(largest_cloth);
  std::vector<std::size_t> measured(std::begin(sides), std::end(sides));
  std::erase_if(measured, [&](std::size_t side) { return static_cast<double>(side) > most; });
  result.cost = measure_cloth_cost(measured, 0.1);
  if (most >= timed_cloth_side)
    result.implicit_wins = measure_implicit_wins(timed_cloth_side, {10, 100, 1e3, 1e4, 1e5, 1e6},
                                                 {1.0 / 240, 1.0 / 120, 1.0 / 60, 1.0 / 30}, 0.03);
  return result;
}

}  // namespace

// It takes several seconds: a quick report shows the rows of an earlier one.
std::unique_ptr<Study> make_cost() {
  return make_study<CostResult>(
      {.name = "cost",
       .help = "what a step of a cloth costs a particle, and where implicit steps are faster",
       .place = 72,
       .cases_help = "",
       .options = {largest_cloth},
       .figures = {{"side", timed_cloth_side},
                   {"time", timed_cloth_time},
                   {"residual", timed_cloth_residual},
                   {"margin", timed_cloth_margin}}},
      {.measure = measure_cost});
}

}  // namespace odeum::study
