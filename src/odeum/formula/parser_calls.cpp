// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "odeum/formula/expression_parser.hpp"
#include "odeum/formula/names.hpp"
#include "odeum/input/near_words.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::formula {

Id Parser::call(std::size_t where, std::string_view name) {
  if (const auto table = scope_.tables.find(name); table != scope_.tables.end())
    return looked_up(where, name, table->second);
  const auto found = functions().find(name);
  if (found == functions().end()) fail_function(where, name);
  const Op op = found->second;
  const std::size_t wanted = name == "mod" ? 2 : arity(op);
  const Within within(in_condition_, false);
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
  is_condition_ = false;
  if (name == "mod") return remainder(where, arguments[0], arguments[1]);
  if (name == "ceil")
    return make(where, Op::negate, make(where, Op::floor, make(where, Op::negate, arguments[0])));
  return make(where, op, arguments[0], arguments[1], arguments[2]);
}

Id Parser::looked_up(std::size_t where, std::string_view name, const Table& table) {
  const Within within(in_condition_, false);
  take('(');
  const Id at = sum();
  if (peek() == ',') fail(where, "the number of arguments of {}; got more, expected 1", name);
  expect(')', "an open parenthesis");
  is_condition_ = false;
  if (graph_[at].op == Op::time && scope_.span && !covers(table, *scope_.span))
    fail(where,
         "outside of the table {}; got times from {} to {}, expected those of the problem, {} to "
         "{}, or `outside: hold` or `extrapolate`",
         name, static_cast<double>(table.x.front()), static_cast<double>(table.x.back()),
         static_cast<double>(scope_.span->first), static_cast<double>(scope_.span->second));
  const Id value = value_at(graph_, table, at);
  if (graph_.size() > most_nodes)
    fail(where, "too large; got more than {} operations in all expressions together", most_nodes);
  return value;
}

Id Parser::remainder(std::size_t where, Id a, Id b) {
  if (graph_.is(b, 0) && !unused_)
    fail(where, "division by zero; got 0, expected another divisor of mod(a, b)");
  const Id whole = make(where, Op::floor, make(where, Op::divide, a, b));
  return make(where, Op::subtract, a, make(where, Op::multiply, b, whole));
}

void Parser::fail_function(std::size_t where, std::string_view name) const {
  if (const std::string_view same = known_as(name); !same.empty())
    fail(where, "no such function; got {}, expected {}", shown(name), same);
  std::vector<std::string> known;
  for (const auto& [each, op] : functions()) known.push_back(each);
  known.emplace_back("sum");
  for (const auto& [each, table] : scope_.tables) known.push_back(each);
  fail(where, "no such function; got {}, expected one of sin cos tan exp log sqrt ...{}",
       shown(name), near_one(name, known));
}

Id Parser::sum_over(std::size_t where) {
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
  const Within within(in_condition_, false);
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

}  // namespace odeum::formula
