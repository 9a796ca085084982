// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/expression_parser.hpp"
#include "odeum/formula/names.hpp"

namespace odeum::formula {

Id Parser::opposite(std::size_t where, Id a) {
  return make(where, Op::subtract, graph_.constant(1), a);
}

template <class Join>
Id Parser::joined(std::string_view word, char sign, Id (Parser::*read)(), const Join& join) {
  Id left = (this->*read)();
  for (peek();; peek()) {
    const std::size_t where = at_;
    if (!take_word(word) && !take_twice(sign)) return left;
    const bool known = is_condition_;
    left = join(where, left, (this->*read)());
    if (!known || !is_condition_)
      fail(where, "no comparison beside {}; got a value, expected conditions on both sides", word);
  }
}

Id Parser::condition() {
  const Within within(in_condition_, true);
  const Id value = either();
  if (!is_condition_)
    fail(at_, "no comparison; got a value, expected a condition: if(x > 0, a, b)");
  is_condition_ = false;
  return value;
}

Id Parser::either() {
  return joined("or", '|', &Parser::both, [this](std::size_t where, Id a, Id b) {
    return opposite(where, make(where, Op::multiply, opposite(where, a), opposite(where, b)));
  });
}

Id Parser::both() {
  return joined("and", '&', &Parser::negation,
                [this](std::size_t where, Id a, Id b) { return make(where, Op::multiply, a, b); });
}

Id Parser::negation() {
  const Level level(*this);
  peek();
  const std::size_t where = at_;
  if (!take_word("not") && !take_sign_of_not()) return comparison();
  const Id value = negation();
  if (!is_condition_) fail(where, "no comparison after not; got a value, expected a condition");
  return opposite(where, value);
}

Id Parser::comparison() {
  Id left = sum_or_condition(), all = no_node;
  while (true) {
    peek();
    const std::size_t where = at_;
    const std::string_view sign = take_comparison();
    if (sign.empty()) break;
    const Id right = number_by(&Parser::sum_or_condition, where),
             one = compared(where, sign, left, right);
    all = all == no_node ? one : make(where, Op::multiply, all, one);
    left = right;
  }
  is_condition_ = is_condition_ || all != no_node;
  return all == no_node ? left : all;
}

Id Parser::compared(std::size_t where, std::string_view sign, Id left, Id right) {
  if (sign == "<") return make(where, Op::less, left, right);
  if (sign == ">") return make(where, Op::less, right, left);
  if (sign == "<=") return make(where, Op::less_equal, left, right);
  if (sign == ">=") return make(where, Op::less_equal, right, left);
  const Id equal = make(where, Op::equal, left, right);
  return sign == "==" ? equal : opposite(where, equal);
}

std::string_view Parser::take_comparison() {
  for (const std::string_view sign :
       {"<=", ">=", "==", "!=", "<>", "=<", "=>", "<", ">", "=", "~="})
    if (text_.substr(at_).starts_with(sign)) {
      if (sign == "=" || sign == "<>" || sign == "=<" || sign == "=>" || sign == "~=")
        fail(at_, "not a comparison; got {}, expected < <= > >= == or !=", sign);
      at_ += sign.size();
      return sign;
    }
  return "";
}

bool Parser::take_word(std::string_view word) {
  const std::string_view rest = text_.substr(at_);
  if (!rest.starts_with(word) || (rest.size() > word.size() && continues_name(rest[word.size()])))
    return false;
  at_ += word.size();
  return true;
}

bool Parser::take_twice(char sign) {
  const std::string_view rest = text_.substr(at_);
  if (rest.empty() || rest[0] != sign) return false;
  if (rest.size() < 2 || rest[1] != sign)
    fail(at_, "not an operator; got {0}, expected {0}{0} between conditions", sign);
  at_ += 2;
  return true;
}

bool Parser::take_sign_of_not() {
  if (peek() != '!' || text_.substr(at_).starts_with("!=")) return false;
  ++at_;
  return true;
}

}  // namespace odeum::formula
