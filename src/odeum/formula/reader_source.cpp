// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <sstream>

#include "odeum/formula/reader.hpp"

namespace odeum::formula::reading {
namespace {

std::size_t characters(std::string_view text) {
  std::size_t count = 0;
  for (const char c : text) count += (static_cast<unsigned char>(c) & 0xc0U) != 0x80U;
  return count;
}

}  // namespace

Source::Source(const std::string& file, const std::string& text)
    : root_(parse_yaml(
          file, text,
          {.name = "problem", .depth = 8, .nodes = 1'000'000, .aliases = false, .indices = true})),
      reading_{.file = file, .format = "problem"} {
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines_.push_back(line);
  input::Value(reading_, *root_, "").require_keys({});
}

std::string Source::scalar(const YamlNode& value, const std::string& key) const {
  if (value.kind != YamlNode::Kind::scalar)
    fail(value.place, "{}: not an expression; got {}, expected one{}", key, value.kind_name(),
         value.kind == YamlNode::Kind::mapping ? " (quote it where it has a colon or { } around it)"
                                               : "");
  return value.text;
}

Place Source::place_in(const YamlNode& value, const std::string& text, std::size_t at) const {
  Place place = value.place;
  if (place.line > lines_.size()) return place;
  // A scalar on one line stands there as it is, after its quote, or some columns before, since the
  // library moves the mark of one whose key has brackets; of others only the start is known.
  constexpr std::size_t most = 10;
  const std::string& line = lines_[place.line - 1];
  std::size_t nearest = most + 1, column_of_text = 0;
  for (std::size_t from = line.find(text); from != std::string::npos;
       from = line.find(text, from + 1)) {
    const std::size_t column = characters(line.substr(0, from)) + 1;
    const std::size_t apart = column > place.column ? column - place.column : place.column - column;
    if (apart >= nearest) continue;
    nearest = apart;
    column_of_text = column;
  }
  if (nearest <= most) place.column = column_of_text + characters(text.substr(0, at));
  return place;
}

Id Reader::expression(const Item& item, const std::string& in, const Scope& scope,
                      bool* is_condition) {
  const std::string key = in.empty() ? item.key : in + ": " + item.key;
  const std::string text = scalar(*item.value, key);
  try {
    return is_condition ? parse_expression(text, scope, problem_.graph, *is_condition)
                        : parse_expression(text, scope, problem_.graph);
  } catch (const ExpressionError& error) {
    fail(place_in(*item.value, text, error.at()), "{}: {}", shown(key), error.what());
  }
}

Id Reader::constant(const YamlNode& value, const std::string& key) {
  const Id id = expression({key, value.place, &value}, "", constants_);
  if (!problem_.graph.is_constant(id))
    fail(value.place,
         "{}: not a constant; got an expression of states or t, expected numbers and parameters",
         key);
  return id;
}

std::int64_t Reader::index(const Item& item, std::string_view text) {
  try {
    return parse_index(text, constants_, problem_.graph);
  } catch (const ExpressionError& error) {
    fail(item.key_place, "{}: {}", shown(item.key), error.what());
  }
}

Key Reader::read_key(const Item& item, const std::string& in) {
  Key key{.name = item.key};
  const std::size_t open = item.key.find('[');
  if (open != std::string::npos) {
    key.indexed = true;
    key.name = item.key.substr(0, open);
    if (!item.key.ends_with(']'))
      fail(item.key_place, "{}: not a key; got {}, expected name[first..last]", in,
           shown(item.key));
    const std::string range = item.key.substr(open + 1, item.key.size() - open - 2);
    const std::size_t dots = range.find("..");
    if (range.find(',') != std::string::npos)
      fail(item.key_place, "{}: two indices; got {}, expected one", in, shown(item.key));
    key.first = index(item, range.substr(0, dots));
    key.last = dots == std::string::npos ? key.first : index(item, range.substr(dots + 2));
    if (key.last < key.first)
      fail(item.key_place, "{}: an empty range; got {}, expected first <= last", in,
           shown(item.key));
  }
  // With residuals, x' may be a state: the rate of another one.
  const std::string_view name = key.name;
  const std::size_t letters = section("residuals") ? name.find_last_not_of('\'') + 1 : name.size();
  if (const std::string fault = fault_of_name(name.substr(0, letters)); !fault.empty())
    fail(item.key_place, "{}: {}", in, fault);
  return key;
}

}  // namespace odeum::formula::reading
