// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include "odeum/record/csv.hpp"
#include "odeum/record/csv_reader.hpp"

namespace odeum::record {

/// The rows of a file that an earlier run wrote, and why they could not be used, in a sentence;
/// both empty where there is no file.
template <class Row>
struct EarlierRows {
  std::vector<Row> rows;
  std::string problem;
};

/// Reads back what CsvTable wrote to folder/name. `row_of(csv)` gives the row that the reader
/// stands at and throws std::bad_optional_access where a number is none. All rows or none.
template <class Row, class RowOf>
EarlierRows<Row> read_earlier(const std::filesystem::path& folder, const std::string& name,
                              const std::vector<std::string>& columns, RowOf&& row_of) {
  EarlierRows<Row> earlier;
  std::ifstream in(folder / name, std::ios::binary);
  if (!in) return earlier;
  const std::string text(std::istreambuf_iterator<char>(in), {});
  CsvReader csv(text);
  const std::string subject = "the " + name + " that was there ";
  const auto missing = [&](const std::string& column) { return !csv.has(column); };
  if (missing("schema") || std::any_of(columns.begin(), columns.end(), missing)) {
    earlier.problem = subject + "has other columns: of another version?";
    return earlier;
  }
  try {
    while (csv.next()) {
      if (csv.number("schema").value() != csv_schema) throw std::bad_optional_access();
      earlier.rows.push_back(row_of(csv));
    }
  } catch (const std::bad_optional_access&) {
    earlier.problem = subject + "holds what is no number, or another schema";
  }
  if (csv.broken()) earlier.problem = subject + "is cut off";
  if (!earlier.problem.empty()) earlier.rows.clear();
  return earlier;
}

}  // namespace odeum::record
