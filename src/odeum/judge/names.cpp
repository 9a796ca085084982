// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/enum_names.hpp"
#include "odeum/judge/answer.hpp"
#include "odeum/judge/order_fit.hpp"

namespace odeum::judge {
const char* to_string(Answer answer) {
  return text_of_enumerator<Answer::not_applicable>(
      answer, {"explained", "wrong", "undetermined", "none", "not_applicable"});
}

const char* to_string(Verdict verdict) {
  return text_of_enumerator<Verdict::not_applicable>(
      verdict, {"confirmed", "higher", "lower", "floors", "undetermined", "failed", "over_budget",
                "not_applicable"});
}

const char* to_string(NoOrder why) {
  return text_of_enumerator<NoOrder::rejections>(
      why,
      {"", "refused", "newton_failed", "step_too_small", "unstable", "over_budget", "budget_ends",
       "few_solved", "few_points", "wide_interval", "unsettled", "denied", "rejections"});
}

}  // namespace odeum::judge
