// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/case_section.hpp"

#include <fmt/format.h>

#include <iterator>

#include "odeum/formula/names.hpp"

namespace odeum::formula {

using input::entry_of;

namespace {

constexpr std::string_view known_keys[] = {"title",        "equation",       "source",
                                           "tags",         "parameters",     "meanings",
                                           "set",          "positive",       "not_negative",
                                           "stops",        "thresholds",     "reference",
                                           "floor",        "invariants",     "no_fixed_steps",
                                           "timed_stops",  "steps_multiple", "coarsest_steps",
                                           "finest_steps", "timed_floor",    "evaluation_budget",
                                           "nature"};

/// A node as text; of a mapping the keys alone where `keys` is true.
std::string serialised(const YamlNode& node, bool keys = false) {
  if (node.kind == YamlNode::Kind::scalar) return node.text;
  std::string text = node.kind == YamlNode::Kind::mapping ? "{" : "[";
  for (std::size_t k = 0; k < node.items.size(); k += keys ? 2 : 1)
    text += serialised(*node.items[k]) + '\n';
  return text + "}";
}

}  // namespace

CaseSection::CaseSection(const std::string& file, const std::string& text) : Source(file, text) {
  const std::vector<Item> all = items(root(), "");
  std::vector<std::string_view> known(std::begin(known_keys), std::end(known_keys));
  known.emplace_back("offers");  // for all cases alike
  if (const Item* const item = entry_of(all, "case")) common_ = items(*item->value, "case", known);
  if (const Item* const item = entry_of(all, "cases")) cases_ = items(*item->value, "cases");
  if (const Item* const item = entry_of(all, "name")) name_ = scalar(*item->value, "name");
  for (const Item& item : cases_) {
    if (const std::string fault = fault_of_name(item.key); !fault.empty())
      fail(item.key_place, "cases: {}", fault);
    items(*item.value, item.key, known_keys);
  }
}

std::vector<std::string> CaseSection::ids() const {
  std::vector<std::string> ids;
  for (const Item& item : cases_) ids.push_back(item.key);
  return ids;
}

void CaseSection::enter(const std::string& id) {
  const Item* const item = entry_of(cases_, id);
  own_ = item ? items(*item->value, id) : std::vector<Item>{};
}

const YamlNode* CaseSection::find(std::string_view key) const {
  for (const auto* list : {&own_, &common_})
    if (const Item* const item = entry_of(*list, key)) return item->value;
  return nullptr;
}

std::vector<CaseSection::Item> CaseSection::mapping(const std::string& key) const {
  const YamlNode* const value = find(key);
  return value ? items(*value, key) : std::vector<Item>{};
}

std::vector<const YamlNode*> CaseSection::entries(const YamlNode* value) {
  if (!value) return {};
  if (value->kind != YamlNode::Kind::sequence) return {value};
  std::vector<const YamlNode*> all;
  for (const auto& each : value->items) all.push_back(each.get());
  return all;
}

std::vector<std::string> CaseSection::texts_of(const YamlNode* value, std::string_view key) const {
  std::vector<std::string> all;
  for (const YamlNode* each : entries(value)) all.push_back(scalar(*each, std::string(key)));
  return all;
}

std::vector<std::string> CaseSection::texts(std::string_view key) const {
  return texts_of(find(key), key);
}

std::string CaseSection::text(std::string_view key, const std::string& otherwise) const {
  const YamlNode* const value = find(key);
  return value ? scalar(*value, std::string(key)) : otherwise;
}

std::vector<std::string> CaseSection::all_texts(std::string_view key) const {
  std::vector<std::string> all;
  for (const auto* list : {&common_, &own_})
    if (const Item* const given = entry_of(*list, key))
      for (std::string& text : texts_of(given->value, key)) all.push_back(std::move(text));
  return all;
}

Offers CaseSection::offers() const {
  const Item* const given = entry_of(common_, "offers");
  if (!given) return {};
  Offers offers{.jacobian = false, .second_order = false, .series = false};
  for (const std::string& name : texts_of(given->value, "offers"))
    if (name == "jacobian")
      offers.jacobian = true;
    else if (name == "second_order")
      offers.second_order = true;
    else if (name == "series")
      offers.series = true;
    else
      fail(given->value->place, "offers: got {}, expected jacobian, second_order or series", name);
  return offers;
}

std::string code_of_problem(const std::string& file, const std::string& text) {
  const reading::Source source(file, text);
  std::string code;
  for (const reading::Item& item : source.items(source.root(), "problem")) {
    const bool keys = item.key == "parameters" || item.key == "states";
    for (const char* used : {"parameters", "definitions", "states", "equations", "boundaries",
                             "implicit", "invariants", "mass", "reactions", "compartments"})
      if (item.key == used) code += item.key + serialised(*item.value, keys);
  }
  const Offers offers = CaseSection(file, text).offers();
  return code + fmt::format("{}{}{}", offers.jacobian, offers.second_order, offers.series);
}

}  // namespace odeum::formula
