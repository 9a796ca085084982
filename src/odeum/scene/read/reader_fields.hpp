// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "odeum/scene/read/reader.hpp"

/// The parts of the scene reader: checked values, and mappings with a set of known keys.
namespace odeum::scene::reading {

/// The state of reading: file, limits, warnings.
struct Context {
  std::string file;
  ReadOptions options;
  Scene scene;
  std::vector<std::string> warnings;
  std::vector<Place> spring_places;  ///< of each spring of the scene
  bool allow_negative_damping = false;
  bool duration_given = true;

  void warn(Place place, const std::string& rest);
};

enum class Sign { any, not_negative, positive };

/// A value and its path: `particles[3].pos`.
class Value {
 public:
  Value(Context& context, const YamlNode& node, std::string key)
      : context_(&context), node_(&node), key_(std::move(key)) {}

  double number(Sign sign = Sign::any) const;
  std::uint64_t whole(std::uint64_t least, std::uint64_t most) const;
  bool boolean() const;
  std::string text() const;
  Vec3 vector() const;
  /// The elements of a list (nothing counts as an empty one).
  std::vector<Value> list() const;
  /// The elements of a list of exactly n.
  std::vector<Value> list_of(std::size_t n, const char* expected) const;

  bool is_list() const { return node_->kind == YamlNode::Kind::sequence; }
  [[noreturn]] void fail(const std::string& what, const std::string& expected) const;
  [[noreturn]] void fail(const std::string& what, const std::string& got,
                         const std::string& expected) const;
  void warn(const std::string& what) const { context_->warn(node_->place, key_ + ": " + what); }

  Context& context() const { return *context_; }
  const YamlNode& node() const { return *node_; }
  const std::string& key() const { return key_; }
  Place place() const { return node_->place; }

 private:
  Context* context_;
  const YamlNode* node_;
  std::string key_;
};

/// A mapping with known keys: a duplicate key is an error, and so is an unknown one, unless it is
/// one of those that only a viewer needs (viewer_keys), which gets a warning.
class Mapping {
 public:
  Mapping(const Value& value, std::initializer_list<std::string_view> known);

  bool has(std::string_view key) const { return value_.node().find(key) != nullptr; }
  /// Throws where the key is missing.
  Value at(std::string_view key) const;
  void with(std::string_view key, const std::function<void(const Value&)>& use) const;
  double number_or(std::string_view key, Sign sign, double otherwise) const;
  bool boolean_or(std::string_view key, bool otherwise) const;
  /// A damping: not negative, or a warning where the scene allows it.
  double damping() const;
  /// Whether the damping model is `axial`, the default, and not `full`.
  bool axial() const;

  const Value& value() const { return value_; }

 private:
  Value value_;
};

/// Keys for drawing that scene files of courses and viewers have; nothing physical is named so.
inline constexpr std::string_view viewer_keys[] = {
    "author", "background",   "camera", "color", "colour", "comment",        "description",
    "fps",    "ground_color", "label",  "light", "lights", "material_color", "opacity",
    "render", "resolution",   "show",   "title", "view",   "viewer",         "window"};

void read_particles(const Value& list);
void read_springs(const Value& list);
void read_cloths(const Value& list);
void read_forces(const Value& list);
void read_contacts(const Value& list);
void read_emitters(const Value& list);
void read_plot(const Value& value);
/// Checks the ends and appends a spring; a `rest_length` below 0 means the distance.
void add_spring(const Value& at, Spring spring, bool rest_length_given);
/// A mass within the limit of particles, for `more` of them; fails where there are too many.
void make_room(const Value& at, std::uint64_t more);

}  // namespace odeum::scene::reading
