// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/solver_groups.hpp"

#include <algorithm>

namespace odeum::report {
namespace {

constexpr std::size_t fewest_of_a_family = 3;

SolverGroup& group_of(std::vector<SolverGroup>& groups, const std::string& title, bool own) {
  const auto found = std::find_if(groups.begin(), groups.end(),
                                  [&](const SolverGroup& group) { return group.title == title; });
  if (found != groups.end()) return *found;
  return groups.emplace_back(SolverGroup{.title = title, .own = own});
}

}  // namespace

std::vector<SolverGroup> make_groups(const std::vector<SolverInfo>& solvers) {
  std::vector<SolverGroup> families, groups, peers;
  for (const SolverInfo& solver : solvers) {
    const bool own = solver.library == "odeum";
    std::string title = own ? solver.family : solver.library;
    if (own) std::replace(title.begin(), title.end(), '_', ' ');
    if (own && title.ends_with(" rk")) title.replace(title.size() - 2, 2, "RK");
    group_of(own ? families : peers, title, own).solvers.push_back(&solver);
  }
  std::stable_sort(families.begin(), families.end(), [](const auto& a, const auto& b) {
    return a.solvers.size() > b.solvers.size();
  });
  SolverGroup other{.title = "other", .own = true};
  for (SolverGroup& family : families)
    if (family.solvers.size() >= fewest_of_a_family)
      groups.push_back(std::move(family));
    else
      other.solvers.insert(other.solvers.end(), family.solvers.begin(), family.solvers.end());
  if (!other.solvers.empty()) groups.push_back(std::move(other));
  std::move(peers.begin(), peers.end(), std::back_inserter(groups));
  return groups;
}

}  // namespace odeum::report
