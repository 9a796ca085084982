// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/order_reason.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "odeum/linear/dense_limit.hpp"

namespace odeum::study {
namespace {

using judge::NoOrder, judge::OrderFit, judge::Verdict;
using Rows = std::vector<const ConvergenceRow*>;

bool above_kinks(const Pair& pair) {
  return pair.entrant->info.order > pair.c->nature.highest_order;
}

/// On linear problems with constant coefficients: that to which the stability function is e^z,
/// which is above the order of a few methods. It is measured next to 0, above rounding.
double linear_order(const SolverInfo& info) {
  if (!info.amplification) return info.order;
  const auto apart = [&](double z) { return std::abs(info.amplification(z, 0) - std::exp(z)); };
  constexpr double z = -0.125, rounding = 1e-14;
  if (apart(z) < rounding) return info.order;
  return std::max(info.order, std::round(std::log2(apart(2 * z) / apart(z))) - 1);
}

bool over_budget(const ConvergenceRow* row) {
  return row->status == to_string(Status::over_budget);
}

NoOrder why_failed(const std::string& status) {
  constexpr std::pair<Status, NoOrder> known[] = {{Status::refused, NoOrder::refused},
                                                  {Status::newton_failed, NoOrder::newton_failed},
                                                  {Status::step_too_small, NoOrder::step_too_small},
                                                  {Status::non_finite, NoOrder::unstable},
                                                  {Status::ok, NoOrder::unstable}};
  for (const auto& [each, why] : known)
    if (status == to_string(each)) return why;
  return NoOrder::few_solved;
}

void explain_failure(const Pair& pair, const Rows& rows, OrderFit& fit) {
  const auto other = std::ranges::find_if_not(rows, over_budget);
  if (other == rows.end()) {
    // One over any budget did not begin.
    const bool begun = rows.front()->detail != dense_over_budget(pair.c->y0.size()).detail;
    fit.verdict = begun ? Verdict::over_budget : Verdict::not_applicable;
    fit.why = begun ? NoOrder::over_budget : NoOrder::none;
    fit.reason = begun ? "no run was solved within the budget: " : "";
    fit.reason += rows.front()->detail;
    return;
  }
  fit.why = why_failed((*other)->status);
  if (fit.why == NoOrder::unstable)
    for (const ConvergenceRow* row : rows)
      if (!over_budget(row)) fit.step_finest = std::fmin(fit.step_finest, row->step);
  fit.reason += (*other)->status == to_string(Status::ok)
                    ? ": unstable at all of them, with errors too large for a number"
                    : fmt::format(": {}, {}", (*other)->status, (*other)->detail);
}

void add_cost(const Pair& pair, const Rows& rows, const Foreseen& foreseen, OrderFit& fit) {
  const auto first = std::ranges::find_if(rows, over_budget);
  if (first == rows.end() || foreseen.empty()) return;
  Request next;
  next.mode = pair.mode;
  next.steps = (*first)->steps;
  next.tolerance = (*first)->setting;
  const double work = foreseen.work(next);
  fit.why = NoOrder::budget_ends;
  fit.reason += pair.mode == Mode::fixed
                    ? fmt::format("; {} steps take", next.steps)
                    : fmt::format("; a tolerance of {:.0e} takes", next.tolerance.relative);
  fit.reason += fmt::format(" about {:.1g} evaluations, more than the budget", work / 0.75);
}

constexpr OrderClass all_order_classes[] = {
    {NoOrder::refused, "refused by the solver",
     "A solver that takes this problem: one that is given a dense Jacobian refuses a large "
     "number of unknowns, one with a band or sparse Jacobian, or without any, does not."},
    {NoOrder::over_budget, "over budget at every setting",
     "More evaluations than the reason says: `odeum why` measures how far such a run comes, and "
     "what bounds its steps."},
    {NoOrder::newton_failed, "Newton's iteration does not converge",
     "A smaller step or a better first guess: an error at these steps says nothing of the "
     "order."},
    {NoOrder::step_too_small, "the step control asks for steps below rounding",
     "Nothing at these tolerances: the solution grows without bound in between, or the error "
     "estimate cannot be met."},
    {NoOrder::unstable, "unstable at every step tried",
     "Steps below the method's stability limit divided by the largest eigenvalue (page Largest "
     "stable step, and the view Stability, for the case)."},
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
     "Finer steps, or extended precision where the run denies it near rounding."},
    {NoOrder::rejections, "the step control rejects over a third of its tries",
     "A control that finds the steps which its estimate of the error allows."}};

}  // namespace

std::span<const OrderClass> order_classes() { return all_order_classes; }

double claimed_order(const Pair& pair) {
  const SolverInfo& info = pair.entrant->info;
  const bool varies = pair.mode == Mode::adaptive && info.adaptive_order;
  if (varies || above_kinks(pair)) return nan;
  const bool linear = pair.c->nature.linear && pair.c->nature.autonomous;
  return linear && pair.mode == Mode::fixed ? linear_order(info) : info.order;
}

void explain(const Pair& pair, const Rows& rows, const Foreseen& foreseen, OrderFit& fit) {
  if (fit.verdict == Verdict::failed) {
    explain_failure(pair, rows, fit);
  } else if (fit.verdict == Verdict::undetermined) {
    add_cost(pair, rows, foreseen, fit);
  } else if (fit.verdict == Verdict::not_applicable) {
    if (above_kinks(pair))
      fit.reason = fmt::format(
          "the right-hand side has kinks: a step across one errs by O(h^{0}), so that no method "
          "has an order above {0} on this case",
          pair.c->nature.highest_order);
  } else if (fit.verdict == Verdict::lower || fit.verdict == Verdict::floors) {
    const bool linearised = pair.entrant->info.family == "linearly_implicit";
    if (linearised && !pair.c->problem.view.jacobian)
      fit.reason +=
          "; the Jacobian is taken by differences, and its error of 1e-8 is one of the method's";
  }
}

}  // namespace odeum::study
