// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/tableau/tableau_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "odeum/core/glob.hpp"
#include "odeum/input/text_file.hpp"

namespace odeum {
namespace {

const std::vector<std::string> keys{"name", "source", "order", "order_embedded",
                                    "c",    "A",      "b",     "b_hat"};

/// A tableau of numbers as written in the file.
struct Written {
  std::size_t stages = 0;
  int order = 0, order_hat = 0;
  std::vector<Coefficient> a, b, c, b_hat;
};

class Reader {
 public:
  Reader(const YamlNode& root, const std::string& file) : root_(root), file_(file) {
    if (root.kind != YamlNode::Kind::mapping)
      fail_at(root, "tableau", got(root), "a mapping with A and b");
    for (std::size_t i = 0; i < root.items.size(); i += 2) check_key(i);
  }

  TableauFile read() {
    TableauFile result;
    result.name = text_of("name");
    result.source = text_of("source");
    Written w;
    w.stages = needed("A").items.size();
    w.a = matrix(needed("A"), w);
    w.b = row(needed("b"), "b", w.stages);
    if (const YamlNode* c = root_.find("c")) {
      w.c = row(*c, "c", w.stages);
      result.has_nodes = true;
    }
    if (const YamlNode* b_hat = root_.find("b_hat")) w.b_hat = row(*b_hat, "b_hat", w.stages);
    w.order = claim("order");
    w.order_hat = claim("order_embedded");
    if (w.order_hat != 0 && w.b_hat.empty())
      fail_at(*root_.find("order_embedded"), "order_embedded", "claim without the row", "b_hat");

    const bool exact = all_of(w, [](const Coefficient& x) { return x.rational; });
    if (exact)
      result.tableau = convert<mpq_class>(w, [](const Coefficient& x) { return x.exact; });
    else
      result.tableau = convert<mpf_class>(w, [](const Coefficient& x) { return x.value; });
    result.rounded = convert<double>(w, [](const Coefficient& x) { return x.value.get_d(); });
    // Rounding of a root to 512 bits, with a margin for the sums that it enters.
    if (!exact) result.rounding.relative = 1e-140;
    all_of(w, [&](const Coefficient& x) {
      result.rounding.absolute = std::max(result.rounding.absolute, x.uncertainty);
      return true;
    });
    return result;
  }

 private:
  static std::string got(const YamlNode& node) { return "got " + node.kind_name(); }

  [[noreturn]] void fail_at(const YamlNode& at, const std::string& key, const std::string& what,
                            const std::string& expected) const {
    const char* join = what.find("got ") == std::string::npos ? "; expected " : ", expected ";
    throw InputError(file_, at.place, fmt::format("{}: {}{}{}", key, what, join, expected));
  }

  const YamlNode& needed(const std::string& name) const {
    const YamlNode* value = root_.find(name);
    if (!value) fail_at(root_, name, "missing", "a list");
    if (value->kind != YamlNode::Kind::sequence || value->items.empty())
      fail_at(*value, name, got(*value), "a list with an entry a stage");
    return *value;
  }

  /// Item `i` of the root, which is a key.
  void check_key(std::size_t i) const {
    const YamlNode& key = *root_.items[i];
    if (key.kind != YamlNode::Kind::scalar) fail_at(key, "tableau", got(key), "a word as a key");
    for (std::size_t k = 0; k < i; k += 2)
      if (root_.items[k]->text == key.text)
        fail_at(key, key.text,
                fmt::format("duplicate key; the first is in line {}", root_.items[k]->place.line),
                "one");
    if (std::count(keys.begin(), keys.end(), key.text)) return;
    fail_at(key, shown(key.text), "unknown key" + near_one(key.text, keys),
            fmt::format("one of {}", fmt::join(keys, ", ")));
  }

  std::string text_of(const std::string& name) const {
    const YamlNode* value = root_.find(name);
    if (!value) return {};
    if (value->kind != YamlNode::Kind::scalar) fail_at(*value, name, got(*value), "a text");
    return value->text;
  }

  int claim(const std::string& name) const {
    const YamlNode* value = root_.find(name);
    if (!value) return 0;
    const bool digits = value->kind == YamlNode::Kind::scalar && !value->text.empty() &&
                        value->text.size() <= 2 && value->text[0] != '0' &&
                        std::all_of(value->text.begin(), value->text.end(),
                                    [](char c) { return c >= '0' && c <= '9'; });
    const int order = digits ? std::stoi(value->text) : 0;
    if (order < 1 || order > highest_order_checked)
      fail_at(*value, name, got(*value),
              fmt::format("a whole number from 1 to {}", highest_order_checked));
    return order;
  }

  Coefficient number(const YamlNode& value, const std::string& name) const {
    if (value.kind != YamlNode::Kind::scalar) fail_at(value, name, got(value), "a number");
    try {
      return parse_coefficient(value.text);
    } catch (const CoefficientError& error) {
      fail_at(value, name, fmt::format("{}; {}", error.what(), got(value)),
              "a number such as 2/9, 0.25, 1e-3 or (2 - sqrt(2))/2");
    }
  }

  std::vector<Coefficient> row(const YamlNode& value, const std::string& name,
                               std::size_t stages) const {
    if (value.kind != YamlNode::Kind::sequence || value.items.size() != stages)
      fail_at(value, name, got(value), fmt::format("a list of {}, as many as A has rows", stages));
    std::vector<Coefficient> numbers;
    for (std::size_t i = 0; i < stages; ++i)
      numbers.push_back(number(*value.items[i], fmt::format("{}[{}]", name, i + 1)));
    return numbers;
  }

  std::vector<Coefficient> matrix(const YamlNode& value, const Written& w) const {
    if (w.stages > most_stages)
      fail_at(value, "A", fmt::format("got {} rows", w.stages),
              fmt::format("at most {}", most_stages));
    std::vector<Coefficient> a;
    const Coefficient zero = parse_coefficient("0");
    for (std::size_t i = 0; i < w.stages; ++i) {
      const YamlNode& line = *value.items[i];
      const std::string name = fmt::format("A[{}]", i + 1);
      if (line.kind != YamlNode::Kind::sequence || line.items.size() > w.stages)
        fail_at(line, name, got(line),
                fmt::format("a list of at most {}, the number of rows", w.stages));
      for (std::size_t j = 0; j < w.stages; ++j)
        a.push_back(j < line.items.size()
                        ? number(*line.items[j], fmt::format("A[{}][{}]", i + 1, j + 1))
                        : zero);
    }
    return a;
  }

  template <class Test>
  static bool all_of(const Written& w, Test&& test) {
    bool all = true;
    for (const auto* list : {&w.a, &w.b, &w.c, &w.b_hat})
      for (const Coefficient& x : *list) all = test(x) && all;
    return all;
  }

  template <class Number, class Pick>
  static DynamicTableau<Number> convert(const Written& w, Pick&& pick) {
    DynamicTableau<Number> t;
    t.stages = w.stages;
    t.order = w.order;
    t.order_hat = w.order_hat;
    const auto copy = [&](const std::vector<Coefficient>& from, std::vector<Number>& to) {
      for (const Coefficient& x : from) to.push_back(pick(x));
    };
    copy(w.a, t.a);
    copy(w.b, t.b);
    copy(w.b_hat, t.b_hat);
    if (w.c.empty())
      t.set_nodes_to_row_sums();
    else
      copy(w.c, t.c);
    return t;
  }

  const YamlNode& root_;
  const std::string& file_;
};

}  // namespace

TableauFile read_tableau(const std::string& file, const std::string& text) {
  return Reader(*parse_yaml(file, text, {.name = "tableau", .depth = 16, .aliases = false}), file)
      .read();
}

TableauFile read_tableau_file(const std::string& path) {
  return read_tableau(path, read_text_file(path, "tableau", 1 << 20));
}

}  // namespace odeum
