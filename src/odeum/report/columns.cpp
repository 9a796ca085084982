// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/columns.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "odeum/record/compress.hpp"
#include "odeum/report/text.hpp"

namespace odeum::report {
namespace {

std::string quoted(const std::string& text) { return nlohmann::json(plain(text)).dump(); }

double number_in(const record::Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return *number;
  if (const auto* count = std::get_if<std::uint64_t>(&cell)) return static_cast<double>(*count);
  return static_cast<double>(std::get<std::int64_t>(cell));
}

std::string column_json(const std::vector<record::Fields>& rows, std::size_t index) {
  std::vector<std::string> items, words;
  std::map<std::string, std::size_t> known;
  for (const auto& row : rows) {
    const record::Cell& cell = row[index].value;
    const auto* text = std::get_if<std::string>(&cell);
    if (!text) {
      items.push_back(json_number(number_in(cell)));
      continue;
    }
    const auto [place, is_new] = known.try_emplace(*text, words.size());
    if (is_new) words.push_back(quoted(*text));
    items.push_back(std::to_string(place->second));
  }
  const std::string list = fmt::format("[{}]", fmt::join(items, ","));
  return known.empty() ? list
                       : fmt::format("{{\"words\":[{}],\"of\":{}}}", fmt::join(words, ","), list);
}

}  // namespace

std::string json_number(double value) {
  if (std::isnan(value)) return "null";
  if (std::isinf(value)) return value > 0 ? "\"inf\"" : "\"-inf\"";
  return fmt::format("{:.8g}", value);
}

std::string columns_json(const std::vector<record::Fields>& rows,
                         const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names)
    for (std::size_t i = 0; !rows.empty() && i < rows.front().size(); ++i)
      if (rows.front()[i].column == name)
        text += (text.empty() ? "" : ",") + quoted(name) + ":" + column_json(rows, i);
  return "{" + text + "}";
}

std::string data_script(const std::string& name, const std::string& json) {
  return fmt::format("odeum.receive([{},\"{}\"]);\n", quoted(name), base64(record::zlib_of(json)));
}

}  // namespace odeum::report
