// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <zlib.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "support/temporary_folder.hpp"

/// The data of a report's folder, read as the page's scripts read it.
namespace odeum::tests {

/// Undoes report::data_script.
inline nlohmann::json unpacked(const std::string& script) {
  const std::size_t first = script.rfind(",\"") + 2, end = script.rfind("\"]");
  constexpr std::string_view alphabet =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  unsigned bits = 0, held = 0;
  for (const char c : script.substr(first, end - first)) {
    if (c == '=') break;
    held = held << 6U | static_cast<unsigned>(alphabet.find(c));
    if ((bits += 6) < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(held >> bits & 0xffU);
  }
  std::string text(1 << 25, '\0');
  uLongf size = text.size();
  if (::uncompress(reinterpret_cast<Bytef*>(text.data()), &size,
                   reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()) != Z_OK)
    throw std::runtime_error("the data cannot be uncompressed");
  return nlohmann::json::parse(text.substr(0, size));
}

inline nlohmann::json json_of(const std::filesystem::path& file) {
  return nlohmann::json::parse(text_of(file));
}

/// The entry of page.json for a table; null where there is none.
inline nlohmann::json table_in(const std::filesystem::path& folder, const std::string& name) {
  const nlohmann::json page = json_of(folder / "page.json");
  for (const auto& table : page["tables"])
    if (table["name"] == name) return table;
  return nullptr;
}

/// A column of a table, whose parts are joined: numbers, null, "inf" and "-inf", or texts.
inline std::vector<nlohmann::json> column_in(const std::filesystem::path& folder,
                                             const std::string& name, const std::string& column) {
  std::vector<nlohmann::json> values;
  const nlohmann::json parts = table_in(folder, name).at("parts");
  for (const auto& part : parts) {
    const auto all =
        unpacked(text_of(folder / "data" / (part["data"].get<std::string>() + ".js"))).at(column);
    if (all.is_array())
      values.insert(values.end(), all.begin(), all.end());
    else
      for (const auto& index : all["of"]) values.push_back(all["words"][index.get<std::size_t>()]);
  }
  return values;
}

}  // namespace odeum::tests
