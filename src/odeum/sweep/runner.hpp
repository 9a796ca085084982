// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include "odeum/cases/text_family.hpp"
#include "odeum/sweep/sweep.hpp"

namespace odeum::sweep {

/// Runs members one after the other, for one thread at a time.
class Runner {
 public:
  /// Without a family a case is made for each member.
  Runner(const Plan& plan, std::optional<Family> family);
  /// `refused` where the values make no problem, or the solver does not fit it.
  Outcome run(const std::vector<double>& values, const Request& request);
  /// The plan's study of a member; a row of values that make no problem says so.
  MemberRow measure(const std::vector<double>& values) const;
  /// The plan's request for members from `first` to `last` in lanes, where the solver, the problem
  /// and the request allow it; else nothing. One that is not ok has to run alone.
  std::vector<Outcome> run_in_lanes(std::uint64_t first, std::uint64_t last);
  /// The quantity for a successful outcome of the last member placed; `values` are its parameters.
  double value(const Quantity& quantity, const std::vector<double>& values, const Outcome& outcome);
  /// A member that did not run last.
  void place(const std::vector<double>& values) { family_->place(values); }
  const std::vector<double>& y0() const { return *y0_; }

 private:
  void use_lanes();
  /// The value of a component, an output or the energy for a state at t.
  double value_at(const Quantity& quantity, const std::vector<double>& values, double t,
                  const double* y);
  /// NaN where the closed form does not hold for the values.
  double error(const Quantity& quantity, const std::vector<double>& values, const double* last);

  const Plan& plan_;
  std::optional<Family> family_;
  std::optional<cases::FamilyInLanes> lanes_;
  LaneRun lane_run_ = nullptr;
  Case case_;                 ///< of the member that ran last, where there is no family
  cases::MemberTruth exact_;  ///< made where an error is asked for
  Case judged_;               ///< what an error by it needs
  std::function<double(const double*)> energy_;
  cases::MemberOutputs outputs_;  ///< made where an output of a text is asked for
  std::shared_ptr<const std::vector<double>> y0_;
};

/// The runners of several threads.
class Runners {
 public:
  explicit Runners(const Plan& plan);
  bool in_place() const { return in_place_; }
  /// One that is free, or a new one; it is free again when the pointer ends.
  std::shared_ptr<Runner> lend();

 private:
  const Plan& plan_;
  bool in_place_ = false;
  std::mutex mutex_;
  std::vector<std::unique_ptr<Runner>> free_;
};

/// Holds some members, evenly spread, against a truth of their own each (checks.cpp).
void check_members(const Plan& plan, Result& result);
/// The quantiles of every component at the plan's stops, over at most 500 members.
void add_over_time(const Plan& plan, Result& result);

}  // namespace odeum::sweep
