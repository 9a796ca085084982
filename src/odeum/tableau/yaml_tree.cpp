// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/tableau/yaml_tree.hpp"

#include <fmt/format.h>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/parser.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace odeum {
namespace {

constexpr std::uintmax_t largest_file = 1 << 20;
constexpr std::size_t deepest_nesting = 16;

std::string place_of(const std::string& file, int line, int column) {
  return fmt::format("{}:{}:{}", file, line, column);
}

/// Builds the tree from yaml-cpp's events, so that nothing is expanded and nothing recurses.
class Builder : public YAML::EventHandler {
 public:
  explicit Builder(const std::string& file) : file_(file) {}

  bool has_document() const { return documents_ > 0; }
  YamlTree take() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (++documents_ > 1) fail(mark, "a second document; expected one");
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    add(made(mark, YamlTree::Kind::scalar, "", anchor));
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    fail(mark, "an alias; expected the value itself");
  }
  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                const std::string& value) override {
    YamlTree tree = made(mark, YamlTree::Kind::scalar, tag, anchor);
    tree.text = value;
    add(std::move(tree));
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    open(made(mark, YamlTree::Kind::list, tag, anchor));
  }
  void OnSequenceEnd() override { close(); }
  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    open(made(mark, YamlTree::Kind::map, tag, anchor));
  }
  void OnMapEnd() override { close(); }

 private:
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
    throw InputError(fmt::format("{}: {}", place_of(file_, mark.line + 1, mark.column + 1), what));
  }

  YamlTree made(const YAML::Mark& mark, YamlTree::Kind kind, const std::string& tag,
                YAML::anchor_t anchor) const {
    if (anchor != 0) fail(mark, "an anchor; expected plain values");
    if (!tag.empty() && tag[0] == '!' && tag != "!")
      fail(mark, fmt::format("a tag '{}'; expected plain values", tag));
    YamlTree tree;
    tree.kind = kind;
    tree.line = mark.line + 1;
    tree.column = mark.column + 1;
    return tree;
  }

  void open(YamlTree tree) {
    if (open_.size() >= deepest_nesting)
      throw InputError(fmt::format("{}: nested deeper than {} levels",
                                   place_of(file_, tree.line, tree.column), deepest_nesting));
    open_.push_back({std::move(tree), {}, false});
  }
  void close() {
    YamlTree tree = std::move(open_.back().tree);
    open_.pop_back();
    add(std::move(tree));
  }

  void add(YamlTree tree) {
    if (open_.empty()) {
      root_ = std::move(tree);
      return;
    }
    Open& parent = open_.back();
    if (parent.tree.kind == YamlTree::Kind::list) {
      parent.tree.items.push_back(std::move(tree));
    } else if (!parent.has_key) {
      if (tree.kind != YamlTree::Kind::scalar)
        throw InputError(fmt::format("{}: {} as a key; expected a word",
                                     place_of(file_, tree.line, tree.column), tree.described()));
      for (const auto& [key, value] : parent.tree.entries)
        if (key.text == tree.text)
          throw InputError(fmt::format("{}: {}: a second time; the first is in line {}",
                                       place_of(file_, tree.line, tree.column), tree.text,
                                       key.line));
      parent.key = std::move(tree);
      parent.has_key = true;
    } else {
      parent.tree.entries.emplace_back(std::move(parent.key), std::move(tree));
      parent.has_key = false;
    }
  }

  struct Open {
    YamlTree tree, key;
    bool has_key;
  };
  std::string file_;
  int documents_ = 0;
  YamlTree root_;
  std::vector<Open> open_;
};

/// Text is UTF-8 without control characters; `line` of the first byte that is not, or 0.
int line_of_bad_byte(const std::string& text) {
  int line = 1;
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = static_cast<unsigned char>(text[i]);
    if (byte == '\n') ++line;
    if (byte < 0x20 && byte != '\n' && byte != '\r' && byte != '\t') return line;
    const std::size_t length = byte < 0x80       ? 1
                               : byte >> 5 == 6  ? 2
                               : byte >> 4 == 14 ? 3
                               : byte >> 3 == 30 ? 4
                                                 : 0;
    if (length == 0 || i + length > text.size()) return line;
    for (std::size_t k = 1; k < length; ++k)
      if ((static_cast<unsigned char>(text[i + k]) & 0xC0) != 0x80) return line;
    i += length;
  }
  return 0;
}

}  // namespace

std::string YamlTree::described() const {
  if (kind == Kind::map) return "a map";
  if (kind == Kind::list) return fmt::format("a list of {}", items.size());
  return text.empty() ? "nothing" : fmt::format("'{}'", text.substr(0, 60));
}

void fail_at(const std::string& file, const YamlTree& place, const std::string& key,
             const std::string& what, const std::string& expected) {
  const char* join = what.find("got ") == std::string::npos ? "; expected " : ", expected ";
  throw InputError(fmt::format("{}: {}: {}{}{}", place_of(file, place.line, place.column), key,
                               what, expected.empty() ? "" : join, expected));
}

YamlTree read_yaml_text(const std::string& text, const std::string& name) {
  if (const int line = line_of_bad_byte(text))
    throw InputError(fmt::format("{}:{}:1: no text (UTF-8 expected)", name, line));
  std::istringstream stream(text);
  Builder builder(name);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const YAML::Exception& error) {
    throw InputError(fmt::format(
        "{}: no YAML: {}", place_of(name, error.mark.line + 1, error.mark.column + 1), error.msg));
  }
  if (!builder.has_document()) throw InputError(fmt::format("{}:1:1: an empty file", name));
  return builder.take();
}

YamlTree read_yaml_file(const std::string& path) {
  std::error_code code;
  const auto status = std::filesystem::status(path, code);
  if (!std::filesystem::exists(status)) throw InputError(fmt::format("{}: no such file", path));
  if (!std::filesystem::is_regular_file(status))
    throw InputError(fmt::format("{}: no regular file", path));
  const auto size = std::filesystem::file_size(path, code);
  if (code || size > largest_file)
    throw InputError(fmt::format("{}: larger than {} bytes", path, largest_file));
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  if (!in) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  return read_yaml_text(text.str(), path);
}

}  // namespace odeum
