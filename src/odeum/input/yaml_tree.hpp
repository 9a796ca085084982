// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace odeum {

/// A place in a text, from 1; columns count characters.
struct Place {
  std::size_t line = 1, column = 1;
};

/// A file that cannot be used: `file:line:column: key: what is wrong; got X, expected Y`. Values of
/// parameters for which a file makes no problem are an invalid argument, however they are found.
class InputError : public std::invalid_argument {
 public:
  /// `rest` is all after the place.
  InputError(const std::string& file, Place place, const std::string& rest);
  /// The whole text.
  explicit InputError(const std::string& text) : std::invalid_argument(text) {}
};

/// What was found, for an error: `text` on one line, without control characters, not too long.
std::string shown(std::string_view text);

/// The tree of a YAML document: keeps what yaml-cpp's own nodes drop (duplicate keys, quotes) and
/// refuses what cannot be traversed (see parse_yaml).
struct YamlNode {
  enum class Kind { null, scalar, sequence, mapping };
  Kind kind = Kind::null;
  Place place;
  std::string text;     ///< of a scalar
  bool quoted = false;  ///< a quoted scalar: text, never a number
  std::vector<std::shared_ptr<const YamlNode>>
      items;             ///< of a sequence; of a mapping key, value, ...
  std::size_t size = 1;  ///< number of nodes from here down, with aliases expanded

  std::string kind_name() const;
  /// The value of a key of a mapping; null where it has no such key.
  const YamlNode* find(std::string_view key) const;
};

/// The kind of a YAML file and its limits.
struct YamlFormat {
  std::string name;                ///< "scene", the name in errors about the whole file
  std::size_t depth = 32;          ///< levels of nesting
  std::size_t nodes = 20'000'000;  ///< with aliases expanded
  bool aliases = true;             ///< whether it may have anchors and aliases
  /// Whether names may have indices, u[i], in mappings in braces too, where YAML's rules would end
  /// the key or the value at a bracket.
  bool indices = false;
};

/// Parses one document. Throws InputError (with `file` for its text) for a text that is not YAML,
/// not UTF-8, binary, empty, more than one document, or deeper or larger (aliases expanded) than
/// the format allows; for an alias within its own anchor; for tags. Merge keys (<<) are written
/// out.
std::shared_ptr<const YamlNode> parse_yaml(const std::string& file, const std::string& text,
                                           const YamlFormat& format);

}  // namespace odeum
