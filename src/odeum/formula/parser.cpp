// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/parser.hpp"

#include <cmath>
#include <numbers>

#include "odeum/formula/expression_parser.hpp"
#include "odeum/formula/names.hpp"
#include "odeum/input/near_words.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::formula {

Id Parser::whole(bool* is_condition) {
  if (text_.size() > longest_expression)
    fail(0, "too long; got {} bytes, expected at most {}: split it by definitions", text_.size(),
         longest_expression);
  const Within within(in_condition_, is_condition != nullptr);
  const Id value = is_condition ? either() : sum();
  if (is_condition) *is_condition = is_condition_;
  if (const char c = peek(); c != '\0') unexpected(c);
  return value;
}

Id Parser::make(std::size_t where, Op op, Id a, Id b, Id c) {
  const Id id = graph_.make(op, a, b, c);
  if (graph_.size() > most_nodes)
    fail(where,
         "too large; got more than {} operations in all expressions together, "
         "expected at most that",
         most_nodes);
  if (graph_.is_constant(id) && !unused_) require_finite(where, graph_[id].value);
  return id;
}

Id Parser::sum() {
  const Id value = sum_or_condition();
  if (is_condition_)
    fail(at_, "a condition in place of a number; got it, expected if(condition, 1, 0)");
  return value;
}

Id Parser::sum_or_condition() {
  Id left = product();
  while (true) {
    peek();
    const std::size_t where = at_;
    if (take('+'))
      left = make(where, Op::add, left, number_by(&Parser::product, where));
    else if (take('-'))
      left = make(where, Op::subtract, left, number_by(&Parser::product, where));
    else
      return left;
  }
}

Id Parser::number_by(Id (Parser::*read)(), std::size_t where) {
  const bool left = is_condition_;
  const Id value = (this->*read)();
  if (left || is_condition_)
    fail(where, "a condition in place of a number; got it, expected if(condition, 1, 0)");
  return value;
}

Id Parser::product() {
  Id left = signed_factor();
  while (true) {
    peek();
    const std::size_t where = at_;
    if (take('*')) {
      if (peek() == '*') fail(where, "**; got it for a power, expected ^");
      left = make(where, Op::multiply, left, number_by(&Parser::signed_factor, where));
    } else if (take('/')) {
      const Id right = number_by(&Parser::signed_factor, where);
      if (graph_.is(right, 0) && !unused_)
        fail(where, "division by zero; got 0, expected another divisor");
      left = make(where, Op::divide, left, right);
    } else {
      return left;
    }
  }
}

Id Parser::signed_factor() {
  const Level level(*this);
  peek();
  const std::size_t where = at_;
  const bool is_negative = take('-');
  if (is_negative || take('+')) {
    is_condition_ = false;
    const Id value = number_by(&Parser::signed_factor, where);
    return is_negative ? make(where, Op::negate, value) : value;
  }
  const Id base = factor();
  peek();
  const std::size_t caret = at_;
  if (!take('^')) return base;
  const Id exponent = number_by(&Parser::signed_factor, caret);
  if (graph_.is(base, 0) && graph_.is_constant(exponent) && graph_[exponent].value < 0 && !unused_)
    fail(caret, "division by zero; got 0 to a negative power, expected another base");
  return make(caret, Op::power, base, exponent);
}

Id Parser::factor() {
  const char c = peek();
  const std::size_t where = at_;
  is_condition_ = false;
  if (is_digit(c) || c == '.') return graph_.constant(number());
  if (begins_name(c)) return named();
  if (take('(')) {
    const Id inner = in_condition_ ? either() : sum();
    if (const char next = peek(); next != ')' && next != '\0') unexpected(next);
    expect(')', "an open parenthesis");
    return inner;
  }
  if (c == '\0') unexpected(c);
  fail(where, "not understood; got {}, expected a number, a name or (",
       shown(text_.substr(at_, 12)));
}

Id Parser::named() {
  const std::size_t where = at_;
  while (at_ < text_.size() && continues_name(text_[at_])) ++at_;
  take_primes();
  const std::string_view name = text_.substr(where, at_ - where);
  if (is_word_of_conditions(name) && in_condition_)
    fail(where, "a word out of place; got {}, expected a comparison there", name);
  if (is_word_of_conditions(name))
    fail(where, "{} outside of a condition; got it, expected it in if(condition, a, b)", name);
  const char next = peek();
  if (next == '(') return name == "sum" ? sum_over(where) : call(where, name);
  if (next == '[') return element(where, name);
  if (name == "t") {
    if (scope_.refused.contains("t")) fail_refused(where, name);
    return graph_.time();
  }
  if (name == "pi") return graph_.constant(std::numbers::pi_v<long double>);
  if (name == "e") return graph_.constant(std::numbers::e_v<long double>);
  for (const Counter& counter : counters_)
    if (counter.name == name) return graph_.constant(static_cast<long double>(counter.value));
  if (name == "i" && scope_.index) return graph_.constant(static_cast<long double>(*scope_.index));
  if (const auto found = scope_.names.find(name); found != scope_.names.end()) return found->second;
  if (scope_.arrays.contains(name)) fail(where, "no index; got {0}, expected {0}[...]", name);
  if (functions().contains(name))
    fail(where, "a function without arguments; got {0}, expected {0}(...)", name);
  fail_unknown(where, name);
}

void Parser::fail_refused(std::size_t where, std::string_view name) const {
  fail(where, "{} cannot be used here; got it, expected {}", name,
       scope_.refused.find(name)->second);
}

std::size_t Parser::take_primes() {
  const std::size_t before = at_;
  while (at_ < text_.size() && text_[at_] == '\'') ++at_;
  return at_ - before;
}

void Parser::fail_unknown(std::size_t where, std::string_view name) const {
  if (scope_.refused.contains(name)) fail_refused(where, name);
  if (name.ends_with('\''))
    fail(where, "no rate of a state; got {}, expected that of a state, among residuals",
         shown(name));
  std::vector<std::string> candidates;
  for (const auto& [known, id] : scope_.names) candidates.push_back(known);
  for (const auto& [known, array] : scope_.arrays) candidates.push_back(known);
  for (const auto& [known, op] : functions()) candidates.push_back(known);
  fail(where, "unknown name; got {}, expected a parameter, a definition, a state or t{}",
       shown(name), near_one(name, candidates));
}

Id Parser::element(std::size_t where, std::string_view name) {
  const Within within(in_condition_, false);
  take('[');
  const Id id = sum();
  expect(']', "an open bracket");
  const auto found = scope_.arrays.find(std::string(name) + std::string(take_primes(), '\''));
  if (found == scope_.arrays.end()) {
    if (text_[at_ - 1] == '\'')
      fail(where, "no rate of a state; got {}, expected that of a state, among residuals",
           shown(text_.substr(where, at_ - where)));
    if (scope_.names.contains(name))
      fail(where, "{0} has no index; got {0}[...], expected {0}", name);
    fail_unknown(where, name);
  }
  const Array& array = found->second;
  const long double value = graph_[id].value;
  if (!graph_.is_number(id) || value != std::floor(value))
    fail(where,
         "an index must be a whole number; got {}; it may use whole numbers, i and parameters",
         shown(text_.substr(where, at_ - where)));
  if (value >= static_cast<long double>(array.first) &&
      value <= static_cast<long double>(array.last()))
    return array.elements[static_cast<std::size_t>(static_cast<std::int64_t>(value) - array.first)];
  if (std::abs(value) < 1e9L)
    if (const auto beyond = array.beyond.find(static_cast<std::int64_t>(value));
        beyond != array.beyond.end())
      return beyond->second;
  if (unused_) return graph_.constant(0);
  fail(where,
       "an index out of range; got {}[{:.0Lf}], expected {} to {}, or a value "
       "for it in boundaries",
       name, value, array.first, array.last());
}

Id parse_expression(std::string_view text, const Scope& scope, Graph& graph) {
  return Parser(text, scope, graph).whole();
}

Id parse_expression(std::string_view text, const Scope& scope, Graph& graph, bool& is_condition) {
  return Parser(text, scope, graph).whole(&is_condition);
}

std::int64_t parse_index(std::string_view text, const Scope& scope, Graph& graph) {
  const Id id = parse_expression(text, scope, graph);
  const long double value = graph[id].value;
  if (!graph.is_number(id) || value != std::floor(value) || std::abs(value) > 1e9L)
    throw ExpressionError(
        0, fmt::format("not an index; got {}, expected a whole number", shown(text)));
  return static_cast<std::int64_t>(value);
}

}  // namespace odeum::formula
