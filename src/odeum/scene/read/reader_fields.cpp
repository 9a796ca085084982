// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/read/reader_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <set>

#include "odeum/core/glob.hpp"

namespace odeum::scene::reading {
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

void Context::warn(Place place, const std::string& rest) {
  warnings.push_back(fmt::format("{}:{}:{}: {}", file, place.line, place.column, rest));
}

void Value::fail(const std::string& what, const std::string& expected) const {
  fail(what, node_->kind_name(), expected);
}

void Value::fail(const std::string& what, const std::string& got,
                 const std::string& expected) const {
  throw InputError(context_->file, node_->place,
                   fmt::format("{}: {}; got {}, expected {}", key_, what, got, expected));
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
    fail("a leading zero, which YAML may take as octal", "a number without it");
  if (error != std::errc{})
    fail("beyond the range of doubles", "a number between 1e-308 and 1e308, or 0");
  if ((sign != Sign::any && value < 0) || (sign == Sign::positive && value == 0))
    fail(value < 0 ? "negative" : "zero", expected);
  return value;
}

std::uint64_t Value::whole(std::uint64_t least, std::uint64_t most) const {
  const std::string expected = fmt::format("a whole number from {} to {}", least, most);
  if (node_->kind != YamlNode::Kind::scalar || node_->quoted) fail("not a number", expected);
  const std::string& text = node_->text;
  if (double any = 0; parse_decimal(text, any) == std::errc::invalid_argument)
    fail("no whole number", expected);
  if (has_octal_look(text))
    fail("a leading zero, which YAML takes as octal", "a number without it");
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

std::vector<Value> Value::list() const {
  std::vector<Value> values;
  if (node_->kind == YamlNode::Kind::null) return values;
  if (!is_list()) fail("no list", "a list");
  for (std::size_t i = 0; i < node_->items.size(); ++i)
    values.emplace_back(*context_, *node_->items[i], fmt::format("{}[{}]", key_, i));
  return values;
}

std::vector<Value> Value::list_of(std::size_t n, const char* expected) const {
  if (!is_list() || node_->items.size() != n)
    fail(is_list() ? "a wrong number of entries" : "no list", expected);
  return list();
}

Vec3 Value::vector() const {
  Vec3 vector{};
  const auto components = list_of(3, "three numbers [x, y, z]");
  for (std::size_t d = 0; d < 3; ++d) vector[d] = components[d].number();
  return vector;
}

Mapping::Mapping(const Value& value, std::initializer_list<std::string_view> known)
    : value_(value) {
  const YamlNode& node = value.node();
  if (node.kind != YamlNode::Kind::mapping) value.fail("no mapping", "keys and values");
  const std::vector<std::string> candidates(known.begin(), known.end());
  std::set<std::string_view> seen;
  for (std::size_t i = 0; i + 1 < node.items.size(); i += 2) {
    const YamlNode& key = *node.items[i];
    const auto at = [&](const std::string& name) {
      return Value(value.context(), key, value.key().empty() ? name : value.key() + "." + name);
    };
    if (key.kind != YamlNode::Kind::scalar) at("?").fail("a key that is not text", "a name");
    const bool is_known = std::find(known.begin(), known.end(), key.text) != known.end();
    const bool for_viewers = std::find(std::begin(viewer_keys), std::end(viewer_keys), key.text) !=
                             std::end(viewer_keys);
    if (!is_known && for_viewers) at(key.text).warn("only a viewer needs it; it is not used");
    if (!is_known && !for_viewers) {
      std::string list = fmt::format("{}", fmt::join(candidates, ", "));
      at(shown(key.text))
          .fail("an unknown key" + near_one(key.text, candidates),
                (candidates.size() > 1 ? "one of " : "") + list);
    }
    if (!seen.insert(key.text).second) at(key.text).fail("duplicate key", "each key once");
  }
}

Value Mapping::at(std::string_view key) const {
  const std::string name =
      value_.key().empty() ? std::string(key) : fmt::format("{}.{}", value_.key(), key);
  if (const YamlNode* node = value_.node().find(key)) return {value_.context(), *node, name};
  Value(value_.context(), value_.node(), name).fail("missing", "nothing", "a value");
}

void Mapping::with(std::string_view key, const std::function<void(const Value&)>& use) const {
  if (has(key)) use(at(key));
}

double Mapping::number_or(std::string_view key, Sign sign, double otherwise) const {
  return has(key) ? at(key).number(sign) : otherwise;
}

bool Mapping::boolean_or(std::string_view key, bool otherwise) const {
  return has(key) ? at(key).boolean() : otherwise;
}

double Mapping::damping() const {
  if (!has("damping")) return 0;
  const Value value = at("damping");
  const double damping = value.number();
  if (damping < 0 && !value.context().allow_negative_damping)
    value.warn("negative damping, which adds energy; allow_negative_damping: true silences");
  return damping;
}

bool Mapping::axial() const {
  if (!has("damping_model")) return true;
  const Value value = at("damping_model");
  const std::string model = value.text();
  if (model != "axial" && model != "full")
    value.fail("an unknown damping" + near_one(model, {"axial", "full"}), "axial or full");
  return model == "axial";
}

}  // namespace odeum::scene::reading
