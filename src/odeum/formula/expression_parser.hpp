// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>
#include <utility>
#include <vector>

#include "odeum/formula/cursor.hpp"

/// The reader of one expression; parser.hpp has the functions that use it.
namespace odeum::formula {

/// Numbers and calls are read in parser.cpp and parser_calls.cpp, conditions in
/// parser_conditions.cpp.
class Parser : Cursor {
 public:
  Parser(std::string_view text, const Scope& scope, Graph& graph)
      : Cursor(text), scope_(scope), graph_(graph) {}

  /// A number; with `is_condition` perhaps a condition, which that tells.
  Id whole(bool* is_condition = nullptr);

 private:
  /// Sets a flag while it exists.
  class Within {
   public:
    Within(bool& flag, bool value) : flag_(flag), before_(std::exchange(flag, value)) {}
    ~Within() { flag_ = before_; }
    Within(const Within&) = delete;
    Within& operator=(const Within&) = delete;

   private:
    bool& flag_;
    bool before_;
  };
  /// The index of a sum at its present value.
  struct Counter {
    std::string_view name;
    std::int64_t value;
    std::size_t repeats;  ///< of its terms: this one and those to come, in sums around it too
  };

  Id make(std::size_t where, Op op, Id a, Id b = no_node, Id c = no_node);
  /// A number: what conditions are made of is none.
  Id sum();
  /// A sum, or a condition in parentheses where a condition may stand; `is_condition_` says which.
  Id sum_or_condition();
  /// The right operand of an operator at `where`, whose left one has just been read: numbers.
  Id number_by(Id (Parser::*read)(), std::size_t where);
  Id product();
  Id signed_factor();
  Id factor();

  Id named();
  [[noreturn]] void fail_refused(std::size_t where, std::string_view name) const;
  /// Takes the primes of a rate, x' or u[3]'.
  std::size_t take_primes();
  [[noreturn]] void fail_unknown(std::size_t where, std::string_view name) const;

  /// Comparisons, joined by and, or, not: a number that is 0 or 1.
  Id condition();
  Id either();
  Id both();
  Id opposite(std::size_t where, Id a);
  template <class Join>
  Id joined(std::string_view word, char sign, Id (Parser::*read)(), const Join& join);
  Id negation();
  /// One comparison, or a chain, 1 < t < 2: each of them.
  Id comparison();
  Id compared(std::size_t where, std::string_view sign, Id left, Id right);
  std::string_view take_comparison();
  bool take_word(std::string_view word);
  bool take_twice(char sign);
  bool take_sign_of_not();

  Id call(std::size_t where, std::string_view name);
  /// The value of a table at an argument, as wind(t).
  Id looked_up(std::size_t where, std::string_view name, const Table& table);
  /// a - b floor(a / b), of the sign of b.
  Id remainder(std::size_t where, Id a, Id b);
  [[noreturn]] void fail_function(std::size_t where, std::string_view name) const;

  /// sum(j, x[j] - x[i]): over the elements of the arrays that j counts.
  Id sum_over(std::size_t where);

  Id element(std::size_t where, std::string_view name);

  const Scope& scope_;
  Graph& graph_;
  bool in_condition_ = false;  ///< parentheses may hold conditions here
  bool is_condition_ = false;  ///< what was read last
  int unused_ = 0;             ///< branches around this place that are never taken
  std::vector<Counter> counters_;
};

}  // namespace odeum::formula
