// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace odeum {

/// A place in a text, from 1; columns count characters.
struct Place {
  std::size_t line = 1, column = 1;
};

/// A file that cannot be used: `file:line:column: key: what is wrong; got X, expected Y`.
class InputError : public std::runtime_error {
 public:
  /// `rest` is all after the place.
  InputError(const std::string& file, Place place, const std::string& rest);
};

/// What was found, for an error: `text` on one line, without control characters, not too long.
std::string shown(std::string_view text);

/// The tree of a YAML document: what yaml-cpp's own nodes do not tell is kept (every key of a
/// mapping, quotes) and what could not be walked is refused (see parse_yaml).
struct YamlNode {
  enum class Kind { null, scalar, sequence, mapping };
  Kind kind = Kind::null;
  Place place;
  std::string text;     ///< of a scalar
  bool quoted = false;  ///< a scalar that is text whatever it looks like
  std::vector<std::shared_ptr<const YamlNode>>
      items;             ///< of a sequence; of a mapping key, value, ...
  std::size_t size = 1;  ///< nodes below and this one, where aliases count as what they stand for

  std::string kind_name() const;
};

/// What a YAML file is for, and how large it may be.
struct YamlFormat {
  std::string name;                ///< "scene", for sentences about the whole of it
  std::size_t depth = 32;          ///< levels of nesting
  std::size_t nodes = 20'000'000;  ///< with aliases written out
  bool aliases = true;             ///< whether it may have anchors and aliases
};

/// Parses one document. Throws InputError (with `file` for its text) for what is no YAML, no UTF-8
/// or binary, empty, more than one document, deeper or larger than the format allows once aliases
/// are written out, or an alias within what its anchor names; for tags.
std::shared_ptr<const YamlNode> parse_yaml(const std::string& file, const std::string& text,
                                           const YamlFormat& format);

}  // namespace odeum
