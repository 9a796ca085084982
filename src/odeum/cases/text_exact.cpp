// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <memory>

#include "odeum/cases/case_text.hpp"
#include "odeum/cases/text_family.hpp"
#include "odeum/formula/exact.hpp"

namespace odeum::cases {
namespace {

/// The closed form of a file's case for any values of its parameters.
class TextExact : CaseText {
 public:
  TextExact(const std::string& file, const std::string& text, const std::string& id,
            const formula::Overrides& set)
      : CaseText(file, text, id, set),
        named_(formula::read_problem(file, text, values_, formula::Parameters::names)) {
    if (!named_.exact.empty()) exact_.emplace(named_);
  }

  bool known() const { return exact_.has_value(); }

  bool operator()(const std::vector<double>& values, double t, double* y) {
    place(values, named_.parameters);
    exact_->define(formula::definitions_of(named_.graph, problem_.parameters));
    // A formula may hold for some values only, as one with a root does.
    const long double t0 = named_.t0, end = t;
    for (const long double at : {t0, t0 + (end - t0) * 0.4375L, end})
      if (exact_->flaw_at(at, t0, end)) return false;
    std::copy_n(exact_->state(), named_.states.size(), y);
    return true;
  }

 private:
  formula::Problem named_;
  std::optional<formula::Exact> exact_;
};

}  // namespace

MemberTruth TextFamilies::exact() const {
  const auto exact = std::make_shared<TextExact>(file_, text_, id_, set_);
  if (!exact->known()) return {};
  return [exact](const std::vector<double>& values, double t, double* y) {
    return (*exact)(values, t, y);
  };
}

}  // namespace odeum::cases
