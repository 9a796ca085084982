// SPDX-License-Identifier: BSD-3-Clause
// long: one grammar, half of it messages.
#include "odeum/formula/parser.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>

#include "odeum/core/glob.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::formula {
namespace {

const std::map<std::string, Op, std::less<>>& functions() {
  static const std::map<std::string, Op, std::less<>> all = {
      {"sin", Op::sin},     {"cos", Op::cos},   {"tan", Op::tan},     {"asin", Op::asin},
      {"acos", Op::acos},   {"atan", Op::atan}, {"atan2", Op::atan2}, {"sinh", Op::sinh},
      {"cosh", Op::cosh},   {"tanh", Op::tanh}, {"exp", Op::exp},     {"log", Op::log},
      {"log10", Op::log10}, {"sqrt", Op::sqrt}, {"abs", Op::abs},     {"sign", Op::sign},
      {"min", Op::min},     {"max", Op::max},   {"if", Op::choose}};
  return all;
}

bool begins_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool continues_name(char c) { return begins_name(c) || is_digit(c); }

class Parser {
 public:
  Parser(std::string_view text, const Scope& scope, Graph& graph)
      : text_(text), scope_(scope), graph_(graph) {}

  Id whole() {
    if (text_.size() > longest_expression)
      fail(0, fmt::format("too long; got {} bytes, expected at most {}: split it by definitions",
                          text_.size(), longest_expression));
    const Id value = sum();
    if (const char c = peek(); c != '\0') unexpected(c);
    return value;
  }

 private:
  [[noreturn]] static void fail(std::size_t at, const std::string& what) {
    throw ExpressionError(at, what);
  }
  [[noreturn]] void unexpected(char c) {
    if (c == '\0') fail(at_, "ends too early; got the end, expected a number, a name or (");
    if (c == '<' || c == '>' || c == '=' || c == '!')
      fail(at_, fmt::format("a comparison outside of a condition; got {}, expected it in "
                            "if(condition, a, b)",
                            c));
    if (continues_name(c) || c == '(')
      fail(at_, fmt::format("no operator; got {}, expected + - * / or ^ before it (2*x, not 2x)",
                            shown(text_.substr(at_, 12))));
    if (c == ',')
      fail(at_,
           "a comma; got it outside of a function's arguments, expected a decimal point or an "
           "operator");
    fail(at_, fmt::format("not understood; got {}, expected an operator or the end",
                          shown(text_.substr(at_, 12))));
  }

  char peek() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\n'))
      ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (peek() != c) return false;
    ++at_;
    return true;
  }
  void expect(char c, const char* where) {
    if (take(c)) return;
    const std::string got = peek() == '\0' ? "the end" : shown(text_.substr(at_, 12));
    fail(at_, fmt::format(
                  "{}; got {}, expected {}{}", where, got, c,
                  peek() == '\0' ? " (within { } of YAML, quote an expression with a comma)" : ""));
  }

  /// Counts levels of nesting while it exists.
  class Level {
   public:
    explicit Level(Parser& parser) : depth_(parser.depth_) {
      if (++depth_ > deepest_nesting) {
        const std::size_t at = parser.at_;
        depth_ = 0;
        fail(at, fmt::format("nested too deeply; got more than {} levels, expected at most that",
                             deepest_nesting));
      }
    }
    ~Level() { --depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    int& depth_;
  };

  Id make(std::size_t where, Op op, Id a, Id b = no_node, Id c = no_node) {
    const Id id = graph_.make(op, a, b, c);
    if (graph_.size() > most_nodes)
      fail(where, fmt::format("too large; got more than {} operations in all expressions together, "
                              "expected at most that",
                              most_nodes));
    if (graph_.is_constant(id)) require_finite(where, graph_[id].value);
    return id;
  }
  static void require_finite(std::size_t where, long double value) {
    if (std::isnan(value))
      fail(where,
           "a constant part is not a number; got nan (0/0, or the root or logarithm of a "
           "negative number), expected a finite number");
    if (std::abs(value) > static_cast<long double>(std::numeric_limits<double>::max()))
      fail(where, fmt::format("a constant part is too large; got {}, expected at most 1.8e308 (a "
                              "division by zero?)",
                              std::isinf(value) ? "infinity" : fmt::format("{:.3Lg}", value)));
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
        if (graph_.is(right, 0)) fail(where, "division by zero; got 0, expected another divisor");
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
    if (graph_.is(base, 0) && graph_.is_constant(exponent) && graph_[exponent].value < 0)
      fail(caret, "division by zero; got 0 to a negative power, expected another base");
    return make(caret, Op::power, base, exponent);
  }
  Id factor() {
    const char c = peek();
    const std::size_t where = at_;
    if (is_digit(c) || c == '.') return number();
    if (begins_name(c)) return named();
    if (take('(')) {
      const Id inner = sum();
      if (const char next = peek(); next != ')' && next != '\0') unexpected(next);
      expect(')', "an open parenthesis");
      return inner;
    }
    if (c == '\0') unexpected(c);
    fail(where, fmt::format("not understood; got {}, expected a number, a name or (",
                            shown(text_.substr(at_, 12))));
  }

  Id number() {
    long double value = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    const std::string_view read(begin, static_cast<std::size_t>(end - begin));
    // The range is that of a double; from_chars calls an underflow out of range, too.
    constexpr auto least = static_cast<long double>(std::numeric_limits<double>::min());
    if (error == std::errc::result_out_of_range || (value != 0 && value < least) ||
        value > static_cast<long double>(std::numeric_limits<double>::max()))
      fail(at_, fmt::format("a number out of range; got {}, expected 0 or 2.3e-308 to 1.8e308",
                            shown(read)));
    if (error != std::errc{})
      fail(at_, fmt::format("not a number; got {}, expected digits", shown(text_.substr(at_, 12))));
    at_ += read.size();
    if (at_ < text_.size() && text_[at_] == '.')
      fail(at_, "a number with two points; got a second one, expected one at most");
    return graph_.constant(value);
  }

  Id named() {
    const std::size_t where = at_;
    while (at_ < text_.size() && continues_name(text_[at_])) ++at_;
    const std::string_view name = text_.substr(where, at_ - where);
    const char next = peek();
    if (next == '(') return call(where, name);
    if (next == '[') return element(where, name);
    if (name == "t") {
      if (scope_.refused.contains("t")) fail_refused(where, name);
      return graph_.time();
    }
    if (name == "pi") return graph_.constant(std::numbers::pi_v<long double>);
    if (name == "e") return graph_.constant(std::numbers::e_v<long double>);
    if (name == "i" && scope_.index)
      return graph_.constant(static_cast<long double>(*scope_.index));
    if (const auto found = scope_.names.find(name); found != scope_.names.end())
      return found->second;
    if (scope_.arrays.contains(name))
      fail(where, fmt::format("no index; got {0}, expected {0}[...]", name));
    if (functions().contains(name))
      fail(where, fmt::format("a function without arguments; got {0}, expected {0}(...)", name));
    fail_unknown(where, name);
  }
  [[noreturn]] void fail_refused(std::size_t where, std::string_view name) const {
    fail(where, fmt::format("{} cannot be used here; got it, expected {}", name,
                            scope_.refused.find(name)->second));
  }
  [[noreturn]] void fail_unknown(std::size_t where, std::string_view name) const {
    if (scope_.refused.contains(name)) fail_refused(where, name);
    std::vector<std::string> candidates;
    for (const auto& [known, id] : scope_.names) candidates.push_back(known);
    for (const auto& [known, array] : scope_.arrays) candidates.push_back(known);
    for (const auto& [known, op] : functions()) candidates.push_back(known);
    const std::string near = nearest(name, candidates);
    fail(where,
         fmt::format("unknown name; got {}, expected a parameter, a definition, a state or t{}",
                     shown(name), near.empty() ? "" : "; did you mean " + near + "?"));
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
      const std::string near = nearest(name == "ln" ? "log" : name, known);
      fail(where, fmt::format("no such function; got {}, expected one of sin cos tan exp log sqrt "
                              "...{}",
                              shown(name), near.empty() ? "" : "; did you mean " + near + "?"));
    }
    const Op op = found->second;
    const std::size_t wanted = arity(op);
    take('(');
    std::vector<Id> arguments;
    do {
      arguments.push_back(op == Op::choose && arguments.empty() ? condition() : sum());
    } while (arguments.size() < wanted && take(','));
    if (arguments.size() < wanted && peek() == '\0') expect(')', "an open parenthesis");
    if (arguments.size() < wanted || peek() == ',')
      fail(where, fmt::format("the number of arguments of {}; got {}, expected {}", name,
                              peek() == ',' ? "more" : std::to_string(arguments.size()), wanted));
    if (const char next = peek(); next != ')' && next != '\0') unexpected(next);
    expect(')', "an open parenthesis");
    arguments.resize(3, no_node);
    return make(where, op, arguments[0], arguments[1], arguments[2]);
  }

  Id element(std::size_t where, std::string_view name) {
    const auto found = scope_.arrays.find(name);
    take('[');
    const Id id = sum();
    expect(']', "an open bracket");
    if (found == scope_.arrays.end()) {
      if (scope_.names.contains(name))
        fail(where, fmt::format("an index of what has none; got {0}[...], expected {0}", name));
      fail_unknown(where, name);
    }
    const Array& array = found->second;
    const long double value = graph_[id].value;
    if (!graph_.is_constant(id) || value != std::floor(value))
      fail(where, fmt::format("an index that is no whole number; got {}, expected whole numbers, "
                              "i and parameters",
                              shown(text_.substr(where, at_ - where))));
    if (value >= static_cast<long double>(array.first) &&
        value <= static_cast<long double>(array.last()))
      return array
          .elements[static_cast<std::size_t>(static_cast<std::int64_t>(value) - array.first)];
    if (std::abs(value) < 1e9L)
      if (const auto beyond = array.beyond.find(static_cast<std::int64_t>(value));
          beyond != array.beyond.end())
        return beyond->second;
    fail(where, fmt::format("an index out of range; got {}[{:.0Lf}], expected {} to {}, or a value "
                            "for it in boundaries",
                            name, value, array.first, array.last()));
  }

  std::string_view text_;
  const Scope& scope_;
  Graph& graph_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

}  // namespace

std::string fault_of_name(std::string_view name) {
  if (name.empty() || !begins_name(name[0]) ||
      !std::all_of(name.begin(), name.end(), continues_name)) {
    const std::string_view bare = name.substr(0, name.find_last_not_of('\'') + 1);
    if (bare.size() < name.size() && !bare.empty() && fault_of_name(bare).empty())
      return fmt::format("not a name; got {}, expected {}: an equation's entry is the derivative",
                         name, bare);
    return fmt::format("not a name; got {}, expected letters, digits and _, a letter first",
                       shown(name));
  }
  if (name.size() > 60)
    return fmt::format("a long name; got {} characters, expected 60 at most", name.size());
  const bool reserved = name == "t" || name == "pi" || name == "e" || functions().contains(name);
  if (reserved)
    return fmt::format("a name that is taken; got {}, which is {}, expected another", name,
                       name == "t"                  ? "the time"
                       : functions().contains(name) ? "a function"
                                                    : "a constant");
  return "";
}

Id parse_expression(std::string_view text, const Scope& scope, Graph& graph) {
  return Parser(text, scope, graph).whole();
}

std::int64_t parse_index(std::string_view text, const Scope& scope, Graph& graph) {
  const Id id = parse_expression(text, scope, graph);
  const long double value = graph[id].value;
  if (!graph.is_constant(id) || value != std::floor(value) || std::abs(value) > 1e9L)
    throw ExpressionError(
        0, fmt::format("not an index; got {}, expected a whole number", shown(text)));
  return static_cast<std::int64_t>(value);
}

}  // namespace odeum::formula
