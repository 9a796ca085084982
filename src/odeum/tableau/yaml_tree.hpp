// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace odeum {

/// Bad input: `file:line:column: key: what is wrong; got X, expected Y`.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A YAML document as it was written, with the place of everything. Scalars stay text: what they
/// mean is for the reader of a format to say, not for YAML (for which 010 is eight).
struct YamlTree {
  enum class Kind { scalar, list, map };
  Kind kind = Kind::scalar;
  int line = 1, column = 1;  ///< counted from 1
  std::string text;
  std::vector<YamlTree> items;
  std::vector<std::pair<YamlTree, YamlTree>> entries;

  /// "a list of 3", "a map", "'text'": for sentences.
  std::string described() const;
};

/// Reads a file of at most 1 MiB. Throws InputError for what is no regular file, no text, no YAML,
/// empty or more than one document; for a key that is twice in a map; for anchors, aliases and
/// tags, which no format here needs; for nesting beyond 16 levels.
YamlTree read_yaml_file(const std::string& path);

/// The same of a text; `name` stands for the file in errors.
YamlTree read_yaml_text(const std::string& text, const std::string& name);

/// Throws an InputError about a place.
[[noreturn]] void fail_at(const std::string& file, const YamlTree& place, const std::string& key,
                          const std::string& what, const std::string& expected = "");

}  // namespace odeum
