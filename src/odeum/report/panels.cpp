// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/panels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

namespace odeum::report {
namespace {

using Solvers = std::vector<const SolverInfo*>;

// Orders for sorting: a varying one comes last.
double sortable(double order) { return std::isnan(order) ? 1e9 : order; }

std::string describe_orders(const Solvers& solvers) {
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

std::string describe_contents(const Solvers& solvers) {
  std::string families;
  std::set<std::string> named;
  for (const SolverInfo* solver : solvers)
    if (named.insert(solver->family).second)
      families += (families.empty() ? "" : ", ") + solver->family;
  std::replace(families.begin(), families.end(), '_', ' ');
  return families + "; " + describe_orders(solvers);
}

// Where a run of solvers that agree in `key` ends.
template <class Key>
Solvers::const_iterator run_end(Solvers::const_iterator begin, Solvers::const_iterator end,
                                Key key) {
  return std::find_if(begin, end, [&](const SolverInfo* s) { return key(s) != key(*begin); });
}

// Cuts one family into groups that fit a panel, of about equal size, between orders where it can.
std::vector<Solvers> cut_family(Solvers::const_iterator begin, Solvers::const_iterator end) {
  const auto total = static_cast<std::size_t>(end - begin);
  const std::size_t groups = (total + curves_per_panel - 1) / curves_per_panel;
  std::vector<Solvers> list(1);
  while (begin != end) {
    const auto order_end = run_end(begin, end, [](const auto* s) { return sortable(s->order); });
    const auto count = static_cast<std::size_t>(order_end - begin);
    const std::size_t pieces = (count + curves_per_panel - 1) / curves_per_panel;
    for (std::size_t piece = 0; piece < pieces; ++piece) {
      const std::size_t size = count * (piece + 1) / pieces - count * piece / pieces;
      const std::size_t held = list.back().size();
      if (held + size > curves_per_panel || held * groups >= total) list.emplace_back();
      list.back().insert(list.back().end(), begin, begin + static_cast<std::ptrdiff_t>(size));
      begin += static_cast<std::ptrdiff_t>(size);
    }
  }
  return list;
}

// Says which part it is where neighbours would read the same.
void number_parts(std::vector<Panel>& panels) {
  for (std::size_t first = 0; first < panels.size();) {
    std::size_t last = first + 1;
    while (last < panels.size() && panels[last].library == panels[first].library &&
           panels[last].contents == panels[first].contents)
      ++last;
    for (std::size_t i = first; last - first > 1 && i < last; ++i)
      panels[i].contents += fmt::format(" ({} of {})", i - first + 1, last - first);
    first = last;
  }
}

}  // namespace

std::vector<Panel> make_panels(const std::vector<SolverInfo>& solvers) {
  Solvers sorted;
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
  bool may_join = false;  // whole small families of a library share a panel
  for (auto next = sorted.cbegin(); next != sorted.cend();) {
    const auto end = run_end(next, sorted.cend(),
                             [](const auto* s) { return std::pair(s->library, s->family); });
    const std::vector<Solvers> groups = cut_family(next, end);
    const bool whole = groups.size() == 1;
    if (whole && may_join && panels.back().library == (*next)->library &&
        panels.back().solvers.size() + groups[0].size() <= curves_per_panel) {
      panels.back().solvers.insert(panels.back().solvers.end(), next, end);
    } else {
      for (const Solvers& group : groups)
        panels.push_back({.library = (*next)->library, .solvers = group});
    }
    may_join = whole;
    next = end;
  }
  for (Panel& panel : panels) panel.contents = describe_contents(panel.solvers);
  number_parts(panels);
  return panels;
}

}  // namespace odeum::report
