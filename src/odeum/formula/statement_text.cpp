// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/statement_text.hpp"

#include <fmt/format.h>

#include <map>
#include <stdexcept>
#include <utility>

#include "odeum/formula/names.hpp"

namespace odeum::formula {
namespace {

/// As a scalar in quotes.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
  }
  return result + '"';
}

std::string entry(const std::string& key, const std::string& value) {
  return fmt::format("  {}: {}\n", quoted(key), quoted(value));
}

/// The names in an expression.
std::set<std::string> names_in(const std::string& text) {
  std::set<std::string> names;
  for (std::size_t k = 0; k < text.size();) {
    const std::size_t begin = k;
    while (k < text.size() && continues_name(text[k])) ++k;
    if (k > begin && begins_name(text[begin])) names.insert(text.substr(begin, k - begin));
    if (k == begin) ++k;
  }
  return names;
}

}  // namespace

std::string StatementText::new_name(const std::string& wished) {
  // The columns of a run's files have these names.
  static const std::set<std::string> columns{"schema", "case",   "library", "solver",
                                             "time",   "energy", "error",   "i"};
  constexpr std::size_t longest = 50;
  std::string name = wished.substr(0, longest);
  // A damaged file may name anything.
  for (char& c : name)
    if (!continues_name(c)) c = '_';
  if (name.empty() || !begins_name(name[0])) name.insert(0, "n");
  while (columns.contains(name) || !fault_of_name(name).empty()) name += '_';
  const std::string first = name;
  for (int k = 2; !names_.insert(name).second; ++k) name = fmt::format("{}_{}", first, k);
  return name;
}

std::string StatementText::in_order(const Entries& all) {
  std::map<std::string, std::size_t> at;
  for (std::size_t k = 0; k < all.size(); ++k) at[all[k].first] = k;
  enum class Mark { none, open, written };
  std::vector<Mark> marks(all.size(), Mark::none);
  std::string text;
  const auto write = [&](const auto& self, std::size_t k) -> void {
    if (marks[k] == Mark::written) return;
    if (marks[k] == Mark::open)
      throw std::invalid_argument(fmt::format("a cycle of rules, with {} in it", all[k].first));
    marks[k] = Mark::open;
    for (const std::string& name : names_in(all[k].second))
      if (const auto needed = at.find(name); needed != at.end()) self(self, needed->second);
    marks[k] = Mark::written;
    text += entry(all[k].first, all[k].second);
  };
  for (std::size_t k = 0; k < all.size(); ++k) write(write, k);
  return text;
}

std::string StatementText::text(double end) const {
  std::string text = "name: " + quoted(title_) + "\n";
  const auto section = [&text](const char* name, const std::string& entries) {
    if (!entries.empty()) text += fmt::format("{}:\n{}", name, entries);
  };
  const auto joined = [](const Entries& all, const char* before = "") {
    std::string lines;
    for (const auto& [key, value] : all) lines += before + entry(key, value);
    return lines;
  };
  section("parameters", in_order(parameters_));
  section("definitions", in_order(definitions_));
  section("states", joined(states_));
  section("equations", joined(equations_));
  section("reactions", joined(reactions_, "  -"));
  std::string events;
  for (const auto& [keys, set] : events_) {
    const char* before = "  - ";
    for (const auto& [key, value] : keys)
      events +=
          fmt::format("{}{}: {}\n", std::exchange(before, "    "), quoted(key), quoted(value));
    events += "    \"set\":\n";
    for (const auto& [name, value] : set) events += "    " + entry(name, value);
  }
  section("events", events);
  std::set<std::string> columns;
  for (const auto& [name, start] : states_) columns.insert(name);
  Entries outputs;
  for (const auto& each : outputs_)
    if (columns.insert(each.first).second) outputs.push_back(each);
  section("outputs", joined(outputs));
  return text + fmt::format("time: {{end: {}}}\n", end);
}

}  // namespace odeum::formula
