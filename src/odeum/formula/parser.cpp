// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/parser.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "odeum/formula/cursor.hpp"
#include "odeum/formula/names.hpp"
#include "odeum/input/near_words.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::formula {
namespace {

class Parser : Cursor {
 public:
  Parser(std::string_view text, const Scope& scope, Graph& graph)
      : Cursor(text), scope_(scope), graph_(graph) {}

  Id whole() {
    if (text_.size() > longest_expression)
      fail(0, "too long; got {} bytes, expected at most {}: split it by definitions", text_.size(),
           longest_expression);
    const Id value = sum();
    if (const char c = peek(); c != '\0') unexpected(c);
    return value;
  }

 private:
  /// The index of a sum at its present value.
  struct Counter {
    std::string_view name;
    std::int64_t value;
    std::size_t repeats;  ///< of its terms: this one and those to come, in sums around it too
  };

  Id make(std::size_t where, Op op, Id a, Id b = no_node, Id c = no_node) {
    const Id id = graph_.make(op, a, b, c);
    if (graph_.size() > most_nodes)
      fail(where,
           "too large; got more than {} operations in all expressions together, "
           "expected at most that",
           most_nodes);
    if (graph_.is_constant(id) && !unused_) require_finite(where, graph_[id].value);
    return id;
  }
  Id sum() {
    Id left = product();
    while (true) {
      peek();
      const std::size_t where = at_;
      if (take('+'))
        left = make(where, Op::add, left, product());
      else if (take('-'))
        left = make(where, Op::subtract, left, product());
      else
        return left;
    }
  }
  Id product() {
    Id left = signed_factor();
    while (true) {
      peek();
      const std::size_t where = at_;
      if (take('*')) {
        if (peek() == '*') fail(where, "**; got it for a power, expected ^");
        left = make(where, Op::multiply, left, signed_factor());
      } else if (take('/')) {
        const Id right = signed_factor();
        if (graph_.is(right, 0) && !unused_)
          fail(where, "division by zero; got 0, expected another divisor");
        left = make(where, Op::divide, left, right);
      } else {
        return left;
      }
    }
  }
  Id signed_factor() {
    const Level level(*this);
    peek();
    const std::size_t where = at_;
    if (take('-')) return make(where, Op::negate, signed_factor());
    if (take('+')) return signed_factor();
    const Id base = factor();
    peek();
    const std::size_t caret = at_;
    if (!take('^')) return base;
    const Id exponent = signed_factor();
    if (graph_.is(base, 0) && graph_.is_constant(exponent) && graph_[exponent].value < 0 &&
        !unused_)
      fail(caret, "division by zero; got 0 to a negative power, expected another base");
    return make(caret, Op::power, base, exponent);
  }
  Id factor() {
    const char c = peek();
    const std::size_t where = at_;
    if (is_digit(c) || c == '.') return graph_.constant(number());
    if (begins_name(c)) return named();
    if (take('(')) {
      const Id inner = sum();
      if (const char next = peek(); next != ')' && next != '\0') unexpected(next);
      expect(')', "an open parenthesis");
      return inner;
    }
    if (c == '\0') unexpected(c);
    fail(where, "not understood; got {}, expected a number, a name or (",
         shown(text_.substr(at_, 12)));
  }

  Id named() {
    const std::size_t where = at_;
    while (at_ < text_.size() && continues_name(text_[at_])) ++at_;
    take_primes();
    const std::string_view name = text_.substr(where, at_ - where);
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
    if (name == "i" && scope_.index)
      return graph_.constant(static_cast<long double>(*scope_.index));
    if (const auto found = scope_.names.find(name); found != scope_.names.end())
      return found->second;
    if (scope_.arrays.contains(name)) fail(where, "no index; got {0}, expected {0}[...]", name);
    if (functions().contains(name))
      fail(where, "a function without arguments; got {0}, expected {0}(...)", name);
    fail_unknown(where, name);
  }
  [[noreturn]] void fail_refused(std::size_t where, std::string_view name) const {
    fail(where, "{} cannot be used here; got it, expected {}", name,
         scope_.refused.find(name)->second);
  }
  /// Those of a rate, x' or u[3]'.
  std::size_t take_primes() {
    const std::size_t before = at_;
    while (at_ < text_.size() && text_[at_] == '\'') ++at_;
    return at_ - before;
  }
  [[noreturn]] void fail_unknown(std::size_t where, std::string_view name) const {
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

  Id condition() {
    const Id left = sum();
    peek();
    const std::size_t where = at_;
    const bool less = take('<'), greater = !less && take('>');
    const bool same = !less && !greater && take('='),
               other = !less && !greater && !same && take('!');
    const bool with_equal = take('=');
    if ((same || other) && !with_equal)
      fail(where, "not a comparison; got = or !, expected < <= > >= == or !=");
    if (!less && !greater && !same && !other)
      fail(where, "no comparison; got a value, expected a condition: if(x > 0, a, b)");
    const Id right = sum();
    const Op op = with_equal ? Op::less_equal : Op::less;
    if (less) return make(where, op, left, right);
    if (greater) return make(where, op, right, left);
    const Id equal = make(where, Op::equal, left, right);
    return same ? equal : make(where, Op::subtract, graph_.constant(1), equal);
  }

  Id call(std::size_t where, std::string_view name) {
    const auto found = functions().find(name);
    if (found == functions().end()) {
      std::vector<std::string> known;
      for (const auto& [each, op] : functions()) known.push_back(each);
      known.emplace_back("sum");
      fail(where, "no such function; got {}, expected one of sin cos tan exp log sqrt ...{}",
           shown(name), near_one(name == "ln" ? "log" : name, known));
    }
    const Op op = found->second;
    const std::size_t wanted = arity(op);
    take('(');
    std::vector<Id> arguments;
    do {
      const std::size_t number = arguments.size();
      // A branch that is never taken, as for one index of a sum, may divide by zero.
      const bool known = op == Op::choose && number > 0 && graph_.is_constant(arguments[0]);
      const bool unused = known && (graph_[arguments[0]].value != 0) != (number == 1);
      if (unused) ++unused_;
      arguments.push_back(op == Op::choose && number == 0 ? condition() : sum());
      if (unused) --unused_;
    } while (arguments.size() < wanted && take(','));
    if (arguments.size() < wanted && peek() == '\0') expect(')', "an open parenthesis");
    if (arguments.size() < wanted || peek() == ',')
      fail(where, "the number of arguments of {}; got {}, expected {}", name,
           peek() == ',' ? "more" : std::to_string(arguments.size()), wanted);
    if (const char next = peek(); next != ')' && next != '\0') unexpected(next);
    expect(')', "an open parenthesis");
    arguments.resize(3, no_node);
    return make(where, op, arguments[0], arguments[1], arguments[2]);
  }

  /// sum(j, x[j] - x[i]): over the elements of the arrays that j counts.
  Id sum_over(std::size_t where) {
    take('(');
    peek();
    const std::size_t begin = at_;
    while (at_ < text_.size() && continues_name(text_[at_])) ++at_;
    const std::string_view index = text_.substr(begin, at_ - begin);
    if (std::ranges::count(counters_, index, &Counter::name) > 0 || !scope_.is_free_index(index))
      fail(begin, "the index of a sum; got {}, expected a new name: sum(j, x[j])",
           index.empty() ? "none" : shown(index));
    expect(',', "a sum has an index and a term, sum(j, x[j])");
    const Level level(*this);
    const Array& array = scope_.counted_by(index, text_, at_);
    const std::size_t body = at_, size = array.elements.size(),
                      repeats = counters_.empty() ? scope_.repeats : counters_.back().repeats;
    if (graph_.count_terms(size) + (repeats - 1) * size > most_terms)
      fail(where,
           "too large; got more than {} terms in all sums together, expected at most that: a sum "
           "that is the same for all states is read once among the definitions",
           most_terms);
    Id total = no_node;
    counters_.emplace_back();
    for (std::int64_t k = array.first; k <= array.last(); ++k) {
      counters_.back() = {index, k, repeats * static_cast<std::size_t>(array.last() - k + 1)};
      at_ = body;
      const Id term = sum();
      total = total == no_node ? term : make(where, Op::add, total, term);
    }
    counters_.pop_back();
    expect(')', "an open parenthesis");
    return total;
  }

  Id element(std::size_t where, std::string_view name) {
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
      return array
          .elements[static_cast<std::size_t>(static_cast<std::int64_t>(value) - array.first)];
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

  const Scope& scope_;
  Graph& graph_;
  int unused_ = 0;  ///< branches around this place that are never taken
  std::vector<Counter> counters_;
};

}  // namespace

Id parse_expression(std::string_view text, const Scope& scope, Graph& graph) {
  return Parser(text, scope, graph).whole();
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
