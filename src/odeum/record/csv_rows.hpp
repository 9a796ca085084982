// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <concepts>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "odeum/record/csv.hpp"
#include "odeum/record/earlier_csv.hpp"
#include "odeum/record/output_folder.hpp"

/// Files of rows that name their columns once: a Row has its file's name in `Row::file`, and
/// `Row::each(row, visit)` calls visit(column, member) for each. Members are text, numbers, counts,
/// complex numbers (two columns, _re and _im) or enumerations that have a to_string.
namespace odeum::record {

namespace detail {

struct NameColumn {
  std::vector<std::string>& names;
  void operator()(const char* column, const auto&) const { names.emplace_back(column); }
  void operator()(const char* column, const std::complex<double>&) const {
    names.push_back(std::string(column) + "_re");
    names.push_back(std::string(column) + "_im");
  }
};

struct AddField {
  CsvRow& line;
  void operator()(const char*, const std::string& value) const { line.text(value); }
  void operator()(const char*, double value) const { line.number(value); }
  void operator()(const char*, std::unsigned_integral auto value) const { line.count(value); }
  void operator()(const char*, const std::complex<double>& value) const {
    line.number(value.real()).number(value.imag());
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(const char*, Enum value) const { line.text(to_string(value)); }
};

struct ReadField {
  const CsvReader& csv;
  double number(const std::string& column) const { return csv.number(column).value(); }
  void operator()(const char* column, std::string& value) const { value = csv.text(column); }
  void operator()(const char* column, double& value) const { value = number(column); }
  template <std::unsigned_integral Count>
  void operator()(const char* column, Count& value) const {
    const double found = number(column);
    if (!(found >= 0 && found < 1e15)) throw std::bad_optional_access();
    value = static_cast<Count>(found);
  }
  void operator()(const char* column, std::complex<double>& value) const {
    value = {number(std::string(column) + "_re"), number(std::string(column) + "_im")};
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void operator()(const char* column, Enum& value) const {
    constexpr int most_enumerators = 16;
    for (int k = 0; k < most_enumerators; ++k)
      if (value = static_cast<Enum>(k); csv.text(column) == to_string(value)) return;
    throw std::bad_optional_access();
  }
};

template <class Row>
std::vector<std::string> column_names() {
  std::vector<std::string> names;
  const Row row{};
  Row::each(row, NameColumn{names});
  return names;
}

}  // namespace detail

/// Writes folder/Row::file.
template <class Row>
void write_rows(const std::vector<Row>& rows, const OutputFolder& folder) {
  std::string columns;
  for (const std::string& name : detail::column_names<Row>())
    columns += (columns.empty() ? "" : ",") + name;
  CsvTable table(columns);
  for (const Row& row : rows) {
    CsvRow line;
    Row::each(row, detail::AddField{line});
    table.add(line);
  }
  folder.write(Row::file, table.text());
}

/// What an earlier run left in folder/Row::file; nothing where there is none. Where it cannot be
/// used, a sentence is added to `problem`.
template <class Row>
std::vector<Row> read_rows(const std::filesystem::path& folder, std::string& problem) {
  EarlierRows<Row> earlier =
      read_earlier<Row>(folder, Row::file, detail::column_names<Row>(), [](const CsvReader& csv) {
        Row row;
        Row::each(row, detail::ReadField{csv});
        return row;
      });
  if (!earlier.problem.empty()) problem += (problem.empty() ? "" : "; ") + earlier.problem;
  return std::move(earlier.rows);
}

}  // namespace odeum::record
