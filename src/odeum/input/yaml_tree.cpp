// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/input/yaml_tree.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <unordered_map>
#include <utility>

#include "odeum/input/utf8.hpp"

namespace odeum {
namespace {

Place place_of(const YAML::Mark& mark) {
  if (mark.is_null()) return {};
  return {static_cast<std::size_t>(mark.line) + 1, static_cast<std::size_t>(mark.column) + 1};
}

// What stands for the brackets of u[i] while yaml-cpp reads.
constexpr std::string_view left = "\xe2\x9f\xa6", right = "\xe2\x9f\xa7";

std::string without_brackets(const std::string& text) {
  std::string masked;
  std::size_t open = 0;
  char before = ' ';
  for (const char c : text) {
    const bool in_name = (std::isalnum(static_cast<unsigned char>(before)) != 0) || before == '_';
    if (c == '\n') open = 0;
    if (c == '[' && (open > 0 || in_name)) {
      ++open;
      masked += left;
    } else if (c == ']' && open > 0) {
      --open;
      masked += right;
    } else {
      masked += c;
    }
    before = c;
  }
  return masked;
}

std::string with_brackets(std::string text) {
  for (const auto& [what, by] : {std::pair(left, '['), std::pair(right, ']')})
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
      text.replace(at, what.size(), 1, by);
  return text;
}

/// Builds the tree from yaml-cpp's events and enforces the limits at each event.
class Builder final : public YAML::EventHandler {
 public:
  Builder(const std::string& file, const YamlFormat& format) : file_(file), format_(format) {}

  std::shared_ptr<const YamlNode> root() const { return root_; }
  Place start() const { return start_; }

  void OnDocumentStart(const YAML::Mark& mark) override { start_ = place_of(mark); }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(make(mark, YamlNode::Kind::null), anchor);
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    check_tag(mark, tag);
    auto node = make(mark, YamlNode::Kind::scalar);
    node->text = format_.indices ? with_brackets(value) : value;
    node->quoted = tag == "!";
    if (!node->quoted && (value.empty() || value == "~" || value == "null"))
      node->kind = YamlNode::Kind::null;
    add(std::move(node), anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto found = anchors_.find(anchor);
    if (found == anchors_.end())
      fail(mark, "an alias within its own anchor, a cycle; got the alias, expected one after it");
    attach(found->second, place_of(mark));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::sequence);
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(mark, tag, anchor, YamlNode::Kind::mapping);
  }
  void OnMapEnd() override { close(); }

 private:
  struct Open {
    std::shared_ptr<YamlNode> node;
    YAML::anchor_t anchor;
  };

  [[noreturn]] void fail(Place place, const std::string& what) const {
    throw InputError(file_, place, format_.name + ": " + what);
  }
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
    fail(place_of(mark), what);
  }
  static std::shared_ptr<YamlNode> make(const YAML::Mark& mark, YamlNode::Kind kind) {
    auto node = std::make_shared<YamlNode>();
    node->kind = kind;
    node->place = place_of(mark);
    return node;
  }
  void check_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (!tag.empty() && tag != "?" && tag != "!")
      fail(mark, "a tag; got " + shown(tag) + ", expected none");
  }
  void check_anchor(Place place, YAML::anchor_t anchor) const {
    if (anchor && !format_.aliases)
      fail(place, "an anchor; got one, expected the values themselves");
  }
  void open(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
            YamlNode::Kind kind) {
    check_tag(mark, tag);
    check_anchor(place_of(mark), anchor);
    if (open_.size() >= format_.depth)
      fail(mark, fmt::format("nested too deeply; got more than {} levels, expected at most that",
                             format_.depth));
    open_.push_back({make(mark, kind), anchor});
  }
  void close() {
    const Open done = std::move(open_.back());
    open_.pop_back();
    if (done.node->kind == YamlNode::Kind::mapping && format_.aliases) merge(*done.node);
    add(done.node, done.anchor);
  }
  // Writes `<<: *a` and `<<: [*a, *b]` out: keys of the mapping itself come first, then those of
  // the mappings named, in their order; a key that is there already is not taken again.
  void merge(YamlNode& mapping) const {
    const auto is_merge = [](const YamlNode& key) { return key.text == "<<" && !key.quoted; };
    std::vector<std::shared_ptr<const YamlNode>> items;
    const auto take = [&](const YamlNode& from, bool over) {
      for (std::size_t i = 0; i + 1 < from.items.size(); i += 2) {
        const YamlNode& key = *from.items[i];
        if (is_merge(key)) continue;
        bool there = false;
        for (std::size_t k = 0; over && k < items.size(); k += 2)
          there = there || (key.kind == YamlNode::Kind::scalar && items[k]->text == key.text);
        if (!there) items.insert(items.end(), {from.items[i], from.items[i + 1]});
      }
    };
    take(mapping, false);
    if (items.size() == mapping.items.size()) return;
    const auto take_other = [&](const YamlNode& other) {
      if (other.kind != YamlNode::Kind::mapping)
        fail(other.place, "a merge key; got " + other.kind_name() +
                              ", expected a mapping, or a list of mappings");
      take(other, true);
    };
    for (std::size_t i = 0; i + 1 < mapping.items.size(); i += 2) {
      if (!is_merge(*mapping.items[i])) continue;
      const YamlNode& others = *mapping.items[i + 1];
      if (others.kind != YamlNode::Kind::sequence) take_other(others);
      for (const auto& other : others.items)
        if (others.kind == YamlNode::Kind::sequence) take_other(*other);
    }
    mapping.items = std::move(items);
  }
  void add(std::shared_ptr<YamlNode> node, YAML::anchor_t anchor) {
    check_anchor(node->place, anchor);
    if (anchor) anchors_[anchor] = node;
    const Place place = node->place;
    attach(std::move(node), place);
  }
  void attach(std::shared_ptr<const YamlNode> node, Place place) {
    if (open_.empty()) {
      root_ = std::move(node);
      return;
    }
    YamlNode& parent = *open_.back().node;
    parent.size += node->size;
    if (parent.size > format_.nodes)
      fail(place, fmt::format("too much once its aliases are written out; got more than {} "
                              "entries, expected at most that",
                              format_.nodes));
    parent.items.push_back(std::move(node));
  }

  const std::string& file_;
  const YamlFormat& format_;
  std::vector<Open> open_;
  std::unordered_map<YAML::anchor_t, std::shared_ptr<const YamlNode>> anchors_;
  std::shared_ptr<const YamlNode> root_;
  Place start_;
};

void require_text(const std::string& file, std::string_view text, const std::string& name) {
  Place place;
  for (std::size_t i = 0; i < text.size();) {
    const auto c = static_cast<unsigned char>(text[i]);
    const std::size_t length = first_character(text.substr(i)).bytes;
    if (length == 0)
      throw InputError(file, place,
                       fmt::format("{}: not UTF-8 text; got the byte 0x{:02x}, expected UTF-8",
                                   name, unsigned{c}));
    const bool blank = c == '\t' || c == '\n' || c == '\r';
    if ((c < 0x20 && !blank) || c == 0x7f)
      throw InputError(file, place,
                       fmt::format("{}: a binary file or a control character; got the byte "
                                   "0x{:02x}, expected text",
                                   name, unsigned{c}));
    place.column = c == '\n' ? 1 : place.column + 1;
    if (c == '\n') ++place.line;
    i += length;
  }
}

}  // namespace

const YamlNode* YamlNode::find(std::string_view key) const {
  for (std::size_t i = 0; i + 1 < items.size(); i += 2)
    if (items[i]->text == key) return items[i + 1].get();
  return nullptr;
}

std::string YamlNode::kind_name() const {
  switch (kind) {
    case Kind::null:
      return "nothing";
    case Kind::scalar:
      return (quoted ? "the text \"" : "") + shown(text) + (quoted ? "\"" : "");
    case Kind::sequence:
      return fmt::format("a list of {}", items.size());
    case Kind::mapping:
      return "a mapping";
  }
  return "nothing";
}

std::shared_ptr<const YamlNode> parse_yaml(const std::string& file, const std::string& text,
                                           const YamlFormat& format) {
  require_text(file, text, format.name);
  Builder builder(file, format);
  try {
    std::istringstream in(format.indices ? without_brackets(text) : text);
    YAML::Parser parser(in);
    if (!parser.HandleNextDocument(builder) || !builder.root() ||
        builder.root()->kind == YamlNode::Kind::null)
      throw InputError(file, {}, format.name + ": empty; got no entry, expected a mapping of keys");
    auto root = builder.root();
    Builder second(file, format);
    if (parser.HandleNextDocument(second))
      throw InputError(
          file, second.start(),
          format.name + ": a second document; got more after ---, expected one document");
    return root;
  } catch (const YAML::Exception& error) {
    throw InputError(file, place_of(error.mark),
                     format.name + ": not YAML; got: " + shown(with_brackets(error.msg)) +
                         ", expected a mapping of keys");
  }
}

}  // namespace odeum
