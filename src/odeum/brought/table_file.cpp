// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/brought/table_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "odeum/input/csv_text.hpp"
#include "odeum/input/text_file.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::brought {
namespace {

constexpr std::size_t most_bytes = 512'000'000;
constexpr int digits_of_double = 15;  // more are those of the nearest double

/// What the words of a column have been so far.
struct Written {
  bool exponents = false;
  int least_decimals = 1000;  ///< a fixed number of them is that of all words

  void note(std::string_view word, Column& column) {
    int digits = 0, after = -1;
    bool leading = true;
    for (const char c : word) {
      if (c == 'e' || c == 'E') exponents = true;
      if (c == 'e' || c == 'E' || c == 'n' || c == 'i') break;
      if (c == '.' || c == ',') after = 0;
      if (c < '0' || c > '9') continue;
      if (after >= 0) ++after;
      leading = leading && c == '0';
      if (!leading) ++digits;
    }
    column.digits = std::max(column.digits, digits);
    column.decimals = std::max(column.decimals, after);
    least_decimals = std::min(least_decimals, after);
  }
};

class Reader {
 public:
  Reader(const std::string& path, std::string_view text) : lines_(text) { file_.path = path; }

  TableFile read() {
    while (lines_.next()) line(lines_.line());
    if (file_.lines.size() < 2)
      throw InputError(file_.path, {std::max<std::size_t>(lines_.number(), 1), 1},
                       fmt::format("got {} rows of numbers, expected two at least: the times and "
                                   "states of a run",
                                   file_.lines.size()));
    // Doubles whose shortest text is short are no less exact than those beside them.
    const bool all_digits = std::ranges::any_of(
        file_.columns, [](const Column& column) { return column.digits >= digits_of_double; });
    for (std::size_t k = 0; k < file_.columns.size(); ++k) {
      Column& column = file_.columns[k];
      if (all_digits) column.digits = std::max(column.digits, digits_of_double);
      if (written_[k].exponents || written_[k].least_decimals != column.decimals)
        column.decimals = -1;
      column.single = std::ranges::all_of(column.values, [](double value) {
        return std::isnan(value) || value == static_cast<double>(static_cast<float>(value));
      });
    }
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& what) const {
    throw InputError(file_.path, {lines_.number(), column}, what);
  }

  void line(std::string_view line) {
    if (line.find('\0') != std::string_view::npos) fail(1, "got a binary file, expected text");
    const std::string_view content = input::trimmed(line);
    if (content.front() == '#' || content.front() == '%')
      comment_ = content.substr(1);
    else if (file_.columns.empty())
      first(line);
    else
      row(line);
  }

  /// The first line that is not a comment: the header, or numbers.
  void first(std::string_view line) {
    separator_ = input::separator_of(line);
    const std::vector<input::Cell> words = input::cells_of(line, separator_);
    const bool numbers = std::ranges::all_of(words, [&](const input::Cell& word) {
      return input::number_in(word.text, separator_ != ',').has_value();
    });
    std::vector<input::Cell> names = words;
    if (numbers)
      names = input::cells_of(comment_, comment_.find(',') != std::string_view::npos ? ',' : ' ');
    file_.columns.resize(words.size());
    written_.resize(words.size());
    for (std::size_t k = 0; k < words.size(); ++k) {
      if (names.size() == words.size()) file_.columns[k].name = names[k].text;
      file_.columns[k].digits = 0;
    }
    if (numbers) row(line);
  }

  void row(std::string_view line) {
    const std::vector<input::Cell> words = input::cells_of(line, separator_);
    if (words.size() != file_.columns.size())
      fail(1, fmt::format("got {} numbers, expected {}, as in the lines before", words.size(),
                          file_.columns.size()));
    for (std::size_t k = 0; k < words.size(); ++k) {
      const std::optional<double> value = input::number_in(words[k].text, separator_ != ',');
      if (!value)
        fail(words[k].column,
             fmt::format("got {}, expected a number",
                         words[k].text.empty() ? "an empty cell" : shown(words[k].text)));
      written_[k].note(words[k].text, file_.columns[k]);
      file_.columns[k].values.push_back(*value);
    }
    file_.lines.push_back(lines_.number());
  }

  TableFile file_;
  input::Lines lines_;
  std::string_view comment_;
  char separator_ = ',';
  std::vector<Written> written_;
};

bool ascends(const std::vector<double>& values) {
  return std::ranges::is_sorted(values) && values.front() < values.back();
}

/// An array without names whose rows are the times and the components, as NumPy's vstack gives it.
void transpose_where_rows_are_components(TableFile& file) {
  const std::size_t rows = file.lines.size(), columns = file.columns.size();
  if (columns < 3 || !file.columns.front().name.empty() || ascends(file.columns.front().values))
    return;
  std::vector<double> first;
  for (const Column& column : file.columns) first.push_back(column.values.front());
  if (!ascends(first)) return;
  std::vector<Column> turned(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    turned[i].digits = 0;
    turned[i].single = true;
    for (const Column& column : file.columns) {
      turned[i].values.push_back(column.values[i]);
      turned[i].digits = std::max(turned[i].digits, column.digits);
      turned[i].decimals = std::max(turned[i].decimals, column.decimals);
      turned[i].single = turned[i].single && column.single;
    }
  }
  file.columns = std::move(turned);
  file.lines.assign(columns, 1);
}

TableFile table_of(const std::string& path, const std::vector<std::vector<double>>& rows,
                   bool single) {
  TableFile file;
  file.path = path;
  file.columns.resize(rows.front().size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    for (std::size_t k = 0; k < rows[i].size(); ++k) file.columns[k].values.push_back(rows[i][k]);
    file.lines.push_back(i + 1);
  }
  for (Column& column : file.columns) column.single = single;
  return file;
}

}  // namespace

double Column::half_place(double value) const {
  constexpr double half_of_double = 0x1p-53, half_of_single = 0x1p-24;
  const double size = std::abs(value), half = size * (single ? half_of_single : half_of_double);
  if (digits >= digits_of_double || size == 0) return half;
  const double place = decimals >= 0 ? -decimals : std::floor(std::log10(size)) + 1 - digits;
  return std::max(half, 0.5 * std::pow(10, place));
}

TableFile read_table(const std::string& path) {
  const std::string text = read_text_file(path, "trajectory", most_bytes);
  TableFile file;
  if (text.starts_with("\x93NUMPY")) {
    bool single = false;
    file = table_of(path, read_npy(path, text, single), single);
  } else {
    file = Reader(path, text).read();
  }
  transpose_where_rows_are_components(file);
  return file;
}

}  // namespace odeum::brought
