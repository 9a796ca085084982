// SPDX-License-Identifier: BSD-3-Clause
#include <fstream>
#include <optional>
#include <sstream>

#include "odeum/report/csv.hpp"
#include "odeum/report/csv_reader.hpp"
#include "odeum/study/material_rows.hpp"

namespace odeum::study {
namespace {

struct AddField {
  report::CsvRow& line;
  void operator()(const char*, const std::string& value) const { line.text(value); }
  void operator()(const char*, double value) const { line.number(value); }
  void operator()(const char*, std::uint64_t value) const { line.count(value); }
};

struct ReadField {
  const report::CsvReader& csv;
  void operator()(const char* column, std::string& value) const { value = csv.text(column); }
  void operator()(const char* column, double& value) const { value = csv.number(column).value(); }
  void operator()(const char* column, std::uint64_t& value) const {
    const double number = csv.number(column).value();
    if (!(number >= 0 && number < 1e15)) throw std::bad_optional_access();
    value = static_cast<std::uint64_t>(number);
  }
};

template <class Row>
void write(const std::vector<Row>& rows, const report::OutputFolder& folder) {
  std::string columns;
  const Row blank;
  Row::each(blank, [&](const char* column, const auto&) {
    if (!columns.empty()) columns += ',';
    columns += column;
  });
  report::CsvTable table(columns);
  for (const Row& row : rows) {
    report::CsvRow line;
    Row::each(row, AddField{line});
    table.add(line);
  }
  folder.write(Row::file, table.text());
}

template <class Row>
void read(const std::filesystem::path& folder, std::vector<Row>& rows, std::string& problem) {
  std::ifstream in(folder / Row::file, std::ios::binary);
  if (!in) return;
  std::ostringstream all;
  all << in.rdbuf();
  const std::string text = all.str();
  report::CsvReader csv(text);
  const std::string which = std::string("the ") + Row::file + " that was there ";
  bool complete = csv.has("schema");
  const Row blank;
  Row::each(blank,
            [&](const char* column, const auto&) { complete = complete && csv.has(column); });
  if (!complete) {
    problem = which + "has other columns: of another version?";
    return;
  }
  std::string wrong;
  try {
    while (csv.next()) {
      if (csv.number("schema").value() != report::csv_schema) throw std::bad_optional_access();
      Row row;
      Row::each(row, ReadField{csv});
      rows.push_back(std::move(row));
    }
  } catch (const std::bad_optional_access&) {
    wrong = "holds what is no number, or another schema";
  }
  if (csv.broken()) wrong = "is cut off";
  if (wrong.empty()) return;
  problem = which + wrong;
  rows.clear();
}

}  // namespace

void write_csv(const MaterialResult& result, const report::OutputFolder& folder) {
  write(result.material, folder);
  write(result.errors, folder);
  write(result.long_run, folder);
  // A run of chosen solvers times no engine, and leaves what an earlier run timed.
  if (!result.cost.empty()) write(result.cost, folder);
  if (!result.implicit_wins.empty()) write(result.implicit_wins, folder);
}

MaterialResult read_material_csv(const std::filesystem::path& folder) {
  MaterialResult result;
  read(folder, result.material, result.problem);
  read(folder, result.errors, result.problem);
  read(folder, result.long_run, result.problem);
  read(folder, result.cost, result.problem);
  read(folder, result.implicit_wins, result.problem);
  return result;
}

}  // namespace odeum::study
