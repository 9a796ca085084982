// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <vector>

#include "odeum/cases/case_text.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/solvers/lane_run.hpp"

namespace odeum::cases {

/// The problem of a family for members in lanes; for one thread.
struct FamilyInLanes {
  LaneFamily problem;  ///< without the code where there is no compiler
  /// Does what Family::place does; false where there is no code.
  std::function<bool(const std::vector<double>& values)> place;
};

/// The exact state at a time of the member with these values of all parameters; false where the
/// closed form does not hold for them. For one thread.
using MemberTruth = std::function<bool(const std::vector<double>& values, double t, double* y)>;

/// The values of the case's outputs for a state of the member with these values of all parameters.
/// For one thread.
using MemberOutputs =
    std::function<void(const std::vector<double>& values, double t, const double* y, double* out)>;

/// What Case::family is of a case of a problem file, whose code is compiled once with the
/// parameters as variables.
struct TextFamilies {
  TextSource source;

  /// None where no compiler is, and where values move the start, the end or the number of states,
  /// or masses.
  std::optional<Family> operator()(const std::vector<std::vector<double>>& samples) const;
  /// The family in lanes; only where there is a family.
  FamilyInLanes in_lanes() const;
  /// Empty where the file has no closed form.
  MemberTruth exact() const;
  MemberOutputs outputs() const;
};

}  // namespace odeum::cases
