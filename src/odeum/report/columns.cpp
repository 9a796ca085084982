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

std::string column_json(const std::vector<record::Fields>& rows, std::size_t index) {
  std::vector<std::string> items, words;
  std::map<std::string, std::size_t> known;
  const auto add = [&]<class T>(const T& value) {
    if constexpr (std::is_arithmetic_v<T>) {
      items.push_back(json_number(static_cast<double>(value)));
    } else {
      const auto [place, is_new] = known.try_emplace(value, words.size());
      if (is_new) words.push_back(quoted(value));
      items.push_back(std::to_string(place->second));
    }
  };
  for (const auto& row : rows) std::visit(add, row[index].value);
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
