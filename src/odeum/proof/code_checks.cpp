// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/proof/code_checks.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "odeum/proof/stability_check.hpp"
#include "odeum/proof/structure_check.hpp"

namespace odeum::proof {
namespace {

template <class P>
std::string order_failure(const MakeStepper<P>& code, const MakeStepper<P>& original, double order,
                          const std::vector<Ground<P>>& where) {
  if (!code) return {};
  for (const Ground<P>& ground : where) {
    const study::OrderFit fit = measure_order(code, order, ground);
    if (fit.verdict == study::Verdict::confirmed) continue;
    // A method may be of higher order on one ground; then the mutant must differ from it.
    const study::OrderFit sound = measure_order(original, order, ground);
    if (sound.verdict == fit.verdict && std::abs(sound.order - fit.order) < 0.15) continue;
    return fmt::format("order on {}: {}", ground.id, study::to_string(fit.verdict));
  }
  return {};
}

MakeStepper<FunctionMechanics<false>> on_mechanics(const Code& code) {
  if (code.on_separable) return code.on_separable;
  if (!code.on_problem) return {};
  return [make = code.on_problem](const FunctionMechanics<false>& problem) { return make(problem); };
}

template <class P>
double difference_on(const MakeStepper<P>& one, const MakeStepper<P>& other,
                     const Ground<P>& ground) {
  if (!one || !other) return 0;
  const auto a = one(ground.problem), b = other(ground.problem);
  std::vector<double> y = ground.y0, z = ground.y0, error_y, error_z;
  const double h = 0.15;
  a->start(ground.t0, h, y);
  b->start(ground.t0, h, z);
  double difference = 0;
  for (int i = 0; i < 8; ++i) {
    const double t = ground.t0 + i * h;
    const Status first = a->step(t, h, y), second = b->step(t, h, z);
    if (first != second) return std::numeric_limits<double>::infinity();
    if (first != Status::ok) return difference;
    for (std::size_t k = 0; k < y.size(); ++k) {
      const double apart = std::abs(y[k] - z[k]);
      if (!(apart <= difference)) difference = apart;
    }
  }
  // The estimate is a result too.
  if (a->step(ground.t0, h, y, error_y) == Status::ok &&
      b->step(ground.t0, h, z, error_z) == Status::ok)
    for (std::size_t k = 0; k < y.size(); ++k)
      difference = std::max(difference, std::abs(error_y[k] - error_z[k]));
  return difference;
}

}  // namespace

std::string first_failure(const Code& code, const MethodFacts& original) {
  const double order = original.info.order;
  std::string failure = order_failure(code.on_problem, original.on_problem, order, grounds());
  if (failure.empty())
    failure = order_failure(code.on_separable, original.on_separable, order, separable_grounds());
  if (failure.empty())
    failure =
        order_failure(code.on_second_order, original.on_second_order, order, second_order_grounds());
  if (!failure.empty()) return failure;
  if (code.on_problem && original.info.one_step &&
      !(compare_stability(code.on_problem, original).difference <= stability_rounding))
    return "stability function";
  if (code.on_separable &&
      !(compare_oscillator_map(code.on_separable, original).difference <= stability_rounding))
    return "map of the oscillator";
  if (code.on_problem && original.tableau &&
      !(compare_with_tableau(code.on_problem, *original.tableau) <= tableau_rounding))
    return "interpreted tableau";
  const auto mechanics = on_mechanics(code);
  if (!mechanics) return {};
  constexpr double h = 0.4;
  if (symplectic_defect(original.on_mechanics(), h) <= symplectic_rounding &&
      !(symplectic_defect(mechanics, h) <= symplectic_rounding))
    return "symplectic form";
  if (return_defect(original.on_mechanics(), h) <= return_rounding &&
      !(return_defect(mechanics, h) <= return_rounding))
    return "return";
  return {};
}

double difference_between(const Code& one, const Code& other) {
  return std::max({difference_on(one.on_problem, other.on_problem, grounds().back()),
                   difference_on(one.on_separable, other.on_separable, separable_grounds().back()),
                   difference_on(one.on_second_order, other.on_second_order,
                                 second_order_grounds().back())});
}

}  // namespace odeum::proof
