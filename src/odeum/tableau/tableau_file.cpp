// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/tableau/tableau_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "odeum/harness/glob.hpp"

namespace odeum {
namespace {

const std::vector<std::string> keys{"name", "source", "order", "order_embedded",
                                    "c",    "A",      "b",     "b_hat"};

/// A tableau of numbers as they were written.
struct Written {
  std::size_t stages = 0;
  std::vector<Coefficient> a, b, c, b_hat;
};

class Reader {
 public:
  Reader(const YamlTree& tree, const std::string& file) : tree_(tree), file_(file) {
    if (tree.kind != YamlTree::Kind::map)
      fail_at(file, tree, "tableau", "got " + tree.described(), "a map with A and b");
    for (const auto& [key, value] : tree.entries) check_key(key);
  }

  TableauFile read() {
    TableauFile result;
    result.name = text_of("name");
    result.source = text_of("source");
    Written w;
    w.stages = needed("A").items.size();
    w.a = matrix(needed("A"), w);
    w.b = row(needed("b"), "b", w.stages);
    if (const YamlTree* c = find("c")) {
      w.c = row(*c, "c", w.stages);
      result.has_nodes = true;
    }
    if (const YamlTree* b_hat = find("b_hat")) w.b_hat = row(*b_hat, "b_hat", w.stages);
    const int order = claim("order"), order_hat = claim("order_embedded");
    if (order_hat != 0 && w.b_hat.empty())
      fail_at(file_, *find("order_embedded"), "order_embedded", "a claim about no row", "b_hat");

    const bool exact = all_of(w, [](const Coefficient& x) { return x.rational; });
    if (exact)
      result.tableau = convert<mpq_class>(w, [](const Coefficient& x) { return x.exact; });
    else
      result.tableau = convert<mpf_class>(w, [](const Coefficient& x) { return x.value; });
    result.rounded = convert<double>(w, [](const Coefficient& x) { return x.value.get_d(); });
    std::visit(
        [&](auto& t) {
          t.order = order;
          t.order_hat = order_hat;
        },
        result.tableau);
    result.rounded.order = order;
    result.rounded.order_hat = order_hat;
    // What 512 bits leave of a root, with room for the sums that it enters.
    if (!exact) result.rounding.relative = 1e-140;
    all_of(w, [&](const Coefficient& x) {
      result.rounding.absolute = std::max(result.rounding.absolute, x.uncertainty);
      return true;
    });
    return result;
  }

 private:
  const YamlTree* find(const std::string& name) const {
    for (const auto& [key, value] : tree_.entries)
      if (key.text == name) return &value;
    return nullptr;
  }
  const YamlTree& needed(const std::string& name) const {
    const YamlTree* value = find(name);
    if (!value) fail_at(file_, tree_, name, "missing", "a list");
    if (value->kind != YamlTree::Kind::list || value->items.empty())
      fail_at(file_, *value, name, "got " + value->described(), "a list with an entry a stage");
    return *value;
  }

  void check_key(const YamlTree& key) const {
    if (std::count(keys.begin(), keys.end(), key.text)) return;
    const std::string near = nearest(key.text, keys);
    fail_at(file_, key, key.text,
            "unknown key" + (near.empty() ? "" : fmt::format(", did you mean {}?", near)),
            fmt::format("one of {}", fmt::join(keys, ", ")));
  }

  std::string text_of(const std::string& name) const {
    const YamlTree* value = find(name);
    if (!value) return {};
    if (value->kind != YamlTree::Kind::scalar)
      fail_at(file_, *value, name, "got " + value->described(), "a text");
    return value->text;
  }

  int claim(const std::string& name) const {
    const YamlTree* value = find(name);
    if (!value) return 0;
    const bool digits = value->kind == YamlTree::Kind::scalar && !value->text.empty() &&
                        value->text.size() <= 2 && value->text[0] != '0' &&
                        std::all_of(value->text.begin(), value->text.end(),
                                    [](char c) { return c >= '0' && c <= '9'; });
    const int order = digits ? std::stoi(value->text) : 0;
    if (order < 1 || order > highest_order_checked)
      fail_at(file_, *value, name, "got " + value->described(),
              fmt::format("a whole number from 1 to {}", highest_order_checked));
    return order;
  }

  Coefficient number(const YamlTree& value, const std::string& name) const {
    if (value.kind != YamlTree::Kind::scalar)
      fail_at(file_, value, name, "got " + value.described(), "a number");
    try {
      return parse_coefficient(value.text);
    } catch (const CoefficientError& error) {
      fail_at(file_, value, name, fmt::format("{}; got {}", error.what(), value.described()),
              "a number such as 2/9, 0.25, 1e-3 or (2 - sqrt(2))/2");
    }
  }

  std::vector<Coefficient> row(const YamlTree& value, const std::string& name,
                               std::size_t stages) const {
    if (value.kind != YamlTree::Kind::list || value.items.size() != stages)
      fail_at(file_, value, name, "got " + value.described(),
              fmt::format("a list of {}, as many as A has rows", stages));
    std::vector<Coefficient> numbers;
    for (std::size_t i = 0; i < stages; ++i)
      numbers.push_back(number(value.items[i], fmt::format("{}[{}]", name, i + 1)));
    return numbers;
  }

  std::vector<Coefficient> matrix(const YamlTree& value, const Written& w) const {
    if (w.stages > most_stages)
      fail_at(file_, value, "A", fmt::format("got {} rows", w.stages),
              fmt::format("at most {}", most_stages));
    std::vector<Coefficient> a;
    const Coefficient zero = parse_coefficient("0");
    for (std::size_t i = 0; i < w.stages; ++i) {
      const YamlTree& line = value.items[i];
      const std::string name = fmt::format("A[{}]", i + 1);
      if (line.kind != YamlTree::Kind::list || line.items.size() > w.stages)
        fail_at(file_, line, name, "got " + line.described(),
                fmt::format("a list of at most {}, the number of rows", w.stages));
      for (std::size_t j = 0; j < w.stages; ++j)
        a.push_back(j < line.items.size()
                        ? number(line.items[j], fmt::format("A[{}][{}]", i + 1, j + 1))
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

  const YamlTree& tree_;
  const std::string& file_;
};

}  // namespace

TableauFile read_tableau(const YamlTree& tree, const std::string& file) {
  return Reader(tree, file).read();
}

TableauFile read_tableau_file(const std::string& path) {
  return read_tableau(read_yaml_file(path), path);
}

}  // namespace odeum
