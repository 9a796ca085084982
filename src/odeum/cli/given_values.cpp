// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <stdexcept>

#include "odeum/cli/run.hpp"

namespace odeum::cli {
namespace {

// The case with other values of some of its parameters. Throws UsageError.
Case changed(const Case& c, const Assignments& sets, const TruthBounds& bounds) {
  std::vector<std::string> names;
  std::vector<double> values;
  for (const Parameter& parameter : c.parameters) {
    names.push_back(parameter.name);
    values.push_back(parameter.value);
  }
  if (names.empty())
    throw UsageError(
        "--set: {} has no parameters; odeum list cases --parameters lists the cases that have",
        c.id);
  for (const auto& [name, value] : sets) {
    const auto at = std::ranges::find(names, name);
    if (at == names.end())
      throw UsageError("--set: {} has no parameter {}{}; expected one of {}", c.id, name,
                       did_you_mean(name, names), fmt::join(names, ", "));
    values[static_cast<std::size_t>(at - names.begin())] = value;
  }
  try {
    Case other = c.with_values(values, bounds);
    other.id = c.id;
    return other;
  } catch (const std::invalid_argument& error) {
    throw UsageError("--set: {}", error.what());
  }
}

}  // namespace

// The values of an option, in their order. Throws UsageError for a text other than NAME=NUMBER, a
// number that is not finite, and a name that is given twice.
Assignments assignments(const char* option, const std::vector<std::string>& texts) {
  Assignments sets;
  for (const std::string& text : texts) {
    const auto fail = [&](const char* what) {
      throw UsageError("{}: {}; got {}, expected NAME=NUMBER", option, what, shown(text));
    };
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) fail("no assignment");
    const std::string name = text.substr(0, equals);
    const char *begin = text.data() + equals + 1, *const end = text.data() + text.size();
    if (begin != end && *begin == '+') ++begin;
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || stop != end) fail("not a number");
    if (!std::isfinite(value)) fail("not finite");
    for (const auto& [other, unused] : sets)
      if (other == name) fail("given twice");
    sets.emplace_back(name, value);
  }
  return sets;
}

Case with_sets(const Case& c, const std::vector<std::string>& sets, const TruthBounds& bounds) {
  return sets.empty() ? c : changed(c, assignments("--set", sets), bounds);
}

// The values of --option, which the solver's library has to know.
std::map<std::string, double> library_options(const RunOptions& options, const SolverInfo& info) {
  std::map<std::string, double> values;
  for (const auto& [name, value] : assignments("--option", options.library_options)) {
    std::vector<std::string> names;
    for (const auto& known : info.options) names.push_back(known.first);
    if (std::ranges::find(names, name) == names.end())
      throw UsageError("--option: {} has no option {}{}", info.id(), name,
                       did_you_mean(name, names));
    values[name] = value;
  }
  return values;
}

formula::Overrides overrides_of(const std::vector<std::string>& sets) {
  formula::Overrides overrides;
  for (const std::string& set : sets) {
    const std::size_t equal = set.find('=');
    if (equal == std::string::npos || equal == 0 || equal + 1 == set.size())
      throw UsageError("--set: got {}, expected NAME=VALUE", shown(set));
    if (!overrides.emplace(set.substr(0, equal), set.substr(equal + 1)).second)
      throw UsageError("--set: {} is given twice", shown(set.substr(0, equal)));
  }
  return overrides;
}

std::string words_of(const std::vector<std::string>& sets, const CLI::App& command) {
  std::string words;
  for (const std::string& set : sets) words += " --set " + shell_word(set);
  for (const char* name : {"--case", "--inputs"})
    if (const auto* const given = command.get_option_no_throw(name); given && *given)
      words += fmt::format(" {} {}", name, shell_word(given->results().front()));
  for (const std::string& file : command.get_option("--plugin")->results())
    words += " --plugin " + shell_word(file);
  return words;
}

}  // namespace odeum::cli
