// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/quantity.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "odeum/cases/text_family.hpp"
#include "odeum/input/near_words.hpp"

namespace odeum::sweep {
namespace {

Quantity quantity_of(const std::string& word, const Case& c) {
  const auto fail = [&](const std::string& what) {
    throw std::invalid_argument(
        fmt::format("{}; got {}, expected max(X), min(X), X(end), error(X) or energy", what, word));
  };
  if (word == "energy") {
    if (!c.energy) fail("the problem has no energy");
    return {.name = word, .kind = Quantity::Kind::energy};
  }
  const std::size_t open = word.find('(');
  if (open == std::string::npos || !word.ends_with(')')) fail("no quantity");
  const std::string before = word.substr(0, open),
                    within = word.substr(open + 1, word.size() - open - 2);
  Quantity quantity{.name = word};
  std::string component = within;
  if (before == "max" || before == "min") {
    quantity.kind = before == "max" ? Quantity::Kind::greatest : Quantity::Kind::least;
  } else if (before == "error") {
    quantity.kind = Quantity::Kind::error_of;
    if (!error_of_members(c)) fail("the truth of the members is not a closed form");
  } else {
    if (within != "end") fail("no quantity");
    component = before;
  }
  std::vector<std::string> names = component_names(c);
  const std::size_t states = names.size();
  names.insert(names.end(), c.outputs.names.begin(), c.outputs.names.end());
  const auto at = std::ranges::find(names, component);
  if (at == names.end())
    fail(fmt::format("no component {}{}, the problem has {}", component, near_one(component, names),
                     fmt::join(names.begin(),
                               names.begin() + static_cast<std::ptrdiff_t>(
                                                   std::min<std::size_t>(names.size(), 12)),
                               ", ")));
  quantity.component = static_cast<std::size_t>(at - names.begin());
  quantity.is_output = quantity.component >= states;
  if (quantity.is_output) quantity.component -= states;
  return quantity;
}

}  // namespace

std::optional<Quantity> error_of_members(const Case& c) {
  const auto* const text = c.family.target<cases::TextFamilies>();
  const bool known = text ? static_cast<bool>(text->exact()) : c.truth.closed_form;
  if (!known) return std::nullopt;
  return Quantity{.name = "error", .kind = Quantity::Kind::error};
}

std::vector<Quantity> quantities_of(const std::string& text, const Case& c) {
  std::vector<Quantity> all;
  if (text.empty()) {
    const std::vector<std::string> names = component_names(c);
    for (std::size_t i = 0; i < names.size(); ++i)
      all.push_back({.name = names[i], .component = i});
    return all;
  }
  // Not at commas within parentheses: components have names such as u[1].
  std::string word;
  int depth = 0;
  for (const char letter : text + ',') {
    depth += letter == '(' ? 1 : letter == ')' ? -1 : 0;
    if (letter == ',' && depth <= 0) {
      all.push_back(quantity_of(word, c));
      word.clear();
    } else if (letter != ' ') {
      word += letter;
    }
  }
  if (!word.empty()) all.push_back(quantity_of(word, c));
  return all;
}

}  // namespace odeum::sweep
