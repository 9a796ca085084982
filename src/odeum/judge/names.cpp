// SPDX-License-Identifier: BSD-3-Clause
#include <cstddef>

#include "odeum/judge/answer.hpp"
#include "odeum/judge/order_fit.hpp"

namespace odeum::judge {
namespace {

/// The name of an enumerator, by the names of all up to `last` in their order; empty beyond it.
template <auto last, std::size_t count>
const char* name_of(decltype(last) value, const char* const (&names)[count]) {
  static_assert(count == static_cast<std::size_t>(last) + 1, "every enumerator has a name");
  const auto index = static_cast<std::size_t>(value);
  return index < count ? names[index] : "";
}

}  // namespace

const char* to_string(Answer answer) {
  return name_of<Answer::not_applicable>(
      answer, {"explained", "wrong", "undetermined", "none", "not_applicable"});
}

const char* to_string(Verdict verdict) {
  return name_of<Verdict::not_applicable>(verdict, {"confirmed", "higher", "lower", "floors",
                                                    "undetermined", "failed", "not_applicable"});
}

const char* to_string(NoOrder why) {
  return name_of<NoOrder::denied>(
      why, {"", "refused", "newton_failed", "step_too_small", "unstable", "over_budget",
            "budget_ends", "few_solved", "few_points", "wide_interval", "unsettled", "denied"});
}

}  // namespace odeum::judge
