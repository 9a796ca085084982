// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "odeum/core/error_units.hpp"
#include "odeum/formula/problem.hpp"

/// Digits of a truth that are proved: a solution is enclosed by ball arithmetic, whatever computed
/// the truth.
namespace odeum::truth {

/// A truth that is to be proved: its components are off by at most their floor, and half a unit in
/// their last place.
struct Claim {
  std::vector<double> times;  ///< ascending
  std::function<bool(double t, double* y)> at;
  std::vector<double> floors;  ///< by component, in its own unit
  ErrorUnits units;            ///< in which widths are said
};

struct Certificate {
  enum class Said {
    proved,   ///< all states that are claimed are within their error
    refuted,  ///< one is not
    agreed    ///< not proved, and not refuted as far as the enclosure went
  };
  Said said = Said::agreed;
  std::size_t proved = 0;  ///< how many of the times
  double time = 0;         ///< the last that is proved, or the one that is refuted
  double width = 0;        ///< of the enclosures up to it, the largest radius, in the units
  std::string why;         ///< not all of it is proved
};
/// A sentence that begins with the word.
std::string to_text(const Certificate& certificate);

/// Encloses the solution of the equations, with constants as they were read to 64 bits, by Taylor's
/// method with its remainder and the flow's derivative (R. Lohner, 1987), and compares. Gives up
/// where the problem has kinks or more than eight states, where the work, two seconds or so, is
/// spent, or the enclosure is wider than what is claimed. Nothing where Odeum was built without
/// arb.
std::optional<Certificate> certify(const formula::Problem& problem, const Claim& claim);

}  // namespace odeum::truth
