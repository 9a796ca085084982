// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/cursor.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

#include "odeum/formula/names.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::formula {

void Cursor::unexpected(char c) const {
  if (c == '\0') fail(at_, "ends too early; got the end, expected a number, a name or (");
  if (c == '<' || c == '>' || c == '=' || c == '!')
    fail(at_, "a comparison outside of a condition; got {}, expected it in if(condition, a, b)", c);
  if (c == '?' || c == ':') fail(at_, "a choice; got {}, expected if(condition, a, b)", c);
  if (c == '%') fail(at_, "not understood; got %, expected mod(a, b)");
  const std::string_view rest = text_.substr(at_);
  for (const std::string_view word : {"and", "or", "&", "|"})
    if (rest.starts_with(word) &&
        (rest.size() == word.size() || !continues_name(rest[word.size()]) || !begins_name(c)))
      fail(at_, "{} outside of a condition; got it, expected it in if(condition, a, b)", word);
  if (continues_name(c) || c == '(')
    fail(at_, "no operator; got {}, expected + - * / or ^ before it (2*x, not 2x)",
         shown(text_.substr(at_, 12)));
  if (c == ',')
    fail(at_,
         "a comma; got it outside of a function's arguments, expected a decimal point or an "
         "operator");
  fail(at_, "not understood; got {}, expected an operator or the end",
       shown(text_.substr(at_, 12)));
}

char Cursor::peek() {
  at_ = std::min(text_.find_first_not_of(" \t\n", at_), text_.size());
  return at_ < text_.size() ? text_[at_] : '\0';
}
bool Cursor::take(char c) {
  if (peek() != c) return false;
  ++at_;
  return true;
}
void Cursor::expect(char c, const char* where) {
  if (take(c)) return;
  const std::string got = peek() == '\0' ? "the end" : shown(text_.substr(at_, 12));
  fail(at_, "{}; got {}, expected {}{}", where, got, c,
       peek() == '\0' ? " (within { } of YAML, quote an expression with a comma)" : "");
}

long double Cursor::number() {
  long double value = 0;
  const char* const begin = text_.data() + at_;
  const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
  const std::string_view read(begin, static_cast<std::size_t>(end - begin));
  // The range is that of a double; from_chars calls an underflow out of range, too.
  constexpr auto least = static_cast<long double>(std::numeric_limits<double>::min());
  if (error == std::errc::result_out_of_range || (value != 0 && value < least) ||
      value > static_cast<long double>(std::numeric_limits<double>::max()))
    fail(at_, "a number out of range; got {}, expected 0 or 2.3e-308 to 1.8e308", shown(read));
  if (error != std::errc{})
    fail(at_, "not a number; got {}, expected digits", shown(text_.substr(at_, 12)));
  at_ += read.size();
  if (at_ < text_.size() && text_[at_] == '.')
    fail(at_, "a number has two decimal points; got a second one, expected at most one");
  return value;
}

void Cursor::require_finite(std::size_t where, long double value) {
  if (std::isnan(value))
    fail(where,
         "a constant part is not a number; got nan (0/0, or the root or logarithm of a "
         "negative number), expected a finite number");
  if (std::abs(value) > static_cast<long double>(std::numeric_limits<double>::max()))
    fail(where,
         "a constant part is too large; got {}, expected at most 1.8e308 (a division by zero?)",
         std::isinf(value) ? "infinity" : fmt::format("{:.3Lg}", value));
}

}  // namespace odeum::formula
