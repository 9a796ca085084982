// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/infix.hpp"

#include <fmt/format.h>

namespace odeum::formula {
namespace {

/// How strongly an operation binds its arguments.
enum Binding { comparing, adding, multiplying, negating, raising, atomic };

class InfixWriter {
 public:
  InfixWriter(const Graph& graph, const std::vector<std::string>& states, std::size_t most)
      : graph_(graph), states_(states), most_(most) {}

  void write(Id id, Binding around) {
    if (text.size() > most_) return;  // equal subexpressions are one node: no end may be near
    const Binding own = binding_of(id);
    if (own < around) text += "(";
    write_inside(graph_[id], own);
    if (own < around) text += ")";
  }

  std::string text;

 private:
  Binding binding_of(Id id) const {
    const Node& node = graph_[id];
    switch (node.op) {
      case Op::constant:
        return node.index == 0 && node.value < 0 ? negating : atomic;
      case Op::less:
      case Op::less_equal:
      case Op::equal:
        return comparing;
      case Op::add:
      case Op::subtract:
        return adding;
      case Op::multiply:
      case Op::divide:
        return is_square(node) ? raising : multiplying;
      case Op::negate:
        return negating;
      case Op::power:
        return raising;
      default:
        return atomic;
    }
  }
  static bool is_square(const Node& node) {
    return node.op == Op::multiply && node.of[0] == node.of[1];
  }
  void write_inside(const Node& node, Binding own) {
    if (node.op == Op::constant && node.index == 0) {
      text += fmt::format("{:.9Lg}", node.value);
    } else if (node.op == Op::constant) {
      text += graph_.definitions()[node.index - 1].name;
    } else if (node.op == Op::time) {
      text += "t";
    } else if (node.op == Op::state) {
      text += states_.at(node.index);
    } else if (node.op == Op::negate) {
      text += "-";
      write(node.of[0], raising);
    } else if (is_square(node)) {
      write(node.of[0], atomic);
      text += "^2";
    } else if (own != atomic) {
      const bool associates = node.op == Op::add || node.op == Op::multiply;
      write(node.of[0], node.op == Op::power ? atomic : own);
      text += sign_of(node.op);
      write(node.of[1], associates ? own : static_cast<Binding>(own + 1));
    } else {
      write_call(node);
    }
  }
  void write_call(const Node& node) {
    const char* const name = meaning_of(node.op).name;
    text += name ? name : "side";
    text += "(";
    for (std::size_t k = 0; k < arity(node.op); ++k) {
      if (k > 0) text += ", ";
      write(node.of[k], comparing);
    }
    text += ")";
  }
  static const char* sign_of(Op op) {
    switch (op) {
      case Op::add:
        return " + ";
      case Op::subtract:
        return " - ";
      case Op::multiply:
        return "*";
      case Op::divide:
        return "/";
      case Op::power:
        return "^";
      case Op::less:
        return " < ";
      case Op::less_equal:
        return " <= ";
      default:
        return " == ";
    }
  }

  const Graph& graph_;
  const std::vector<std::string>& states_;
  std::size_t most_;
};

}  // namespace

std::string infix_of(const Graph& graph, Id id, const std::vector<std::string>& states,
                     std::size_t most) {
  InfixWriter writer(graph, states, most);
  writer.write(id, comparing);
  return writer.text.size() > most ? std::string() : std::move(writer.text);
}

}  // namespace odeum::formula
