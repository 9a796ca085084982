// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace odeum::report {
namespace {

// Orders for sorting: a varying one comes last.
double sortable(double order) { return std::isnan(order) ? 1e9 : order; }

bool same_kind(const SolverInfo& a, const SolverInfo& b) {
  return a.family == b.family && sortable(a.order) == sortable(b.order);
}

std::string describe_orders(const std::vector<const SolverInfo*>& solvers) {
  std::set<double> orders;
  bool varies = false;
  for (const SolverInfo* solver : solvers)
    if (std::isnan(solver->order))
      varies = true;
    else
      orders.insert(solver->order);
  if (orders.empty()) return "variable order";
  std::string text = orders.size() == 1
                         ? fmt::format("order {:g}", *orders.begin())
                         : fmt::format("orders {:g} to {:g}", *orders.begin(), *orders.rbegin());
  return varies ? text + " and variable" : text;
}

std::string describe_contents(const std::vector<const SolverInfo*>& solvers) {
  std::string families;
  std::set<std::string> named;
  for (const SolverInfo* solver : solvers)
    if (named.insert(solver->family).second)
      families += (families.empty() ? "" : ", ") + solver->family;
  std::replace(families.begin(), families.end(), '_', ' ');
  return families + "; " + describe_orders(solvers);
}

}  // namespace

std::vector<Panel> make_panels(const std::vector<SolverInfo>& solvers) {
  std::vector<const SolverInfo*> sorted;
  std::vector<std::string> libraries;
  for (const SolverInfo& solver : solvers) {
    sorted.push_back(&solver);
    if (std::find(libraries.begin(), libraries.end(), solver.library) == libraries.end())
      libraries.push_back(solver.library);
  }
  const auto rank = [&](const SolverInfo* s) {
    return std::tuple(std::find(libraries.begin(), libraries.end(), s->library), s->family,
                      sortable(s->order));
  };
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](const auto* a, const auto* b) { return rank(a) < rank(b); });

  std::vector<Panel> panels;
  for (auto next = sorted.begin(); next != sorted.end();) {
    const SolverInfo& head = **next;
    const auto kind_end = std::find_if(next, sorted.end(), [&](const SolverInfo* s) {
      return s->library != head.library || !same_kind(*s, head);
    });
    const auto count = static_cast<std::size_t>(kind_end - next);
    if (panels.empty() || panels.back().library != head.library ||
        panels.back().solvers.size() + count > curves_per_panel)
      panels.push_back({.library = head.library});
    // A kind too large for one panel is cut into pieces of like size.
    const std::size_t pieces = (count + curves_per_panel - 1) / curves_per_panel;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      if (piece > 0) panels.push_back({.library = head.library});
      const std::size_t size = (count * (piece + 1)) / pieces - count * piece / pieces;
      panels.back().solvers.insert(panels.back().solvers.end(), next,
                                   next + static_cast<std::ptrdiff_t>(size));
      next += static_cast<std::ptrdiff_t>(size);
    }
  }
  for (Panel& panel : panels) panel.contents = describe_contents(panel.solvers);
  return panels;
}

}  // namespace odeum::report
