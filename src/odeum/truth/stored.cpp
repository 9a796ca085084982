// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <iterator>
#include <sstream>

#include "odeum/core/build_info.hpp"
#include "odeum/formula/cache.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::truth {
namespace {

constexpr const char* mark = "odeum computed reference 3";

// Reads numbers up to the end of a line.
template <class Number>
bool read(std::string_view& rest, Number& value) {
  while (!rest.empty() && rest.front() == ' ') rest.remove_prefix(1);
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  if (error != std::errc{}) return false;
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  return true;
}

}  // namespace

std::string to_text(const Reference& r) {
  std::string text = fmt::format("{}\n{}\n{}\n{} {} {} {}\n", mark, r.methods, r.end, r.known_until,
                                 r.ends_at, r.disagreement, r.times.size());
  for (std::size_t k = 0; k < r.times.size(); ++k) {
    fmt::format_to(std::back_inserter(text), "{} {}", r.times[k], fmt::join(r.floors[k], " "));
    for (const Real x : r.states[k]) fmt::format_to(std::back_inserter(text), " {:.21Lg}", x);
    text += '\n';
  }
  return text + "end\n";
}

std::optional<Reference> from_text(const std::string& text, std::size_t states) {
  std::istringstream in(text);
  Reference r;
  std::string line;
  std::size_t count = 0;
  if (!std::getline(in, line) || line != mark || !std::getline(in, r.methods) ||
      !std::getline(in, r.end) || !std::getline(in, line))
    return std::nullopt;
  std::string_view rest = line;
  if (!read(rest, r.known_until) || !read(rest, r.ends_at) || !read(rest, r.disagreement) ||
      !read(rest, count) || count > 100'000)
    return std::nullopt;
  for (std::size_t k = 0; k < count; ++k) {
    if (!std::getline(in, line)) return std::nullopt;
    rest = line;
    double time = 0;
    if (!read(rest, time)) return std::nullopt;
    std::vector<double> floors(states);
    State state(states);
    for (double& floor : floors)
      if (!read(rest, floor)) return std::nullopt;
    for (Real& x : state)
      if (!read(rest, x)) return std::nullopt;
    if (!rest.empty()) return std::nullopt;
    r.times.push_back(time);
    r.floors.push_back(std::move(floors));
    r.states.push_back(std::move(state));
  }
  if (!std::getline(in, line) || line != "end") return std::nullopt;
  return r;
}

std::optional<Reference> kept_or_computed(
    std::string content, std::size_t states, const std::vector<double>& stops,
    const ErrorUnits& units, const TruthBounds& bounds,
    const std::function<std::optional<Reference>()>& compute) {
  content += fmt::format("\n{}\n{} {} {}", build::truth_code, fmt::join(stops, " "),
                         fmt::join(units.scale, " "), fmt::join(units.relative_from, " "));
  std::string name = formula::content_key(content) + ".reference";
  const auto held = [&]() -> std::optional<Reference> {
    const auto text = formula::kept_text(name);
    return text ? from_text(*text, states) : std::nullopt;
  };
  if (auto finest = held()) return finest;
  if (bounds.error > 0) {
    name = formula::content_key(content + fmt::format("\n{}", bounds.error)) + ".reference";
    if (auto enough = held()) return enough;
  }
  std::optional<Reference> reference = compute();
  if (reference && !is_past(bounds.until)) formula::keep_text(name, to_text(*reference));
  return reference;
}

}  // namespace odeum::truth
