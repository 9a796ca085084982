// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>

#include "odeum/formula/text_ode.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::cases {

/// The truth of a problem from text or in foreign code, in double and in extended precision.
struct TextTruth {
  Truth truth;
  std::function<bool(double t, long double* y)> extended;
  double extended_floor = 0;
  /// Those of the problem's stops at which the truth is known; where it is known at none, the last
  /// time at which it is; empty: at no time.
  std::vector<double> stops;
  double known_until = 0;
  std::string words;  ///< for people: where it comes from and how many digits it has
};

/// A computed reference as truth of `what`.
TextTruth truth_from(truth::Reference computed, const std::vector<double>& stops,
                     const std::vector<double>& scale, const std::string& what);

/// Leaves those stops of a case at which its truth is known, if there are any; `asked_end` keeps
/// where it was to end.
void cut_stops(Case& c, const std::vector<double>& known);

/// The truth of a problem with a closed form; `extended` too.
TextTruth closed_form(const formula::Problem& problem);
/// A computed one, at the problem's stops as far as it is known.
TextTruth truth_of(const std::shared_ptr<const formula::TextOde>& ode);

/// Whether a truth of the problem is proved at the stops, as truth::to_text says it; kept in the
/// cache folder. Empty where Odeum was built without what proves it.
std::string proof_of(const formula::Problem& problem, const formula::Analysis& analysis,
                     const Truth& truth, const std::vector<double>& stops);

}  // namespace odeum::cases
