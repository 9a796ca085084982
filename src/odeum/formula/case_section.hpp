// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "odeum/formula/reader.hpp"

namespace odeum::formula {

/// What code for a problem offers besides its right-hand side, where it is found at all.
struct Offers {
  bool jacobian = true, second_order = true, series = true;
};

/// What a problem file says of its cases: for each the keys below its id in `cases`, and those
/// below `case`, which all share. CONTRIBUTING.md lists the keys.
class CaseSection : protected reading::Source {
 public:
  using Item = reading::Item;

  /// Throws InputError with the place of an unknown key, and of an id that is not a name.
  CaseSection(const std::string& file, const std::string& text);

  const std::string& name() const { return name_; }  ///< of the problem; empty: none
  std::vector<std::string> ids() const;              ///< empty: the file has no `cases`
  /// Reads the keys of that case from here on.
  void enter(const std::string& id);

  /// The value of a key of the case, else of `case`; null: neither has it.
  const YamlNode* find(std::string_view key) const;
  bool has(std::string_view key) const { return find(key) != nullptr; }
  /// The scalar of a key, or the entries of its list; none: neither.
  std::vector<std::string> texts(std::string_view key) const;
  std::string text(std::string_view key, const std::string& otherwise) const;
  /// The same of `case`, then of the case.
  std::vector<std::string> all_texts(std::string_view key) const;
  Offers offers() const;

 protected:
  std::vector<Item> mapping(const std::string& key) const;
  /// A scalar, or the entries of a list; nothing for null.
  static std::vector<const YamlNode*> entries(const YamlNode* value);

 private:
  std::vector<std::string> texts_of(const YamlNode* value, std::string_view key) const;

  std::string name_;
  std::vector<Item> cases_, common_, own_;
};

/// What code is printed of a problem file: files with equal texts of it have the same code,
/// whatever the values of their parameters, the initial values, and what is said of cases.
std::string code_of_problem(const std::string& file, const std::string& text);

}  // namespace odeum::formula
