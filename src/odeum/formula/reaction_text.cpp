// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/reaction_text.hpp"

#include <algorithm>
#include <charconv>

#include "odeum/input/near_words.hpp"

namespace odeum::formula::reading {
namespace {

/// `A + 2 B -> C`, read from the left.
class ReactionText {
 public:
  ReactionText(std::string_view text, const Scope& scope, const Scope& constants, Graph& graph)
      : text_(text), scope_(scope), constants_(constants), graph_(graph) {}

  Reaction read() {
    const std::size_t head = text_.find("->");
    if (head == std::string_view::npos)
      fail(0, "no arrow; got {}, expected A + 2 B -> C, or A <-> B", shown(text_));
    Reaction reaction;
    reaction.is_reversible = head > 0 && text_[head - 1] == '<';
    reaction.left = side(reaction.is_reversible ? head - 1 : head);
    at_ = head + 2;
    reaction.right = side(text_.size());
    if (reaction.left.empty() && reaction.right.empty())
      fail(0, "no species; got {}, expected one at least", shown(text_));
    return reaction;
  }

 private:
  template <class... Values>
  [[noreturn]] static void fail(std::size_t at, fmt::format_string<Values...> what,
                                Values&&... values) {
    throw ExpressionError(at, fmt::format(what, std::forward<Values>(values)...));
  }

  void skip_spaces(std::size_t end) {
    while (at_ < end && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }

  /// Up to `end`; nothing or 0 where there is no species.
  std::vector<Participant> side(std::size_t end) {
    std::vector<Participant> all;
    skip_spaces(end);
    if (const std::string_view rest = text_.substr(at_, end - at_);
        rest.empty() || rest.substr(0, rest.find_last_not_of(' ') + 1) == "0")
      return all;
    while (true) {
      all.push_back(participant(end));
      skip_spaces(end);
      if (at_ == end) return all;
      if (text_[at_] != '+')
        fail(at_, "not understood; got {}, expected + and a species, or the arrow",
             shown(text_.substr(at_, 12)));
      ++at_;
    }
  }

  Participant participant(std::size_t end) {
    skip_spaces(end);
    const Id number = coefficient(end);
    skip_spaces(end);
    const std::size_t where = at_;
    while (at_ < end && continues_name(text_[at_])) ++at_;
    const std::string_view name = text_.substr(where, at_ - where);
    if (name.empty() || is_digit(name[0]))
      fail(where, "no species; got {}, expected a name",
           where < end ? shown(text_.substr(where, end - where)) : "none");
    if (at_ < end && text_[at_] == '[') at_ = std::min(text_.find(']', at_), end - 1) + 1;
    const std::string_view whole = text_.substr(where, at_ - where);
    const bool is_element = scope_.arrays.contains(name) && whole.ends_with(']');
    if (!is_element && !(scope_.names.contains(name) && name == whole)) fail_unknown(where, whole);
    return {parse_expression(whole, scope_, graph_), number};
  }

  [[noreturn]] void fail_unknown(std::size_t where, std::string_view name) const {
    std::vector<std::string> known;
    for (const auto& [each, id] : scope_.names) known.push_back(each);
    fail(where,
         "a species that is nowhere declared; got {}, expected a state, or a parameter or a "
         "definition for what no reaction changes{}",
         shown(name), near_one(name, known));
  }

  /// 1 where none is written.
  Id coefficient(std::size_t end) {
    const std::size_t where = at_;
    if (at_ < end && text_[at_] == '(') {
      const std::size_t close = text_.find(')', at_);
      if (close >= end) fail(where, "an open parenthesis; got no ), expected one");
      at_ = close + 1;
    } else if (at_ < end && (is_digit(text_[at_]) || text_[at_] == '.' || text_[at_] == '-')) {
      long double value = 0;
      at_ += static_cast<std::size_t>(
          std::from_chars(text_.data() + at_, text_.data() + end, value).ptr - text_.data() -
          static_cast<std::ptrdiff_t>(at_));
    } else {
      return graph_.constant(1);
    }
    const Id id = parse_expression(text_.substr(where, at_ - where), constants_, graph_);
    if (at_ < end && text_[at_] == '*') ++at_;
    const long double value = graph_[id].value;
    if (!(value > 0))
      fail(where, "a stoichiometry that is not positive; got {:.6Lg}, expected how many take part",
           value);
    return id;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  const Scope& scope_;
  const Scope& constants_;
  Graph& graph_;
};

}  // namespace

Reaction read_reaction(std::string_view text, const Scope& scope, const Scope& constants,
                       Graph& graph) {
  return ReactionText(text, scope, constants, graph).read();
}

}  // namespace odeum::formula::reading
