// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "odeum/record/csv.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/record/row.hpp"

/// Operations on lists of rows. A Result is a struct of such lists, one for each file, that names
/// them once:
///
///   struct DriftResult {
///     std::vector<DriftRow> rows;
///     std::vector<HorizonRow> horizons;
///     static auto lists(auto& result) { return std::tie(result.rows, result.horizons); }
///   };
namespace odeum::record {

namespace detail {

/// The schema of a row's file: its own, raised where a column changes, or that of all files.
template <class Row>
constexpr int schema_of() {
  if constexpr (requires { Row::schema; }) return Row::schema;
  return csv_schema;
}

/// Calls `read` for every row of folder/name, which must have the columns of `blank`. Returns a
/// sentence why the file cannot be used; empty where it was read or does not exist.
std::string read_csv(const std::filesystem::path& folder, const std::string& name, int schema,
                     const Fields& blank, const std::function<void(FieldSource&)>& read);

/// Consecutive fields as in the store: exact, with any characters but 0x1f.
void add_to_record(const Fields& fields, std::string& record);
class RecordSource : public FieldSource {
 public:
  explicit RecordSource(std::string_view text) : rest_(text) {}
  std::string next(const std::string& column) override;
  bool ended() const { return rest_.empty(); }

 private:
  std::string_view rest_;
};

/// Rows of a group were measured together and stay together: those of a case and a solver, or of a
/// case where the rows are compared with one another (`Row::compared_within_case`).
using Group = std::pair<std::string, std::string>;
template <class Row>
Group group_of(const Row& row) {
  Group group;
  if constexpr (requires { row.case_id; }) group.first = row.case_id;
  if constexpr (
      !requires { Row::compared_within_case; } && requires { row.library; })
    group.second = row.library + "/" + row.solver;
  return group;
}

}  // namespace detail

/// The text of a row's file: a header, then a line a row.
template <class Row>
std::string csv_text(const std::vector<Row>& rows) {
  std::string text = csv_header(fields_of(Row()));
  for (const Row& row : rows) text += csv_line(detail::schema_of<Row>(), fields_of(row));
  return text;
}

/// Writes folder/Row::file. Where there are no rows and the Row has `keeps_earlier`, an existing
/// file is left unchanged.
template <class Row>
void write_rows(const std::vector<Row>& rows, const OutputFolder& folder) {
  if constexpr (requires { Row::keeps_earlier; })
    if (rows.empty()) return;
  folder.write(Row::file, csv_text(rows));
}

/// The table folder/name as it stands, whatever its columns are: cells are text. Throws FileError
/// for a file that is damaged or is not such a table.
Records read_records(const std::filesystem::path& folder, const std::string& name);

/// The rows of folder/Row::file from an earlier run, all or none; none where there is no file.
/// Where it cannot be used, a sentence is added to `problem`.
template <class Row>
std::vector<Row> read_rows(const std::filesystem::path& folder, std::string& problem) {
  std::vector<Row> rows;
  const std::string why =
      detail::read_csv(folder, Row::file, detail::schema_of<Row>(), fields_of(Row()),
                       [&](FieldSource& source) { rows.push_back(row_of<Row>(source)); });
  if (why.empty()) return rows;
  problem += (problem.empty() ? "" : "; ") + why;
  return {};
}

/// Whether the file of a row is large, and compressed for that.
template <class Row>
constexpr bool is_compressed() {
  return std::string_view(Row::file).ends_with(".gz");
}

/// Calls work(list) for each list of a result.
template <class Result, class Work>
void for_each_list(Result& result, Work&& work) {
  std::apply([&](auto&... list) { (work(list), ...); }, Result::lists(result));
}

namespace detail {

/// Calls work(list, other) for each list of `to` and the same one of `from`.
template <class Result, class Work>
void for_both(Result& to, Result& from, Work&& work) {
  auto first = Result::lists(to), second = Result::lists(from);
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (work(std::get<I>(first), std::get<I>(second)), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(first)>>());
}

}  // namespace detail

/// Writes the file of every list.
template <class Result>
void write(const Result& result, const OutputFolder& folder) {
  for_each_list(result, [&](const auto& rows) { write_rows(rows, folder); });
}

/// Reads every list, see read_rows.
template <class Result>
Result read(const std::filesystem::path& folder, std::string& problem) {
  Result result;
  for_each_list(result,
                [&]<class Row>(std::vector<Row>& rows) { rows = read_rows<Row>(folder, problem); });
  return result;
}

/// The files by name, each with the fields of a blank row.
using Files = std::vector<std::pair<std::string, Fields>>;
template <class Result>
Files files_of() {
  Files files;
  const Result result;
  for_each_list(result, [&]<class Row>(const std::vector<Row>&) {
    files.emplace_back(Row::file, fields_of(Row()));
  });
  return files;
}

/// Appends the rows of another result.
template <class Result>
void append(Result& result, Result more) {
  detail::for_both(result, more, [](auto& list, auto& other) {
    std::move(other.begin(), other.end(), std::back_inserter(list));
  });
}

/// Adds the rows of an earlier run whose group was not measured now and is still `known(case,
/// solver)`; both names are empty in groups that have none.
template <class Result, class Known>
void add_earlier(Result& result, Result earlier, Known&& known) {
  detail::for_both(result, earlier, [&](auto& list, auto& other) {
    std::set<detail::Group> measured;
    for (const auto& row : list) measured.insert(detail::group_of(row));
    for (auto& row : other)
      if (const detail::Group group = detail::group_of(row);
          !measured.contains(group) && known(group.first, group.second))
        list.push_back(std::move(row));
  });
}

/// A result as a text for the store, and back. Throws BadField for another text.
template <class Result>
std::string to_record(const Result& result) {
  std::string record;
  for_each_list(result, [&](const auto& rows) {
    detail::add_to_record({{"", static_cast<std::uint64_t>(rows.size())}}, record);
    for (const auto& row : rows) detail::add_to_record(fields_of(row, true), record);
  });
  return record;
}
template <class Result>
Result from_record(std::string_view text) {
  Result result;
  detail::RecordSource source(text);
  for_each_list(result, [&]<class Row>(std::vector<Row>& rows) {
    for (std::int64_t left = integer_of(source.next("")); left > 0; --left)
      rows.push_back(row_of<Row>(source, true));
  });
  if (!source.ended()) throw BadField();
  return result;
}

}  // namespace odeum::record
