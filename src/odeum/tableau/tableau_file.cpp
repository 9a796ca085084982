// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/tableau/tableau_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "odeum/input/mapping.hpp"
#include "odeum/input/text_file.hpp"

namespace odeum {
namespace {

using input::Value;

using Written = DynamicTableau<Coefficient>;  // as in the file; without nodes where it has none

class Reader {
 public:
  Reader(const YamlNode& root, const std::string& file)
      : reading_{.file = file, .format = "tableau"},
        root_({reading_, root, ""},
              {"name", "source", "order", "order_embedded", "c", "A", "b", "b_hat"}) {}

  TableauFile read() {
    TableauFile result;
    result.name = root_.text_or("name", "");
    result.source = root_.text_or("source", "");
    Written w;
    w.a = matrix(root_.at("A"), w);
    w.b = row(root_.at("b"), w.stages);
    root_.with("c", [&](const Value& c) { w.c = row(c, w.stages); });
    result.has_nodes = root_.has("c");
    root_.with("b_hat", [&](const Value& b_hat) { w.b_hat = row(b_hat, w.stages); });
    w.order = claim("order");
    w.order_hat = claim("order_embedded");
    if (w.order_hat != 0 && w.b_hat.empty())
      root_.at("order_embedded").fail("claim without the row", "b_hat");

    bool exact = true;
    for (const auto* list : {&w.a, &w.b, &w.c, &w.b_hat})
      for (const Coefficient& x : *list) {
        exact = exact && x.rational;
        result.rounding.absolute = std::max(result.rounding.absolute, x.uncertainty);
      }
    if (exact)
      result.tableau = convert<mpq_class>(w, [](const Coefficient& x) { return x.exact; });
    else
      result.tableau = convert<mpf_class>(w, [](const Coefficient& x) { return x.value; });
    result.rounded = convert<double>(w, [](const Coefficient& x) { return x.value.get_d(); });
    // Rounding of a root to 512 bits, with a margin for the sums that it enters.
    if (!exact) result.rounding.relative = 1e-140;
    return result;
  }

 private:
  int claim(std::string_view key) const {
    return root_.has(key) ? static_cast<int>(root_.at(key).whole(1, highest_order_checked)) : 0;
  }

  static Coefficient number(const Value& value) {
    if (value.node().kind != YamlNode::Kind::scalar) value.fail("", "a number");
    try {
      return parse_coefficient(value.node().text);
    } catch (const CoefficientError& error) {
      value.fail(error.what(), "a number such as 2/9, 0.25, 1e-3 or (2 - sqrt(2))/2");
    }
  }

  static std::vector<Coefficient> row(const Value& value, std::size_t stages) {
    std::vector<Coefficient> numbers;
    const std::string expected = fmt::format("a list of {}, as many as A has rows", stages);
    for (const Value& each : value.list_of(stages, expected, 1)) numbers.push_back(number(each));
    return numbers;
  }

  static std::vector<Coefficient> matrix(const Value& value, Written& w) {
    const std::vector<Value> rows = value.list(1);
    w.stages = rows.size();
    if (rows.empty()) value.fail("", "a list with an entry a stage");
    if (w.stages > most_stages)
      value.fail("", fmt::format("{} rows", w.stages), fmt::format("at most {}", most_stages));
    std::vector<Coefficient> a;
    const Coefficient zero = parse_coefficient("0");
    for (std::size_t i = 0; i < w.stages; ++i) {
      const Value& line = rows[i];
      if (!line.is_list() || line.node().items.size() > w.stages)
        line.fail("", fmt::format("a list of at most {}, the number of rows", w.stages));
      for (const Value& each : line.list(1)) a.push_back(number(each));
      a.resize((i + 1) * w.stages, zero);
    }
    return a;
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

  input::Reading reading_;
  input::Mapping root_;
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
