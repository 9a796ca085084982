// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/order_fit.hpp"

namespace odeum::judge {

const char* to_string(Verdict verdict) {
  switch (verdict) {
    case Verdict::confirmed:
      return "confirmed";
    case Verdict::higher:
      return "higher";
    case Verdict::lower:
      return "lower";
    case Verdict::floors:
      return "floors";
    case Verdict::undetermined:
      return "undetermined";
    case Verdict::failed:
      return "failed";
    case Verdict::not_applicable:
      return "not_applicable";
  }
  return "undetermined";
}

const char* to_string(NoOrder why) {
  switch (why) {
    case NoOrder::none:
      return "";
    case NoOrder::refused:
      return "refused";
    case NoOrder::newton_failed:
      return "newton_failed";
    case NoOrder::step_too_small:
      return "step_too_small";
    case NoOrder::unstable:
      return "unstable";
    case NoOrder::over_budget:
      return "over_budget";
    case NoOrder::budget_ends:
      return "budget_ends";
    case NoOrder::few_solved:
      return "few_solved";
    case NoOrder::few_points:
      return "few_points";
    case NoOrder::wide_interval:
      return "wide_interval";
    case NoOrder::unsettled:
      return "unsettled";
    case NoOrder::denied:
      return "denied";
  }
  return "";
}

}  // namespace odeum::judge
