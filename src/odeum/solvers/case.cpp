// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/case.hpp"

#include <fmt/format.h>

namespace odeum {

Case::Case() = default;
Case::Case(const Case&) = default;
Case::Case(Case&&) noexcept = default;
Case& Case::operator=(const Case&) = default;
Case& Case::operator=(Case&&) noexcept = default;
Case::~Case() = default;

void complete(Case& c, const TruthBounds& bounds) {
  if (const auto compute = std::exchange(c.compute_truth, {})) compute(c, bounds);
}

std::vector<std::string> tags_of(const Case& c) {
  const Nature& is = c.nature;
  const std::pair<const char*, bool> words[] = {{"linear", is.linear},
                                                {"nonlinear", !is.linear},
                                                {"autonomous", is.autonomous},
                                                {"non_autonomous", !is.autonomous},
                                                {"kinked", is.highest_order == 2},
                                                {"kinked_4", is.highest_order == 4},
                                                {"smooth", is.smooth},
                                                {"stiff", is.stiff},
                                                {"chaotic", is.chaotic}};
  std::vector<std::string> all;
  for (const auto& [word, holds] : words)
    if (holds) all.emplace_back(word);
  for (const std::string& tag : c.tags)
    if (std::ranges::find(words, tag, [](const auto& word) { return word.first; }) ==
        std::end(words))
      all.push_back(tag);
  return all;
}

std::vector<std::string> component_names(const Case& c) {
  if (!c.components.empty()) return c.components;
  const bool second_order = c.problem.view.second_order();
  const std::size_t half = second_order ? c.y0.size() / 2 : c.y0.size();
  std::vector<std::string> names;
  for (std::size_t i = 0; i < c.y0.size(); ++i)
    names.push_back(fmt::format("{}{}", !second_order ? "y" : i < half ? "q" : "v", i % half));
  return names;
}

void set_tolerance(Request& request, const Case& c, double relative) {
  request.tolerance = c.tolerance.requested(relative);
}

}  // namespace odeum
