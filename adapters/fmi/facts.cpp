// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "fmi/fmu.hpp"
#include "odeum/solvers/foreign_problem.hpp"

namespace odeum::adapters::fmi {
namespace {

/// "a = 1, b = 2" for the variables that are chosen and have no column of the inputs.
template <class Chosen>
std::string values_of(const Fmu& fmu, const Chosen& chosen) {
  std::vector<std::string> texts;
  for (const Variable& v : fmu.description.variables) {
    if (v.is_array || !chosen(v)) continue;
    if (fmu.inputs && std::ranges::any_of(fmu.inputs->columns(), [&](const Inputs::Column& column) {
          return column.variable.name == v.name;
        }))
      continue;
    const auto given = fmu.values.find(v.name);
    const std::string& value = given == fmu.values.end() ? v.start : given->second;
    texts.push_back(fmt::format("{} = {}", v.name, foreign::cleaned(value.c_str())));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// The first names, for people.
std::string first_of(const std::vector<std::string>& names) {
  const auto some = static_cast<std::ptrdiff_t>(std::min<std::size_t>(8, names.size()));
  return fmt::format("{}", fmt::join(names.begin(), names.begin() + some, ", "));
}

std::string events_in_words(const Fmu& fmu) {
  std::vector<std::string> kinds;
  if (fmu.indicators > 0)
    kinds.push_back(fmt::format("{} event indicator{}, located", fmu.indicators,
                                fmu.indicators == 1 ? "" : "s"));
  if (fmu.has_time_events) kinds.emplace_back("time events");
  if (fmu.inputs && std::isfinite(fmu.inputs->next_jump(fmu.description.t0)))
    kinds.emplace_back("jumps of inputs");
  if (fmu.description.acts_at_steps) kinds.emplace_back("those that it asks for at ends of steps");
  if (kinds.empty()) return {};
  return fmt::format("{}: runs are continued from one to the next", fmt::join(kinds, "; "));
}

}  // namespace

std::vector<std::string> names_of_states(const Description& d) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  if (d.has_arrays) return names;
  for (const std::size_t i : d.states.empty() ? d.outputs : d.states) {
    std::string name = d.variables[i].name;
    for (char& c : name)
      if (c == ',' || c == '"' || c == ' ') c = '_';
    while (!taken.insert(name).second) name += '_';
    names.push_back(name);
  }
  return names;
}

std::vector<double> nominal_sizes(const Description& d) {
  std::vector<double> sizes;
  bool any = false;
  for (const std::size_t i : d.states) {
    const double nominal = d.variables[i].nominal;
    sizes.push_back(nominal > 0 && std::isfinite(nominal) ? nominal : 1);
    any = any || sizes.back() != 1;
  }
  return any && !d.has_arrays ? sizes : std::vector<double>{};
}

std::vector<std::pair<std::string, std::string>> facts_of(const Fmu& fmu,
                                                          const std::vector<std::string>& names,
                                                          bool has_jacobian) {
  const Description& d = fmu.description;
  std::vector<std::pair<std::string, std::string>> facts;
  const auto add = [&](const char* name, std::string text) {
    if (!text.empty()) facts.emplace_back(name, std::move(text));
  };
  add("model", fmt::format("{} (FMI {}.0, Model Exchange)", d.model, d.version));
  add("set", values_of(fmu, [](const Variable& v) { return v.is_parameter; }));
  if (fmu.inputs) add("inputs", fmu.inputs->words());
  const std::string held = values_of(fmu, [](const Variable& v) { return v.is_input; });
  add("inputs", held.empty() ? "" : "held: " + held);
  if (fmu.has_states) {
    add("states", fmt::format("{}{}{}", fmu.y0.size(), names.empty() ? "" : ": ", first_of(names)));
  } else {
    add("states", "none; read at events and at stops are the outputs " + first_of(names));
    if (!d.unshown.empty())
      add("outputs", first_of(d.unshown) + ", which are not numbers, are not shown");
  }
  add("time", fmt::format("{} to {}{}", d.t0, d.stop,
                          d.stop_is_given ? "" : ", since the FMU names no end"));
  add("events", events_in_words(fmu));
  if (!fmu.has_states) return facts;
  add("found",
      fmu.non_autonomous ? "depends on time; df/dt by differences" : "does not depend on time");
  add("Jacobian", has_jacobian ? "the FMU's directional derivatives"
                               : "by differences: the FMU offers no derivatives");
  return facts;
}

}  // namespace odeum::adapters::fmi
