// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/order_class.hpp"

#include <algorithm>

namespace odeum::study {

const std::vector<OrderClass>& order_classes() {
  using judge::NoOrder;
  static const std::vector<OrderClass> all{
      {NoOrder::refused, "refused by the solver",
       "A solver that takes this problem: one that is given a dense Jacobian refuses a large "
       "number "
       "of unknowns, one with a band or sparse Jacobian, or without any, does not."},
      {NoOrder::over_budget, "over budget at every setting",
       "More evaluations, as the reason says. Where the case is stiff an explicit method needs "
       "them "
       "for stability alone, and an implicit one does not."},
      {NoOrder::newton_failed, "Newton's iteration does not converge",
       "A smaller step or a better first guess: an error at these steps says nothing of the "
       "order."},
      {NoOrder::step_too_small, "the step control asks for steps below rounding",
       "Nothing at these tolerances: the solution grows without bound in between, or the error "
       "estimate cannot be met; explicit methods on stiff cases end so."},
      {NoOrder::unstable, "unstable at every step tried",
       "Steps below the method's stability limit divided by the largest eigenvalue (page Largest "
       "stable step, and the view Stability, for the case), or an implicit method."},
      {NoOrder::budget_ends, "the budget ends before the order shows",
       "The number of evaluations that the reason names."},
      {NoOrder::few_solved, "too few steps are solved",
       "Finer steps: at the coarser ones the method is unstable, or does not converge."},
      {NoOrder::few_points, "rounding is reached after too few points",
       "Extended precision: the errors of a high order fall to rounding within a few settings."},
      {NoOrder::wide_interval, "the interval of the slope is too wide",
       "More settings between those run: errors scatter about the line."},
      {NoOrder::unsettled, "slopes have not settled",
       "Finer steps: the errors are not yet proportional to a power of the step. Where they are "
       "rounding by then, extended precision."},
      {NoOrder::denied, "a finer run denies the order",
       "Finer steps, or extended precision where the run denies it near rounding."}};
  return all;
}

const OrderClass* class_of(const judge::OrderFit& fit) {
  const auto found = std::find_if(order_classes().begin(), order_classes().end(),
                                  [&](const OrderClass& each) { return each.why == fit.why; });
  return found == order_classes().end() ? nullptr : &*found;
}

}  // namespace odeum::study
