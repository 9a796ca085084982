// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "odeum/formula/problem.hpp"
#include "odeum/solvers/case.hpp"
#include "odeum/solvers/lane_run.hpp"

namespace odeum::cases {

/// The problem of a family for members in lanes; for one thread.
struct FamilyInLanes {
  LaneFamily problem;  ///< without the code where there is no compiler
  /// As Family::place; false where there is no code.
  std::function<bool(const std::vector<double>& values)> place;
};

/// The exact state at a time of the member with these values of all parameters; false where the
/// closed form does not hold for them. For one thread.
using MemberTruth = std::function<bool(const std::vector<double>& values, double t, double* y)>;

/// What Case::family is of the case `id` of a problem file, whose code is compiled once with the
/// parameters as variables.
class TextFamilies {
 public:
  TextFamilies(std::string file, std::string text, std::string id, formula::Overrides set);
  /// None where no compiler is, and where values move the start, the end or the number of states,
  /// or masses.
  std::optional<Family> operator()(const std::vector<std::vector<double>>& samples) const;
  /// Where there is a family.
  FamilyInLanes in_lanes() const;
  /// Empty where the file has no closed form.
  MemberTruth exact() const;

 private:
  std::string file_, text_, id_;
  formula::Overrides set_;
};

}  // namespace odeum::cases
