// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "odeum/formula/parser.hpp"

namespace odeum::formula {

/// A place in the text of an expression: what its reader takes from there, and the messages where
/// it is something else. All throw ExpressionError.
class Cursor {
 public:
  explicit Cursor(std::string_view text) : text_(text) {}

 protected:
  template <class... Values>
  [[noreturn]] static void fail(std::size_t at, fmt::format_string<Values...> what,
                                Values&&... values) {
    throw ExpressionError(at, fmt::format(what, std::forward<Values>(values)...));
  }
  /// Counts levels of nesting while it exists.
  class Level {
   public:
    explicit Level(Cursor& cursor) : depth_(cursor.depth_) {
      if (depth_ >= deepest_nesting)
        fail(cursor.at_, "nested too deeply; got more than {} levels, expected at most that",
             deepest_nesting);
      ++depth_;
    }
    ~Level() { --depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    int& depth_;
  };
  /// Something other than an operator or the end follows an operand.
  [[noreturn]] void unexpected(char c) const;
  /// The next character that is not a space; 0: the end.
  char peek();
  bool take(char c);
  /// `where`: what is open.
  void expect(char c, const char* where);
  long double number();
  static void require_finite(std::size_t where, long double value);

  std::string_view text_;
  std::size_t at_ = 0;

 private:
  int depth_ = 0;
};

}  // namespace odeum::formula
