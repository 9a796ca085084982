// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/print/case_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "odeum/core/glob.hpp"

namespace odeum::print {

CaseKeys::CaseKeys(const std::string& file, const std::string& text) : Source(file, text) {
  const std::vector<Item> all = items(root(), "problem");
  if (const Item* const item = of_name(all, "case")) common_ = items(*item->value, "case");
  if (const Item* const item = of_name(all, "cases")) cases_ = items(*item->value, "cases");
  if (cases_.empty()) fail({}, "cases: missing; got none, expected `cases: {{id: {{...}}}}`");
  require_known(common_, "case");
}

void CaseKeys::enter(const Item& item) {
  if (const std::string fault = formula::fault_of_name(item.key); !fault.empty())
    fail(item.key_place, "cases: {}", fault);
  own_ = items(*item.value, item.key);
  require_known(own_, item.key);
}

void CaseKeys::require_known(const std::vector<Item>& list, const std::string& in) const {
  std::vector<std::string> known{"tags",     "parameters",   "meanings",   "set",  "reference",
                                 "positive", "not_negative", "invariants", "floor"};
  if (&list == &common_) known.emplace_back("offers");
  for (const Member& each : members) known.emplace_back(each.key);
  for (const Item& item : list)
    if (std::find(known.begin(), known.end(), item.key) == known.end())
      fail(item.key_place, "{}: an unknown key; got {}, expected one of {}{}", in, shown(item.key),
           fmt::join(known, ", "), near_one(item.key, known));
}

const YamlNode* CaseKeys::find(std::string_view key) const {
  for (const auto* list : {&own_, &common_})
    if (const Item* const item = of_name(*list, key)) return item->value;
  return nullptr;
}

std::vector<CaseKeys::Item> CaseKeys::mapping(const std::string& key) const {
  const YamlNode* const value = find(key);
  return value ? items(*value, key) : std::vector<Item>{};
}

const CaseKeys::Item* CaseKeys::of_name(const std::vector<Item>& list, std::string_view name) {
  const auto at =
      std::find_if(list.begin(), list.end(), [&](const Item& item) { return item.key == name; });
  return at == list.end() ? nullptr : &*at;
}

std::vector<const YamlNode*> CaseKeys::entries(const YamlNode* value) {
  if (!value) return {};
  if (value->kind != YamlNode::Kind::sequence) return {value};
  std::vector<const YamlNode*> all;
  for (const auto& each : value->items) all.push_back(each.get());
  return all;
}

std::vector<std::string> CaseKeys::texts(const YamlNode* value, const std::string& key) const {
  std::vector<std::string> all;
  for (const YamlNode* each : entries(value)) all.push_back(scalar(*each, key));
  return all;
}

}  // namespace odeum::print
