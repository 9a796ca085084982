// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/rows.hpp"

#include <algorithm>
#include <fstream>
#include <optional>

#include "odeum/record/csv_reader.hpp"
#include "odeum/record/gzip.hpp"

namespace odeum::record::detail {
namespace {

constexpr char separator = '\x1f';

class CsvSource : public FieldSource {
 public:
  explicit CsvSource(const CsvReader& csv) : csv_(csv) {}
  std::string next(const std::string& column) override { return csv_.text(column); }
  bool keeps_unlisted() const override { return false; }

 private:
  const CsvReader& csv_;
};

}  // namespace

std::string csv_text(int schema, const Fields& blank, const std::vector<Fields>& rows) {
  std::string text = "schema";
  for (const Field& field : blank) text += ',' + field.column;
  text += '\n';
  for (const Fields& row : rows) {
    text += std::to_string(schema);
    for (const Field& field : row) text += ',' + csv_field(field.value);
    text += '\n';
  }
  return text;
}

std::string read_csv(const std::filesystem::path& folder, const std::string& name, int schema,
                     const Fields& blank, const std::function<void(FieldSource&)>& read) {
  std::ifstream in(folder / name, std::ios::binary);
  if (!in) return {};
  std::string text(std::istreambuf_iterator<char>(in), {});
  const std::string subject = "the earlier " + name + " ";
  if (name.ends_with(".gz")) {
    std::optional<std::string> unpacked = text_of_gzip(text);
    if (!unpacked) return subject + "is damaged or cut off";
    text = std::move(*unpacked);
  }
  CsvReader csv(text);
  CsvSource source(csv);
  if (!csv.has("schema") || !std::all_of(blank.begin(), blank.end(),
                                         [&](const Field& field) { return csv.has(field.column); }))
    return subject + "has other columns (another version?)";
  try {
    while (csv.next()) {
      if (integer_of(csv.text("schema")) != schema) throw BadField();
      read(source);
    }
  } catch (const BadField&) {
    return subject + "has a field that is not a number, or another schema";
  }
  return csv.broken() ? subject + "is truncated" : "";
}

void add_to_record(const Fields& fields, std::string& record) {
  for (const Field& field : fields)
    if (!field.derived) record += cell_text(field.value) + separator;
}

std::string RecordSource::next(const std::string&) {
  const std::size_t end = rest_.find(separator);
  if (end == std::string_view::npos) throw BadField();
  const std::string value(rest_.substr(0, end));
  rest_.remove_prefix(end + 1);
  return value;
}

}  // namespace odeum::record::detail
