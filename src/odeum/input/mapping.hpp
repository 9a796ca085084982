// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "odeum/input/yaml_tree.hpp"

/// Checked values of a YAML tree, and mappings with a set of known keys. Errors name the place, the
/// path of the value, what was found and what is expected.
namespace odeum::input {

/// A file while its tree is read.
struct Reading {
  std::string file, format;                       ///< format: "scene", the name of the whole
  std::span<const std::string_view> unused = {};  ///< keys that get a warning, wherever they are
  std::vector<std::string> warnings = {};         ///< `file:line:column: key: message`

  void warn(Place place, const std::string& rest);
};

/// One key of a mapping with its value.
struct Entry {
  std::string key;
  Place key_place;
  const YamlNode* value;
};

/// The entry of a key; null: none.
const Entry* entry_of(const std::vector<Entry>& entries, std::string_view key);

using Keys = std::span<const std::string_view>;
enum class Sign { any, not_negative, positive };

/// A value and its path: `particles[3].pos`; the path of the root is empty.
class Value {
 public:
  Value(Reading& reading, const YamlNode& node, std::string key)
      : reading_(&reading), node_(&node), key_(std::move(key)) {}

  double number(Sign sign = Sign::any) const;
  /// A number, or one divided by another: 1/480.
  double quotient(Sign sign = Sign::any) const;
  std::uint64_t whole(std::uint64_t least, std::uint64_t most) const;
  bool boolean() const;
  std::string text() const;
  std::array<double, 3> vector() const;
  /// The elements of a list (nothing counts as an empty one); in paths they count from `first`.
  std::vector<Value> list(std::size_t first = 0) const;
  /// The elements of a list of exactly n.
  std::vector<Value> list_of(std::size_t n, const std::string& expected,
                             std::size_t first = 0) const;
  /// The entries of a mapping (nothing counts as an empty one), whose keys are unique scalars; none
  /// but the known ones where these are given.
  std::vector<Entry> entries(Keys known = {}) const;
  /// Fails where this is not a mapping, where a key is not text or stands twice, and for a key that
  /// is not known, if any is.
  void require_keys(Keys known) const;

  bool is_list() const { return node_->kind == YamlNode::Kind::sequence; }
  /// Throws `key: what; got X, expected Y`; without `what`: `key: got X, expected Y`.
  [[noreturn]] void fail(const std::string& what, const std::string& expected) const;
  [[noreturn]] void fail(const std::string& what, const std::string& got,
                         const std::string& expected) const;
  void warn(const std::string& what) const { reading_->warn(node_->place, key_ + ": " + what); }

  Reading& reading() const { return *reading_; }
  const YamlNode& node() const { return *node_; }
  const std::string& key() const { return key_; }
  Place place() const { return node_->place; }
  /// The path of what stands below a key.
  std::string path_of(std::string_view key) const;

 private:
  Reading* reading_;
  const YamlNode* node_;
  std::string key_;
};

/// A mapping with known keys: another key is an error, but those of Reading::unused get a warning.
class Mapping {
 public:
  Mapping(const Value& value, Keys known) : value_(value) { value.require_keys(known); }
  Mapping(const Value& value, std::initializer_list<std::string_view> known)
      : Mapping(value, Keys(known.begin(), known.size())) {}

  bool has(std::string_view key) const { return value_.node().find(key) != nullptr; }
  /// Throws where the key is missing.
  Value at(std::string_view key) const;
  void with(std::string_view key, const std::function<void(const Value&)>& use) const {
    if (has(key)) use(at(key));
  }
  double number_or(std::string_view key, Sign sign, double otherwise) const {
    return has(key) ? at(key).number(sign) : otherwise;
  }
  bool boolean_or(std::string_view key, bool otherwise) const {
    return has(key) ? at(key).boolean() : otherwise;
  }
  std::string text_or(std::string_view key, const std::string& otherwise) const {
    return has(key) ? at(key).text() : otherwise;
  }

  const Value& value() const { return value_; }

 private:
  Value value_;
};

}  // namespace odeum::input
