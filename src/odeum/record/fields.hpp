// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <charconv>
#include <concepts>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>

#include "odeum/record/csv.hpp"

namespace odeum::record {

/// Writes fields into one text, for the journal; RecordReader reads them back in the same order.
/// Numbers round-trip exactly, texts may hold any character but the separator 0x1f.
class RecordWriter {
 public:
  void field(const std::string& value) { text_ += value + separator; }
  void field(double value) { text_ += record::format_number(value) + separator; }
  void field(std::integral auto value) { text_ += std::to_string(value) + separator; }
  const std::string& text() const { return text_; }
  static constexpr char separator = '\x1f';

 private:
  std::string text_;
};

/// Throws std::runtime_error where the text does not hold the fields that are asked for.
class RecordReader {
 public:
  explicit RecordReader(std::string_view text) : rest_(text) {}
  bool at_end() const { return rest_.empty(); }
  void field(std::string& value) { value = next(); }
  void field(double& value) {
    const std::string_view text = next();
    if (text == "nan")
      value = std::numeric_limits<double>::quiet_NaN();
    else if (text == "inf" || text == "-inf")
      value = (text == "inf" ? 1 : -1) * std::numeric_limits<double>::infinity();
    else
      number(text, value);
  }
  void field(std::integral auto& value) { number(next(), value); }

 private:
  template <class T>
  static void number(std::string_view text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size())
      throw std::runtime_error("malformed journal");
  }
  std::string_view next() {
    const std::size_t end = rest_.find(RecordWriter::separator);
    if (end == std::string_view::npos) throw std::runtime_error("malformed journal");
    const std::string_view value = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return value;
  }
  std::string_view rest_;
};

}  // namespace odeum::record
