// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "odeum/accuracy/stepper.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/judge/stability_search.hpp"
#include "odeum/measure/growth_meter.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/record/table.hpp"
#include "odeum/studies/convergence/convergence.hpp"

namespace odeum::accuracy {
namespace {

enum Code { holds = 0, fails = 1, usage = 2, skipped = 77 };

/// For each solver the evaluations of its cheapest run below an error.
void print_costs(const study::ConvergenceResult& result) {
  record::Table table{.columns = {{"evaluations below an error of"}}, .rows = {}};
  constexpr double errors[] = {1e-2, 1e-4, 1e-6, 1e-8};
  for (const double error : errors) table.columns.push_back({fmt::format("{:.0e}", error), true});
  for (const study::OrderRow& row : result.orders) {
    const auto same = [&](const study::ConvergenceRow& run) {
      return run.library == row.library && run.solver == row.solver && run.mode == row.mode &&
             run.status == "ok";
    };
    table.rows.push_back({fmt::format("{}/{} {}", row.library, row.solver, to_string(row.mode))});
    for (const double error : errors) {
      std::uint64_t least = 0;
      for (const study::ConvergenceRow& run : result.rows)
        if (same(run) && run.error <= error && (least == 0 || run.counters.rhs_evaluations < least))
          least = run.counters.rhs_evaluations;
      table.rows.back().push_back(least == 0 ? "-" : std::to_string(least));
    }
  }
  fmt::print("{}", table.text());
}

/// Checks the order of the solver under test; the solvers of `beside` stand in the files and are
/// compared by cost.
int check_order(const std::string& case_id, const std::string& folder,
                const std::vector<std::string>& beside) {
  const Case& c = known_case(case_id);
  const Entrant& entrant = c.entrants.back();
  if (!entrant.unfit.empty()) {
    fmt::print("{}: not tested: {}\n", case_id, entrant.unfit);
    return skipped;
  }
  study::ConvergenceResult result = study::converge(
      {.cases = {case_id}, .solvers = {entrant.info.id()}, .own = {{"mode", "fixed"}}});
  const study::OrderRow row = result.orders.front();
  const std::vector<study::ConvergenceRow> runs = result.rows;
  if (!beside.empty()) {
    study::ConvergenceResult peers = study::converge({.cases = {case_id}, .solvers = beside});
    if (peers.orders.empty())
      throw std::invalid_argument(fmt::format("no solver is named {}", fmt::join(beside, ", ")));
    record::append(result, std::move(peers));
  }
  record::write(result, record::OutputFolder(folder));
  const judge::OrderFit& fit = row.fit;
  fmt::print("{}: claimed order {}, measured {:.3f} (95 %: {:.3f} to {:.3f}), {}{}{}\n", case_id,
             row.claimed_order, fit.order, fit.low, fit.high, judge::to_string(fit.verdict),
             fit.reason.empty() ? "" : ": ", fit.reason);
  fmt::print("{}", record::table_of(runs, "step:.6g error_max:.3e status").text());
  if (!beside.empty()) print_costs(result);
  fmt::print("the same rows are in {}/convergence.csv\n", folder);
  switch (fit.verdict) {
    case judge::Verdict::confirmed:
      return holds;
    case judge::Verdict::higher:  // without a number: the case is too easy to show the order
      return std::isnan(fit.order) ? skipped : fails;
    case judge::Verdict::undetermined:
    case judge::Verdict::over_budget:
    case judge::Verdict::not_applicable:
      return skipped;
    default:
      return fails;
  }
}

/// One unit of the last digit of a decimal: 0.01 for 2.78.
double last_digit(std::string_view text) {
  const std::size_t point = text.find('.');
  return point == std::string_view::npos
             ? 1
             : std::pow(10, -static_cast<double>(text.size() - point - 1));
}

int check_stability(const std::string& axis, const std::string& claimed) {
  double limit = 0;
  const auto read = std::from_chars(claimed.data(), claimed.data() + claimed.size(), limit);
  if ((axis != "real" && axis != "imaginary") || read.ec != std::errc() ||
      read.ptr != claimed.data() + claimed.size())
    throw std::invalid_argument("stability takes real or imaginary, and a number");
  const Probe probe = measure::case_with_plane("lambda").probe();
  measure::GrowthMeter meter(probe, probe.entrants.back(), false, measure::limit_length);
  const judge::LimitFound found = judge::find_limit(
      [&](double x) { return axis == "real" ? meter.measure(-x, 0) : meter.measure(0, x); });
  const bool right = std::abs(found.limit - limit) <= last_digit(claimed);
  fmt::print("stability limit on the {} axis: claimed {}, measured {:.6g}{}\n", axis, claimed,
             found.limit, right ? "" : ", which is another");
  return right ? holds : fails;
}

}  // namespace

int run(RuntimeLibrary library, int argc, char** argv) try {
  add_runtime_library(std::move(library));
  const std::vector<std::string> words(argv + 1, argv + argc);
  if (words.size() >= 3 && words[0] == "order")
    return check_order(words[1], words[2], {words.begin() + 3, words.end()});
  if (words.size() == 3 && words[0] == "stability") return check_stability(words[1], words[2]);
  fmt::print(stderr, "usage: {} order CASE FOLDER [SOLVER...] | stability real|imaginary LIMIT\n",
             argv[0]);
  return usage;
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return usage;
}

}  // namespace odeum::accuracy
