// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>

#include "odeum/input/yaml_tree.hpp"

namespace odeum::fem {

/// The words of a text, with their places.
class TokenReader {
 public:
  TokenReader(const std::string& file, std::string_view text) : file_(file), text_(text) {}

  /// The next word; empty at the end.
  std::string_view next() {
    while (at_ < text_.size() && is_space(text_[at_])) step();
    start_ = at_, place_ = {line_, column()};
    while (at_ < text_.size() && !is_space(text_[at_])) ++at_;
    return text_.substr(start_, at_ - start_);
  }
  /// A text in quotes on one line.
  std::string quoted(const char* what) {
    while (at_ < text_.size() && is_space(text_[at_])) step();
    start_ = at_, place_ = {line_, column()};
    const std::size_t end = text_.find_first_of("\"\n", std::min(at_ + 1, text_.size()));
    if (at_ >= text_.size() || text_[at_] != '"' || end == std::string_view::npos ||
        text_[end] != '"')
      refuse(what, next(), "a name in double quotes");
    at_ = end + 1;
    return std::string(text_.substr(start_ + 1, end - start_ - 1));
  }
  template <class Number>
  Number number(const char* what, const char* expected) {
    const std::string_view word = next();
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size()) refuse(what, word, expected);
    return value;
  }
  std::size_t count(const char* what) { return number<std::size_t>(what, "a whole number from 0"); }
  int integer(const char* what) { return number<int>(what, "a whole number"); }
  double real(const char* what) {
    const auto value = number<double>(what, "a number");
    if (!std::isfinite(value)) refuse(what, text_.substr(start_, at_ - start_), "a finite number");
    return value;
  }
  void expect(const std::string& word) {
    if (const std::string_view got = next(); got != word) refuse("the section", got, word);
  }

  Place place() const { return place_; }  ///< of the last word
  [[noreturn]] void refuse(const std::string& key, std::string_view got,
                           const std::string& expected) const {
    throw InputError(file_, place_,
                     fmt::format("{}: not understood; got {}, expected {}", key,
                                 got.empty() ? "the end of the file" : shown(got), expected));
  }
  [[noreturn]] void fail(Place place, const std::string& what) const {
    throw InputError(file_, place, what);
  }

 private:
  static bool is_space(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }
  void step() {
    if (text_[at_++] == '\n') ++line_, line_start_ = at_;
  }
  /// Counts characters: bytes that do not continue one of UTF-8.
  std::size_t column() const {
    return 1 + static_cast<std::size_t>(std::count_if(
                   text_.begin() + static_cast<long>(line_start_),
                   text_.begin() + static_cast<long>(at_),
                   [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
  }

  const std::string& file_;
  std::string_view text_;
  std::size_t at_ = 0, start_ = 0, line_ = 1, line_start_ = 0;
  Place place_;
};

}  // namespace odeum::fem
