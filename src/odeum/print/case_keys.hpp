// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "odeum/formula/reader.hpp"

namespace odeum::print {

/// A key whose value is assigned to a member of Case.
struct Member {
  enum class Kind { text, number, numbers, thresholds };
  const char* key;
  const char* member;
  Kind kind;
};
inline constexpr Member members[] = {
    {"title", "title", Member::Kind::text},
    {"equation", "equation", Member::Kind::text},
    {"source", "source", Member::Kind::text},
    {"stops", "stops", Member::Kind::numbers},
    {"thresholds", "tolerance", Member::Kind::thresholds},
    {"no_fixed_steps", "settings.no_fixed_steps", Member::Kind::text},
    {"steps_multiple", "settings.steps_multiple", Member::Kind::number},
    {"coarsest_steps", "settings.coarsest_steps", Member::Kind::number},
    {"finest_steps", "settings.finest_steps", Member::Kind::number},
    {"timed_stops", "settings.timed_stops", Member::Kind::numbers},
    {"timed_floor", "settings.timed_floor", Member::Kind::number},
    {"evaluation_budget", "settings.evaluation_budget", Member::Kind::number}};

/// What a problem file says of its cases: for each the keys below its id, and those below `case`.
class CaseKeys : protected formula::reading::Source {
 protected:
  using Item = formula::reading::Item;

  CaseKeys(const std::string& file, const std::string& text);
  /// Reads the keys of a case from here on.
  void enter(const Item& item);

  /// The value of a key of the case, else of `case`; null: neither has it.
  const YamlNode* find(std::string_view key) const;
  std::vector<Item> mapping(const std::string& key) const;
  static const Item* of_name(const std::vector<Item>& list, std::string_view name);
  /// A scalar, or the entries of a list; nothing for null.
  static std::vector<const YamlNode*> entries(const YamlNode* value);
  std::vector<std::string> texts(const YamlNode* value, const std::string& key) const;

  std::vector<Item> cases_, common_, own_;

 private:
  void require_known(const std::vector<Item>& list, const std::string& in) const;
};

}  // namespace odeum::print
