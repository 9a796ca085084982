// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "odeum/cases/case_text.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/cases/text_truth.hpp"
#include "odeum/formula/analysis.hpp"

namespace odeum::cases {
namespace {

class BuiltInCaseText : public CaseText {
 public:
  BuiltInCaseText(const BuiltInText& text, const std::string& id, const formula::Overrides& set)
      : CaseText("cases/" + text.stem + ".yaml", text.text, id, set) {}

  /// What makes the text's parameters those of the case.
  formula::Overrides changed(const Case& c) const {
    formula::Overrides set;
    for (const Parameter& parameter : c.parameters)
      if (static_cast<double>(problem_.parameters.at(parameter.name)) != parameter.value)
        set[parameter.name] = fmt::format("{:.21g}", parameter.value);
    return set;
  }
  std::string proof(const Case& c) {
    const formula::Analysis analysis = formula::analyse(problem_);
    return proof_of(problem_, analysis, c.truth, c.stops);
  }
};

}  // namespace

std::string with_proof(const Case& c) {
  const BuiltInText* const text = built_in_text_of(c.id);
  if (!text) return c.truth.source;
  const formula::Overrides set = BuiltInCaseText(*text, c.id, {}).changed(c);
  const std::string proof = BuiltInCaseText(*text, c.id, set).proof(c);
  return c.truth.source + (proof.empty() ? "" : "; ") + proof;
}

}  // namespace odeum::cases
