// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "odeum/record/csv.hpp"
#include "odeum/studies/runner.hpp"
#include "odeum/sweep/members.hpp"
#include "odeum/sweep/quantity.hpp"

namespace odeum::sweep {

/// What there is of a member: a row without its parameters.
struct MemberRow {
  std::string solver = {}, status = "ok", detail = {};
  std::string answer = {};          ///< of a study, in a word, by which members are counted
  std::vector<double> values = {};  ///< by quantity; empty: none is known
  std::uint64_t evaluations = 0;
};

/// What is measured of a member in place of a run, see study.hpp.
struct MemberStudy {
  std::string name = {}, words = {};  ///< of the command that repeats it
  std::vector<Quantity> quantities = {};
  std::function<MemberRow(Case& member)> measure = {};
  bool timed = false;  ///< one member after the other
};

/// What to run: each member from the case's start to the last stop.
///
///     Plan plan(c, Members({axis_of("k=1..2:11")}, 0, 1));
///     plan.solver = "odeum/rk4";
///     plan.request.steps = 100, plan.request.stops = {c.stops.back()};
///     plan.quantities = quantities_of("x(end)", c);
///     const Result all = run(plan);
///
/// The case and the stores of `kept` belong to the caller and have to outlive it.
struct Plan {
  Plan(const Case& c, Members of) : base(&c), members(std::move(of)) {}

  const Case* base;
  std::string solver;                                  ///< library/method
  std::shared_ptr<const MemberStudy> study = nullptr;  ///< null: a run
  Request request;  ///< with stops between where a quantity needs them
  Members members;
  std::vector<Quantity> quantities;
  unsigned jobs = 1;  ///< threads
  /// Members that are held against a truth of their own, unless the error is a quantity.
  std::uint64_t checks = 100;
  double check_seconds = 20;     ///< of the clock, which the checks take at most
  study::ResultCache kept = {};  ///< where rows are kept; of a share only its rows are made
  /// For the quantiles of the components over time; without stops none are wanted.
  Request over_time = {};
};

/// The members that ended in one way.
struct Ending {
  std::uint64_t count = 0, first = 0;
  std::string detail;  ///< of the first
};

/// The least value, those at 5, 50 and 95 %, and the greatest.
using Quantiles = std::array<double, 5>;
/// The quantiles of the finite values; NaN where there is none.
Quantiles quantiles(std::vector<double> values);

/// The errors of members at the end, in the units of the case's errors.
struct Checks {
  bool all = false;                    ///< a closed form is the truth of each; else of some members
  std::uint64_t wanted = 0, made = 0;  ///< made: with a known truth
  double median = nan, largest = nan;
  std::uint64_t worst = 0;  ///< the member
};

struct Result {
  std::uint64_t size = 0, solved = 0, evaluations = 0;
  std::map<std::string, Ending> endings;  ///< by status, of a study by answer
  std::string csv;                        ///< members.csv
  std::vector<double> results;            ///< by member, one a quantity; NaN where it failed
  std::vector<Quantiles> quantiles;       ///< by quantity
  Checks checks;
  record::Records over_time;  ///< time, component, and its quantiles over some of the members
  std::uint64_t over_time_members = 0;
  bool one_code = false;  ///< parameters changed in place; false: a case was made for each member
  double seconds = 0;
};

/// Runs every member, on plan.jobs threads, those of a timed study on one; a member that fails is a
/// row with its status. Throws std::invalid_argument for a parameter that the case does not have,
/// study::ResultLost for a result that shards lack, and Interrupted.
Result run(const Plan& plan);

/// The values of all of the case's parameters for a member, in the order of Case::parameters.
std::vector<double> parameters_of(const Plan& plan, std::uint64_t member);
/// The k-th of `count` members that are evenly spread over all.
std::uint64_t spread(const Plan& plan, std::uint64_t k, std::uint64_t count);
/// The solver of that id. Throws std::invalid_argument where it does not fit, or there is none.
const Entrant& fitting(const Entrants& entrants, const std::string& solver);
/// ` --set a=1 --set b=2`: what makes a member of the problem.
std::string sets_of(const Plan& plan, std::uint64_t member);

}  // namespace odeum::sweep
