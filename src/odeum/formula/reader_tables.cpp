// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "odeum/formula/reader.hpp"
#include "odeum/input/csv_text.hpp"
#include "odeum/input/near_words.hpp"
#include "odeum/input/text_file.hpp"

namespace odeum::formula::reading {
namespace {

constexpr std::string_view table_keys[] = {"file", "columns", "points", "between", "outside"};
constexpr std::size_t most_table_bytes = 8'000'000;

/// Two columns of a CSV file with a line of names.
class Csv {
 public:
  Csv(std::string file, std::string text) : file_(std::move(file)), text_(std::move(text)) {}

  void read(const std::vector<std::string>& wanted, Table& table) {
    std::vector<std::size_t> at;
    char separator = ',';
    for (input::Lines lines(text_); lines.next();) {
      if (input::trimmed(lines.line()).starts_with('#')) continue;
      if (at.empty()) separator = input::separator_of(lines.line());
      const std::vector<input::Cell> cells = input::cells_of(lines.line(), separator);
      if (at.empty())
        at = places(cells, wanted, lines.number());
      else
        add_row(cells, at, lines.number(), table);
    }
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& what) const {
    throw InputError(file_, {line, 1}, what);
  }
  static std::vector<std::string> texts_of(const std::vector<input::Cell>& cells) {
    std::vector<std::string> texts;
    for (const input::Cell& cell : cells) texts.emplace_back(cell.text);
    return texts;
  }
  std::vector<std::size_t> places(const std::vector<input::Cell>& names,
                                  const std::vector<std::string>& wanted, std::size_t line) const {
    if (wanted.empty()) {
      if (names.size() != 2)
        fail(line, fmt::format("got {} columns, expected two, or `columns: [time, value]` of the "
                               "text to name them",
                               names.size()));
      return {0, 1};
    }
    std::vector<std::size_t> all;
    for (const std::string& name : wanted) {
      const auto found = std::ranges::find(names, name, &input::Cell::text);
      if (found == names.end())
        fail(line, fmt::format("no such column; got {}, expected one of the file's{}", shown(name),
                               near_one(name, texts_of(names))));
      all.push_back(static_cast<std::size_t>(found - names.begin()));
    }
    return all;
  }
  void add_row(const std::vector<input::Cell>& cells, const std::vector<std::size_t>& at,
               std::size_t line, Table& table) const {
    std::vector<long double> row;
    for (const std::size_t place : at) {
      const auto number = place < cells.size() ? input::number_in(cells[place].text) : std::nullopt;
      if (!number || !std::isfinite(*number))
        fail(line,
             fmt::format("got {} in column {}, expected a finite number",
                         place < cells.size() ? shown(std::string(cells[place].text)) : "nothing",
                         place + 1));
      row.push_back(*number);
    }
    if (!table.x.empty() && !(row[0] > table.x.back()))
      fail(line, fmt::format("not sorted; got {} after {}, expected more than it",
                             static_cast<double>(row[0]), static_cast<double>(table.x.back())));
    if (table.x.size() == most_points)
      fail(line, fmt::format("got more than {} rows, expected at most that", most_points));
    table.x.push_back(row[0]);
    table.y.push_back(row[1]);
  }

  std::string file_, text_;
};

}  // namespace

void Reader::read_tables() {
  for (const Item& item : items("tables")) {
    require_new(item, "tables", item.key);
    constants_.tables[item.key] = read_table(*item.value, "tables: " + item.key);
  }
}

Table Reader::read_table(const YamlNode& node, const std::string& path) {
  const std::vector<Item> all = items(node, path, table_keys);
  const auto find = [&](std::string_view key) { return input::entry_of(all, key); };
  const auto word = [&](std::string_view key, const auto&... words) -> std::string {
    const std::vector<std::string> known{words...};
    const Item* const item = find(key);
    if (!item) return known.front();
    const std::string text = scalar(*item->value, path + ": " + item->key);
    if (std::ranges::find(known, text) == known.end())
      fail(item->value->place, "{}: {}: got {}, expected one of {}", path, key, shown(text),
           fmt::join(known, " "));
    return text;
  };
  Table table;
  const std::string between = word("between", "linear", "cubic", "constant");
  table.between = between == "linear"  ? Table::Between::linear
                  : between == "cubic" ? Table::Between::cubic
                                       : Table::Between::constant;
  const std::string outside = word("outside", "error", "hold", "extrapolate");
  table.outside = outside == "error"  ? Table::Outside::error
                  : outside == "hold" ? Table::Outside::hold
                                      : Table::Outside::extrapolate;
  const Item *const file = find("file"), *const points = find("points"),
                    *const columns = find("columns");
  if (!file == !points)
    fail(node.place, "{}: got {}, expected `file: table.csv` or `points: [[0, 1], [1, 2]]`", path,
         file ? "both file and points" : "neither file nor points");
  if (file) {
    std::filesystem::path name = scalar(*file->value, path + ": file");
    if (name.is_relative()) name = std::filesystem::path(problem_.file).parent_path() / name;
    std::vector<std::string> wanted;
    if (columns) {
      for (const auto& each : columns->value->items)
        wanted.push_back(scalar(*each, path + ": columns"));
      if (wanted.size() != 2)
        fail(columns->value->place, "{}: columns: got {}, expected two, [time, value]", path,
             wanted.size());
    }
    Csv(name.string(), read_text_file(name.string(), "table", most_table_bytes))
        .read(wanted, table);
  } else {
    read_points(*points->value, path + ": points", table);
  }
  if (table.x.size() < 2)
    fail((file ? file : points)->value->place, "{}: got {} points, expected two at least", path,
         table.x.size());
  return table;
}

void Reader::read_points(const YamlNode& list, const std::string& path, Table& table) {
  for (const auto& each : list.items) {
    if (each->kind != YamlNode::Kind::sequence || each->items.size() != 2)
      fail(each->place, "{}: got {}, expected two numbers, [0, 1]", path, each->kind_name());
    const long double x = number(*each->items[0], path), y = number(*each->items[1], path);
    if (!table.x.empty() && !(x > table.x.back()))
      fail(each->place, "{}: not sorted; got {} after {}, expected more than it", path,
           static_cast<double>(x), static_cast<double>(table.x.back()));
    if (table.x.size() == most_points)
      fail(each->place, "{}: got more than {}, expected at most that", path, most_points);
    table.x.push_back(x);
    table.y.push_back(y);
  }
}

namespace {

bool has_word(std::string_view text, std::string_view word) {
  for (std::size_t at = text.find(word); at != std::string_view::npos;
       at = text.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    const bool begins = at == 0 || !continues_name(text[at - 1]);
    if (begins && (end == text.size() || !continues_name(text[end]))) return true;
  }
  return false;
}

bool mentions(const YamlNode& node, std::string_view word) {
  if (node.kind == YamlNode::Kind::scalar) return has_word(node.text, word);
  return std::ranges::any_of(node.items, [&](const auto& each) { return mentions(*each, word); });
}

}  // namespace

void Reader::read_inputs(Scope& scope) {
  for (const Item& item : items("inputs")) {
    require_new(item, "inputs", item.key);
    const bool is_used = std::ranges::any_of(sections_, [&](const Item& section) {
      return section.key != "inputs" && mentions(*section.value, item.key);
    });
    if (!is_used)
      fail(item.key_place, "inputs: named nowhere; got {}, expected it in an equation",
           shown(item.key));
    Id value = no_node;
    if (item.value->kind == YamlNode::Kind::mapping) {
      const Table table = read_table(*item.value, "inputs: " + item.key);
      const std::pair span{problem_.t0, static_cast<long double>(problem_.stops.back())};
      if (!covers(table, span))
        fail(item.value->place,
             "inputs: {}: outside of the table; got times from {} to {}, expected those of the "
             "problem, {} to {}, or `outside: hold` or `extrapolate`",
             item.key, static_cast<double>(table.x.front()), static_cast<double>(table.x.back()),
             static_cast<double>(span.first), static_cast<double>(span.second));
      value = value_at(problem_.graph, table, problem_.graph.time());
    } else {
      Scope of_time = constants_;
      of_time.refused.clear();
      value = expression(item, "inputs", of_time);
    }
    scope.names[item.key] = value;
  }
}

}  // namespace odeum::formula::reading
