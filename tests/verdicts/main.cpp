// SPDX-License-Identifier: BSD-3-Clause
// Writes reports/measured/verdicts.csv to the standard output, see scripts/verdicts.
#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <future>

#include "accuracy/campaign.hpp"
#include "odeum/record/csv.hpp"

namespace odeum::tests {
namespace {

/// Trials by solver, then by case; those that do not fit have no reason and no points.
struct Campaign {
  std::vector<WrongSolver> solvers;
  std::vector<std::vector<Trial>> trials;
};

Campaign run_all(std::vector<WrongSolver> solvers) {
  const std::vector<Case>& cases = campaign_cases();
  Campaign campaign{std::move(solvers), {}};
  campaign.trials.assign(campaign.solvers.size(), std::vector<Trial>(cases.size()));
  const auto every_other = [&](std::size_t first) {
    for (std::size_t s = first; s < campaign.solvers.size(); s += 2) {
      for (std::size_t i = 0; i < cases.size(); ++i)
        if (campaign.solvers[s].fits(cases[i]))
          campaign.trials[s][i] = tried(campaign.solvers[s], cases[i]);
      std::fprintf(stderr, ".");
    }
  };
  const auto rest = std::async(std::launch::async, every_other, 1);
  every_other(0);
  rest.wait();
  return campaign;
}

void add_rows(record::Records& table, const Campaign& campaign, bool faulty) {
  const std::vector<Case>& cases = campaign_cases();
  for (std::size_t s = 0; s < campaign.solvers.size(); ++s)
    for (std::size_t i = 0; i < cases.size(); ++i) {
      const WrongSolver& solver = campaign.solvers[s];
      const Trial& trial = campaign.trials[s][i];
      if (!solver.fits(cases[i])) continue;
      table.rows.push_back(
          {solver.name, std::string(faulty ? "yes" : "no"), solver.claimed, cases[i].id,
           std::string(to_string(trial.fit.verdict)),
           std::isfinite(trial.fit.order) ? fmt::format("{:.2f}", trial.fit.order) : "nan",
           std::string(!faulty         ? ""
                       : trial.visible ? "yes"
                                       : "no")});
    }
}

void write_rows() {
  record::Records table{
      {"solver", "fault", "claimed_order", "case", "verdict", "measured_order", "fault_is_seen"}};
  add_rows(table, run_all(all_wrong()), true);
  add_rows(table, run_all(all_right()), false);
  fmt::print("{}", table.csv());
}

}  // namespace
}  // namespace odeum::tests

int main() {
  odeum::tests::write_rows();
  return 0;
}
