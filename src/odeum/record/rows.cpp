// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/rows.hpp"

#include <algorithm>
#include <map>
#include <optional>

#include "odeum/input/text_file.hpp"
#include "odeum/record/compress.hpp"
#include "odeum/record/records.hpp"

namespace odeum::record::detail {
namespace {

constexpr char separator = '\x1f';

/// Reads back what csv_text wrote: a header, then rows of as many fields. Points into
/// the text.
class CsvSource : public FieldSource {
 public:
  explicit CsvSource(std::string_view text) : rest_(text) {
    if (!read_row()) return;
    for (std::size_t i = 0; i < row_.size(); ++i) columns_[row_[i]] = i;
    broken_ = columns_.size() != row_.size();  // a name twice
    if (broken_) columns_.clear();
  }
  /// The next row; false at the end, or at a row of another length, see broken().
  bool next_row() {
    if (broken_ || !read_row()) return false;
    broken_ = row_.size() != columns_.size();
    return !broken_;
  }
  bool broken() const { return broken_; }
  std::vector<std::string> columns() const {
    std::vector<std::string> names(columns_.size());
    for (const auto& [name, at] : columns_) names[at] = name;
    return names;
  }
  bool has(const std::string& column) const { return columns_.contains(column); }
  std::string next(const std::string& column) override {
    return text_of_field(row_[columns_.at(column)]);
  }

 private:
  bool read_row();

  std::string_view rest_;
  std::map<std::string, std::size_t> columns_;
  std::vector<std::string> row_;
  bool broken_ = false;
};

// One line: a field may be quoted, and then holds commas and doubled quotes; no line breaks are
// written within one. A last line without an end was cut off.
bool CsvSource::read_row() {
  if (rest_.empty()) return false;
  row_.assign(1, "");
  bool quoted = false;
  for (std::size_t i = 0; i < rest_.size(); ++i) {
    const char c = rest_[i];
    if (c == '\n') {
      rest_.remove_prefix(i + 1);
      return true;
    }
    if (c == '"' && quoted && i + 1 < rest_.size() && rest_[i + 1] == '"')
      row_.back() += rest_[++i];
    else if (c == '"')
      quoted = !quoted;
    else if (c == ',' && !quoted)
      row_.emplace_back();
    else
      row_.back() += c;
  }
  broken_ = true;
  return false;
}

}  // namespace

std::string read_csv(const std::filesystem::path& folder, const std::string& name, int schema,
                     const Fields& blank, const std::function<void(FieldSource&)>& read) {
  std::optional<std::string> text = text_of_file(folder / name);
  if (!text) return {};
  const std::string subject = "the earlier " + name + " ";
  if (name.ends_with(".gz") && !(text = text_of_gzip(*text)))
    return subject + "is damaged or cut off";
  CsvSource csv(*text);
  if (!csv.has("schema") ||
      !std::ranges::all_of(blank, [&](const Field& field) { return csv.has(field.column); }))
    return subject + "has other columns (another version?)";
  try {
    while (csv.next_row()) {
      if (integer_of(csv.next("schema")) != schema) throw BadField();
      read(csv);
    }
  } catch (const BadField&) {
    return subject + "has a field that is not a number, or another schema";
  }
  return csv.broken() ? subject + "is truncated" : "";
}

}  // namespace odeum::record::detail

namespace odeum::record {

Records read_records(const std::filesystem::path& folder, const std::string& name) {
  std::optional<std::string> text = text_of_file(folder / name);
  if (text && name.ends_with(".gz")) text = text_of_gzip(*text);
  if (!text) throw FileError((folder / name).string() + ": cannot be read");
  return records_of(*text, (folder / name).string());
}

Records records_of(std::string_view text, const std::string& name) {
  detail::CsvSource csv(text);
  Records records;
  records.columns = csv.columns();
  while (csv.next_row()) {
    std::vector<Cell>& row = records.rows.emplace_back();
    for (const std::string& column : records.columns) row.emplace_back(csv.next(column));
  }
  if (csv.broken() || records.columns.empty())
    throw FileError(name + ": is not a table, or is cut off");
  return records;
}

}  // namespace odeum::record

namespace odeum::record::detail {

void add_to_record(const Fields& fields, std::string& record) {
  for (const Field& field : fields) record += cell_text(field.value) + separator;
}

std::string RecordSource::next(const std::string&) {
  const std::size_t end = rest_.find(separator);
  if (end == std::string_view::npos) throw BadField();
  const std::string value(rest_.substr(0, end));
  rest_.remove_prefix(end + 1);
  return value;
}

}  // namespace odeum::record::detail
