// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/input/mapping.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>

#include "odeum/input/near_words.hpp"

namespace odeum::input {
namespace {

/// A decimal number: sign, digits, point, exponent. `invalid_argument` for any other text, and
/// `result_out_of_range`, `value` unchanged, where a double does not hold it.
std::errc parse_decimal(std::string_view text, double& value) {
  if (text.starts_with("+-")) return std::errc::invalid_argument;
  if (text.starts_with('+')) text.remove_prefix(1);
  double number = 0;
  const char* const last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, number);
  // It takes inf and nan too.
  if (end != last || !std::isfinite(number)) return std::errc::invalid_argument;
  if (error == std::errc{}) value = number;
  return error;
}

std::string without_sign(const std::string& text) {
  return !text.empty() && (text[0] == '-' || text[0] == '+') ? text.substr(1) : text;
}

// 010 is 8 in YAML 1.1 and 10 in YAML 1.2.
bool has_octal_look(const std::string& text) {
  const std::string bare = without_sign(text);
  return bare.size() > 1 && bare[0] == '0' && bare[1] >= '0' && bare[1] <= '9';
}

bool has_decimal_comma(std::string text) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) return false;
  text[comma] = '.';
  double value = 0;
  return parse_decimal(text, value) != std::errc::invalid_argument;
}

bool is_not_finite(std::string text) {
  for (char& c : text) c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
  text = without_sign(text);
  if (!text.empty() && text[0] == '.') text.erase(0, 1);
  return text == "nan" || text == "inf" || text == "infinity";
}

}  // namespace

void Reading::warn(Place place, const std::string& rest) {
  warnings.push_back(fmt::format("{}:{}:{}: {}", file, place.line, place.column, rest));
}

const Entry* entry_of(const std::vector<Entry>& entries, std::string_view key) {
  const auto at =
      std::ranges::find_if(entries, [&](const Entry& entry) { return entry.key == key; });
  return at == entries.end() ? nullptr : &*at;
}

void Value::fail(const std::string& what, const std::string& expected) const {
  fail(what, node_->kind_name(), expected);
}

void Value::fail(const std::string& what, const std::string& got,
                 const std::string& expected) const {
  throw InputError(
      reading_->file, node_->place,
      fmt::format("{}: {}{}got {}, expected {}", key_.empty() ? reading_->format : key_, what,
                  what.empty() ? "" : "; ", got, expected));
}

double Value::number(Sign sign) const {
  const std::string expected = sign == Sign::any            ? "a number"
                               : sign == Sign::not_negative ? "a number that is not negative"
                                                            : "a positive number";
  if (node_->kind != YamlNode::Kind::scalar || node_->quoted) fail("not a number", expected);
  const std::string& text = node_->text;
  if (is_not_finite(text)) fail("not finite", "a finite number");
  if (has_decimal_comma(text)) fail("a decimal comma", "a number with a decimal point");
  double value = 0;
  const std::errc error = parse_decimal(text, value);
  if (error == std::errc::invalid_argument) fail("not a number", expected);
  if (has_octal_look(text))
    fail("a leading zero may make this an octal number in YAML", "a number without it");
  if (error != std::errc{})
    fail("beyond the range of doubles", "a number between 1e-308 and 1e308, or 0");
  if ((sign != Sign::any && value < 0) || (sign == Sign::positive && value == 0))
    fail(value < 0 ? "negative" : "zero", expected);
  return value;
}

double Value::quotient(Sign sign) const {
  const std::size_t slash = node_->text.find('/');
  if (node_->kind != YamlNode::Kind::scalar || node_->quoted || slash == std::string::npos)
    return number(sign);
  YamlNode above = *node_, below = *node_;
  const auto trimmed = [](std::string text) {
    text.erase(0, text.find_first_not_of(' '));
    text.erase(text.find_last_not_of(' ') + 1);
    return text;
  };
  above.text = trimmed(node_->text.substr(0, slash));
  below.text = trimmed(node_->text.substr(slash + 1));
  return Value(*reading_, above, key_).number(sign) /
         Value(*reading_, below, key_).number(Sign::positive);
}

std::uint64_t Value::whole(std::uint64_t least, std::uint64_t most) const {
  const std::string expected = fmt::format("a whole number from {} to {}", least, most);
  if (node_->kind != YamlNode::Kind::scalar || node_->quoted) fail("not a number", expected);
  const std::string& text = node_->text;
  if (double any = 0; parse_decimal(text, any) == std::errc::invalid_argument)
    fail("no whole number", expected);
  if (has_octal_look(text))
    fail("a leading zero makes this an octal number in YAML", "a number without it");
  if (text[0] == '-') fail("negative", expected);
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc{} && end != text.data() + text.size()) fail("no whole number", expected);
  if (error != std::errc{} || value < least || value > most) fail("out of range", expected);
  return value;
}

bool Value::boolean() const {
  const std::string& text = node_->text;
  if (node_->kind == YamlNode::Kind::scalar && !node_->quoted) {
    if (text == "true" || text == "True" || text == "TRUE") return true;
    if (text == "false" || text == "False" || text == "FALSE") return false;
  }
  fail("neither true nor false", "true or false");
}

std::string Value::text() const {
  if (node_->kind != YamlNode::Kind::scalar) fail("no text", "a text");
  return node_->text;
}

std::vector<Value> Value::list(std::size_t first) const {
  std::vector<Value> values;
  if (node_->kind == YamlNode::Kind::null) return values;
  if (!is_list()) fail("no list", "a list");
  for (std::size_t i = 0; i < node_->items.size(); ++i)
    values.emplace_back(*reading_, *node_->items[i], fmt::format("{}[{}]", key_, i + first));
  return values;
}

std::vector<Value> Value::list_of(std::size_t n, const std::string& expected,
                                  std::size_t first) const {
  if (!is_list() || node_->items.size() != n)
    fail(is_list() ? "a wrong number of entries" : "no list", expected);
  return list(first);
}

std::array<double, 3> Value::vector() const {
  std::array<double, 3> vector{};
  const auto components = list_of(3, "three numbers [x, y, z]");
  for (std::size_t d = 0; d < 3; ++d) vector[d] = components[d].number();
  return vector;
}

std::string Value::path_of(std::string_view key) const {
  return key_.empty() ? std::string(key) : fmt::format("{}.{}", key_, key);
}

void Value::require_keys(Keys known) const {
  if (node_->kind != YamlNode::Kind::mapping)
    fail("not a mapping", known.empty() ? "keys and values"
                                        : fmt::format("keys and values, as {{{}: ...}}", known[0]));
  const auto among = [](Keys keys, const std::string& key) {
    return std::ranges::find(keys, key) != keys.end();
  };
  std::map<std::string_view, std::size_t> lines;
  for (std::size_t i = 0; i + 1 < node_->items.size(); i += 2) {
    const YamlNode& key = *node_->items[i];
    const bool is_text = key.kind == YamlNode::Kind::scalar;
    const auto at = [&] { return Value(*reading_, key, path_of(is_text ? shown(key.text) : "?")); };
    if (!is_text) at().fail("a key that is not text", "a name");
    if (!known.empty() && !among(known, key.text)) {
      const std::vector<std::string> names(known.begin(), known.end());
      if (!among(reading_->unused, key.text))
        at().fail("an unknown key" + near_one(key.text, names), one_of(names));
      at().warn("only a viewer needs it; it is not used");
    }
    const auto [first, is_new] = lines.emplace(key.text, key.place.line);
    if (!is_new)
      at().fail(fmt::format("duplicate key; the first is in line {}", first->second), "it once");
  }
}

std::vector<Entry> Value::entries(Keys known) const {
  if (node_->kind == YamlNode::Kind::null) return {};
  require_keys(known);
  std::vector<Entry> all;
  for (std::size_t i = 0; i + 1 < node_->items.size(); i += 2)
    all.push_back({node_->items[i]->text, node_->items[i]->place, node_->items[i + 1].get()});
  return all;
}

Value Mapping::at(std::string_view key) const {
  const std::string path = value_.path_of(key);
  if (const YamlNode* node = value_.node().find(key)) return {value_.reading(), *node, path};
  Value(value_.reading(), value_.node(), path).fail("missing", "nothing", "a value");
}

}  // namespace odeum::input
