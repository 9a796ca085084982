// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <memory>

#include "odeum/formula/text_ode.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/truth/along.hpp"

namespace odeum::cases {

/// The truth of a problem from text or in foreign code, in double and in extended precision.
struct TextTruth {
  Truth truth;
  std::function<bool(double t, long double* y)> extended;
  double extended_floor = 0;
  /// The problem's stops at which the truth is known; where it is known at none, the last time at
  /// which it is; empty: at no time.
  std::vector<double> stops;
  double known_until = 0;
  std::string words;  ///< for people: where it comes from and how many digits it has
};

/// A computed reference as truth of `what`.
TextTruth truth_from(truth::Reference computed, const std::vector<double>& stops,
                     const ErrorUnits& units, const std::string& what);

/// Leaves those stops of a case at which its truth is known, if there are any; `asked_end` keeps
/// where it was to end.
void cut_stops(Case& c, std::vector<double> known);

/// The truth of a problem with a closed form; `extended` too.
TextTruth closed_form(const formula::Problem& problem, const ErrorUnits& units = {});
/// What its components are along its solution, see truth::look_along; kept in the cache folder.
/// Null where that is not known.
std::shared_ptr<const truth::Along> along_of(const std::shared_ptr<const formula::TextOde>& ode);
/// Gives a truth the sizes along the solution.
void take_sizes(const truth::Along& along, Truth& truth);
/// A computed one, at the problem's stops as far as it is known. `along`: null where that is not
/// known. `foresee`, where it is given, adds to a new one that was cut short.
TextTruth truth_of(const std::shared_ptr<const formula::TextOde>& ode, const ErrorUnits& units = {},
                   const std::shared_ptr<const truth::Along>& along = nullptr,
                   const TruthBounds& bounds = {},
                   const std::function<void(truth::Reference&)>& foresee = {});

/// Whether the truth of a case of the problem is proved at its stops, as truth::to_text says it;
/// kept in the cache folder. Empty where Odeum was built without what proves it.
std::string proof_of(const formula::Problem& problem, const formula::Analysis& analysis,
                     const Case& c);

/// Adds that to the case's truth and its words. What is refuted of a computed truth is not claimed:
/// its errors are taken larger, until they are not refuted, or it is unknown.
void prove(const formula::Problem& problem, const formula::Analysis& analysis, Case& c,
           TextTruth& truth);

}  // namespace odeum::cases
