// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/order_class.hpp"

namespace odeum::study {
namespace {

constexpr std::string_view unstable = "unstable at every step tried";
constexpr std::string_view below_limit =
    "Steps below the method's stability limit divided by the largest eigenvalue (page Largest "
    "stable step, and the view Stability, for the case), or an implicit method.";

}  // namespace

const std::vector<OrderClass>& order_classes() {
  // A reason belongs to the first class whose mark it has. The texts are those of
  // judge/order_fit.cpp and pair_runs.cpp; the test OrderClass holds them against real runs.
  static const std::vector<OrderClass> all{
      {"needs a dense Jacobian", "no Jacobian of this size",
       "The adapter gives this solver a dense Jacobian, which the number of unknowns forbids: a "
       "solver with a band or sparse one, or without any."},
      {"within the budget", "over budget at every setting",
       "More evaluations, as the reason says. Where the case is stiff an explicit method needs "
       "them "
       "for stability alone, and an implicit one does not."},
      {"newton_failed", "Newton's iteration does not converge",
       "A smaller step or a better first guess: an error at these steps says nothing of the "
       "order."},
      {"step_too_small", "the step control asks for steps below rounding",
       "Nothing at these tolerances: the solution grows without bound in between, or the error "
       "estimate cannot be met; explicit methods on stiff cases end so."},
      {"non_finite", unstable, below_limit},
      {"unstable", unstable, below_limit},
      {"more than the budget", "the budget ends before the order shows",
       "The number of evaluations that the reason names."},
      {"are needed", "rounding is reached after too few points",
       "Extended precision: the errors of a high order fall to rounding within a few settings."},
      {"is known to lie in", "the interval of the slope is too wide",
       "More settings between those run: errors scatter about the line."},
      {"settle", "slopes have not settled",
       "Finer steps: the errors are not yet proportional to a power of the step."},
      {"what that predicts", "a finer run denies the order",
       "Finer steps, or extended precision where the run denies it near rounding."},
      {"", "other", "See the reason."}};
  return all;
}

const OrderClass* class_of(const judge::OrderFit& fit) {
  if (fit.verdict != judge::Verdict::failed && fit.verdict != judge::Verdict::undetermined)
    return nullptr;
  for (const OrderClass& each : order_classes())
    if (fit.reason.find(each.mark) != std::string::npos) return &each;
  return nullptr;
}

}  // namespace odeum::study
