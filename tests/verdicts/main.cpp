// SPDX-License-Identifier: BSD-3-Clause
// Writes reports/verdicts.md to the standard output, see scripts/verdicts.
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <future>

#include "accuracy/campaign.hpp"

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

std::string cell(const WrongSolver& solver, const Trial& trial, const Case& c) {
  if (!solver.fits(c)) return "-";
  std::string text = to_string(trial.fit.verdict);
  if (std::isfinite(trial.fit.order)) text += fmt::format(" {:.2f}", trial.fit.order);
  const bool missed = trial.visible && !denies(trial.fit.verdict);
  return missed ? "**" + text + "** (seen)" : trial.visible ? text + " (seen)" : text;
}

void print_table(const Campaign& campaign) {
  const std::vector<Case>& cases = campaign_cases();
  std::string head = "| solver | claims |", rule = "|---|---|";
  for (const Case& c : cases) head += " " + c.id + " |", rule += "---|";
  fmt::print("{}\n{}\n", head, rule);
  for (std::size_t s = 0; s < campaign.solvers.size(); ++s) {
    fmt::print("| {} | {:g} |", campaign.solvers[s].name, campaign.solvers[s].claimed);
    for (std::size_t i = 0; i < cases.size(); ++i)
      fmt::print(" {} |", cell(campaign.solvers[s], campaign.trials[s][i], cases[i]));
    fmt::print("\n");
  }
}

/// How many trials have each verdict, of those whose fault can be seen, or cannot.
void print_counts(const Campaign& campaign, const char* what, bool wrong) {
  for (const bool seen : wrong ? std::vector<bool>{true, false} : std::vector<bool>{false}) {
    std::array<int, 7> counts{};
    int all = 0;
    for (std::size_t s = 0; s < campaign.solvers.size(); ++s)
      for (std::size_t i = 0; i < campaign_cases().size(); ++i) {
        const Trial& trial = campaign.trials[s][i];
        if (!campaign.solvers[s].fits(campaign_cases()[i]) || (wrong && trial.visible != seen))
          continue;
        ++counts[static_cast<std::size_t>(trial.fit.verdict)];
        ++all;
      }
    fmt::print("| {} | {} |",
               !wrong ? what
               : seen ? "a fault that is seen"
                      : "one that is not",
               all);
    for (std::size_t v = 0; v < 6; ++v) fmt::print(" {} |", counts[v]);
    fmt::print("\n");
  }
}

void write_report() {
  const Campaign wrong = run_all(all_wrong()), right = run_all(all_right());
  fmt::print(
      "# The judge on wrong and right solvers\n\n"
      "`scripts/verdicts` makes this page: {} solvers with a deliberate fault and {} without, each "
      "on {} problems with\nclosed solutions, through the study of convergence. A fault is *seen* "
      "where its errors, beside those of the same solver\nwithout the fault, grow or vary by four "
      "times over the finer half of the steps (ten times to a tolerance); one that\nis not is "
      "below the method's own error, or rounding, at every step. **Bold**: seen, and confirmed "
      "all the same. A wrong\ncontroller leaves the order in the mean step as it is: what it costs "
      "is another question, that of `odeum precision`.\n\n"
      "| | trials | confirmed | higher | lower | floors | undetermined | failed |\n"
      "|---|---|---|---|---|---|---|---|\n",
      wrong.solvers.size(), right.solvers.size(), campaign_cases().size());
  print_counts(wrong, "", true);
  print_counts(right, "without a fault", false);
  fmt::print("\n## With a fault\n\n");
  print_table(wrong);
  fmt::print("\n## Without\n\n");
  print_table(right);
}

}  // namespace
}  // namespace odeum::tests

int main() {
  odeum::tests::write_report();
  return 0;
}
