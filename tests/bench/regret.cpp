// SPDX-License-Identifier: BSD-3-Clause
#include "regret.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <functional>

#include "odeum/core/interrupt.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/record/csv.hpp"

namespace odeum::bench {
namespace {

/// The value that the share of them does not exceed.
double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  if (values.empty()) return nan;
  return values[static_cast<std::size_t>(std::ceil(share * static_cast<double>(values.size()))) -
                1];
}

Row row_of(const std::string& what, const std::vector<double>& values, double share, double goal,
           std::string note = {}) {
  return {.what = what,
          .goal = goal,
          .measured = quantile(values, share),
          .at_most = true,
          .note = std::move(note)};
}

/// What is done without a measurement: a solver, here at its best setting.
struct Policy {
  std::string what;
  std::function<std::string(const Regret&)> choose;  ///< key of Regret::others
};

/// As the documentation of suites with a default choice has it: by stiffness, then by the error
/// asked and the number of unknowns.
std::string by_rules(const Regret& regret) {
  constexpr std::size_t few = 50;
  if (!regret.stiff)
    return regret.error > 1e-5   ? "odeum/tsitouras54 --tol"
           : regret.error > 1e-8 ? "odeum/verner65 --tol"
                                 : "odeum/verner98 --tol";
  if (regret.states > few) return "cvode/bdf --tol";
  return regret.error > 1e-8 ? "odeum/rodas5p --tol" : "odeum/radau_iia9 --tol";
}

std::vector<Policy> policies(const std::string& best) {
  const auto always = [](const char* id) {
    return [id](const Regret&) { return std::string(id); };
  };
  const auto either = [](bool Regret::*which, const char* yes) {
    return [which, yes](const Regret& regret) {
      return std::string(regret.*which ? yes : "odeum/dormand_prince54 --tol");
    };
  };
  return {{"always a 5(4) pair", always("odeum/dormand_prince54 --tol")},
          {"cvode/bdf when stiff, else a 5(4) pair", either(&Regret::stiff, "cvode/bdf --tol")},
          {"velocity Verlet for scenes, else a 5(4) pair",
           either(&Regret::scene, "odeum/velocity_verlet --step")},
          {"default rules: stiffness, error, size", by_rules},
          {"the single best solver, " + best, [best](const Regret&) { return best; }},
          {"the switching method", always("odeum/dormand_prince54_rodas4 --tol")}};
}

std::string single_best(const std::vector<Regret>& all) {
  std::map<std::string, double> sums;
  // A question without an answer counts as a hundredfold time.
  for (const Regret& regret : all)
    for (const auto& [id, ratio] : regret.others) sums[id] += std::log(std::min(ratio / 100, 1.0));
  return std::min_element(sums.begin(), sums.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; })
      ->first;
}

}  // namespace

std::string Regret::question() const { return fmt::format("{} at {:g}", case_id, error); }

std::string Regret::text() const {
  if (!failure.empty()) return failure;
  return fmt::format("{} against {}, {:.3g} us", advised_id, best_id, 1e-3 * best_ns);
}

void write_regret(const std::vector<Regret>& all, const std::string& file) {
  record::Records table{{"case", "error_asked", "regret", "error_over_asked", "seconds", "advised",
                         "best", "best_us", "date", "processor", "instruction_set"}};
  const std::string date = utc_text(std::chrono::system_clock::now()).substr(0, 10);
  for (const Regret& each : all)
    table.rows.push_back({each.case_id, each.error, fmt::format("{:.3f}", each.advised),
                          fmt::format("{:.2f}", each.kept), fmt::format("{:.0f}", each.seconds),
                          each.advised_id, each.best_id, fmt::format("{:.3g}", 1e-3 * each.best_ns),
                          date, cpu_model(), compiled_for()});
  std::ofstream(file) << table.csv();
}

std::vector<Row> regret_rows(const std::vector<Regret>& all, std::size_t unanswered) {
  if (all.empty()) return {};
  std::vector<double> advised, kept;
  for (const Regret& regret : all) {
    advised.push_back(regret.advised);
    kept.push_back(regret.kept <= 1 ? 1 : 0);
  }
  const auto worst = std::max_element(all.begin(), all.end(), [](const Regret& a, const Regret& b) {
    return a.advised < b.advised;
  });
  const double share = static_cast<double>(std::count(kept.begin(), kept.end(), 1)) /
                       static_cast<double>(all.size());
  std::vector<Row> rows{
      row_of(fmt::format("regret of advise, median of {} questions", all.size()), advised, 0.5,
             1.05,
             fmt::format("{} more that nobody here answers{}", unanswered,
                         interrupted ? "; interrupted before all were asked" : "")),
      row_of("regret of advise, nine of ten", advised, 0.9, 1.2),
      row_of("regret of advise, the worst", advised, 1, 1.5,
             worst->question() + ": " + worst->text()),
      {.what = "share that keeps the error asked", .goal = 0.99, .measured = share, .unit = ""}};
  const std::string best = single_best(all);
  for (const Policy& policy : policies(best)) {
    std::vector<double> values;
    for (const Regret& regret : all) {
      const auto found = regret.others.find(policy.choose(regret));
      values.push_back(found == regret.others.end() ? infinity : found->second);
    }
    for (const double of : {0.5, 0.9, 1.0})
      rows.push_back(row_of(fmt::format("{}: {}", policy.what,
                                        of == 0.5   ? "median"
                                        : of == 0.9 ? "nine of ten"
                                                    : "the worst"),
                            values, of, nan));
  }
  return rows;
}

}  // namespace odeum::bench
