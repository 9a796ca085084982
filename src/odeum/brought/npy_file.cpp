// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "odeum/brought/table_file.hpp"
#include "odeum/input/yaml_tree.hpp"

// The format: NumPy's documentation, numpy.lib.format, versions 1.0 to 3.0.
namespace odeum::brought {
namespace {

static_assert(std::endian::native == std::endian::little);

/// What follows a key of the header's dictionary, up to `end`.
std::string_view value_of(std::string_view header, std::string_view key, char end) {
  const std::size_t at = header.find(key);
  if (at == std::string_view::npos) return {};
  header.remove_prefix(at + key.size());
  return header.substr(0, header.find(end));
}

template <class Number>
double number_at(const char* bytes) {
  Number number;
  std::memcpy(&number, bytes, sizeof number);
  return static_cast<double>(number);
}

struct Kind {
  std::string_view name;
  std::size_t bytes;
  double (*read)(const char*);
};
constexpr Kind kinds[] = {{"<f8", 8, number_at<double>},        {"<f4", 4, number_at<float>},
                          {"<i8", 8, number_at<std::int64_t>},  {"<i4", 4, number_at<std::int32_t>},
                          {"<u8", 8, number_at<std::uint64_t>}, {"|i1", 1, number_at<std::int8_t>}};

}  // namespace

std::vector<std::vector<double>> read_npy(const std::string& path, const std::string& bytes,
                                          bool& single) {
  const auto fail = [&](const std::string& what) -> InputError { return {path, {1, 1}, what}; };
  constexpr std::size_t version_at = 6, length_at = 8;
  if (bytes.size() < length_at + 4) throw fail("got an array of NumPy that is cut short");
  const bool short_length = bytes[version_at] == 1;
  const std::size_t begin = length_at + (short_length ? 2 : 4);
  const auto length =
      static_cast<std::size_t>(short_length ? number_at<std::uint16_t>(bytes.data() + length_at)
                                            : number_at<std::uint32_t>(bytes.data() + length_at));
  if (length > bytes.size() - begin) throw fail("got an array of NumPy that is cut short");
  const std::string_view header(bytes.data() + begin, length);

  const std::string_view descr = value_of(header, "'descr': '", '\'');
  const Kind* kind = nullptr;
  for (const Kind& each : kinds)
    if (each.name == descr) kind = &each;
  if (!kind)
    throw fail(fmt::format("got an array of {}, expected real numbers: <f8 or <f4",
                           descr.empty() ? "several types" : shown(descr)));
  single = kind->name == "<f4";
  const bool by_column = value_of(header, "'fortran_order': ", ',') == "True";
  std::vector<std::size_t> shape;
  std::size_t number = 0;
  bool open = false;
  for (const char c : value_of(header, "'shape': (", ')')) {
    if (c >= '0' && c <= '9') {
      number = (open ? number : 0) * 10 + static_cast<std::size_t>(c - '0');
      open = true;
      if (number > bytes.size()) throw fail("got a shape that is larger than the file");
    } else if (open) {
      shape.push_back(number);
      open = false;
    }
  }
  if (open) shape.push_back(number);
  if (shape.size() != 2)
    throw fail(
        fmt::format("got an array of {} dimensions, expected two: a row a time, its first "
                    "column the time",
                    shape.size()));
  const std::size_t rows = shape[0], columns = shape[1];
  if (rows < 2 || columns < 2 || rows > bytes.size() / columns / kind->bytes ||
      bytes.size() - begin - length != rows * columns * kind->bytes)
    throw fail(fmt::format("got {} bytes for {} x {} numbers of {}", bytes.size() - begin - length,
                           rows, columns, descr));
  const char* const data = bytes.data() + begin + length;
  std::vector<std::vector<double>> table(rows, std::vector<double>(columns));
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < columns; ++k)
      table[i][k] = kind->read(data + (by_column ? k * rows + i : i * columns + k) * kind->bytes);
  return table;
}

}  // namespace odeum::brought
