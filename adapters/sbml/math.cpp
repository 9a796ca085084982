// SPDX-License-Identifier: BSD-3-Clause
#include "sbml/math.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace odeum::adapters::sbml {
namespace {

constexpr int deepest = 100;  // also of functions that are written out, which no cycle may be
constexpr std::size_t longest = 90'000;
constexpr const char* avogadro = "6.02214179e23";  // as SBML level 3 has it

/// Functions that texts have, by MathML's.
const std::map<ASTNodeType_t, const char*>& same_functions() {
  static const std::map<ASTNodeType_t, const char*> all{
      {AST_FUNCTION_ABS, "abs"},     {AST_FUNCTION_ARCCOS, "acos"},  {AST_FUNCTION_ARCSIN, "asin"},
      {AST_FUNCTION_ARCTAN, "atan"}, {AST_FUNCTION_CEILING, "ceil"}, {AST_FUNCTION_COS, "cos"},
      {AST_FUNCTION_COSH, "cosh"},   {AST_FUNCTION_EXP, "exp"},      {AST_FUNCTION_FLOOR, "floor"},
      {AST_FUNCTION_LN, "log"},      {AST_FUNCTION_SIN, "sin"},      {AST_FUNCTION_SINH, "sinh"},
      {AST_FUNCTION_TAN, "tan"},     {AST_FUNCTION_TANH, "tanh"}};
  return all;
}

/// Functions that texts write with others, `{0}` their argument.
const std::map<ASTNodeType_t, const char*>& other_functions() {
  static const std::map<ASTNodeType_t, const char*> all{
      {AST_FUNCTION_COT, "(1/tan({0}))"},
      {AST_FUNCTION_COTH, "(1/tanh({0}))"},
      {AST_FUNCTION_CSC, "(1/sin({0}))"},
      {AST_FUNCTION_CSCH, "(1/sinh({0}))"},
      {AST_FUNCTION_SEC, "(1/cos({0}))"},
      {AST_FUNCTION_SECH, "(1/cosh({0}))"},
      {AST_FUNCTION_ARCCOT, "atan(1/({0}))"},
      {AST_FUNCTION_ARCCSC, "asin(1/({0}))"},
      {AST_FUNCTION_ARCSEC, "acos(1/({0}))"},
      {AST_FUNCTION_ARCSINH, "log({0} + sqrt(({0})^2 + 1))"},
      {AST_FUNCTION_ARCCOSH, "log({0} + sqrt(({0})^2 - 1))"},
      {AST_FUNCTION_ARCTANH, "(log((1 + {0})/(1 - ({0})))/2)"},
      {AST_FUNCTION_ARCCOTH, "(log(({0} + 1)/({0} - 1))/2)"},
      {AST_FUNCTION_ARCCSCH, "log(1/({0}) + sqrt(1/({0})^2 + 1))"},
      {AST_FUNCTION_ARCSECH, "log((1 + sqrt(1 - ({0})^2))/({0}))"}};
  return all;
}

std::string name_of(const ASTNode& node) {
  const char* const name = node.getName();
  return name ? name : "an element without a name";
}

}  // namespace

std::string text_of(double value) {
  if (!std::isfinite(value)) throw Unsupported(fmt::format("the number {}", value));
  return value < 0 ? fmt::format("({})", value) : fmt::format("{}", value);
}

bool MathText::is_condition(const ASTNode& node) const {
  switch (node.getType()) {
    case AST_CONSTANT_TRUE:
    case AST_CONSTANT_FALSE:
    case AST_LOGICAL_AND:
    case AST_LOGICAL_OR:
    case AST_LOGICAL_NOT:
    case AST_LOGICAL_XOR:
    case AST_LOGICAL_IMPLIES:
    case AST_RELATIONAL_EQ:
    case AST_RELATIONAL_NEQ:
    case AST_RELATIONAL_LT:
    case AST_RELATIONAL_LEQ:
    case AST_RELATIONAL_GT:
    case AST_RELATIONAL_GEQ:
      return true;
    default:
      return false;
  }
}

std::string MathText::argument(const ASTNode& node, unsigned k) {
  if (k >= node.getNumChildren())
    throw Unsupported(fmt::format("an operation with {} arguments", node.getNumChildren()));
  return number(*node.getChild(k));
}

std::string MathText::number(const ASTNode& node) {
  if (++depth_ > deepest)
    throw Unsupported("expressions that are nested more than a hundred times");
  std::string text;
  if (is_condition(node))
    text = "if(" + condition(node) + ", 1, 0)";
  else if (node.getType() == AST_FUNCTION_PIECEWISE)
    text = piecewise(node, 0);
  else if (node.getNumChildren() == 0 && !node.isFunction() && !node.isOperator())
    text = leaf(node);
  else if (node.isOperator())
    text = arithmetic(node);
  else
    text = call(node);
  --depth_;
  if (text.size() > longest) throw Unsupported("an expression of more than 90,000 letters");
  return text;
}

std::string MathText::leaf(const ASTNode& node) {
  switch (node.getType()) {
    case AST_INTEGER:
    case AST_REAL:
    case AST_REAL_E:
    case AST_RATIONAL:
      return text_of(node.getValue());
    case AST_NAME_TIME:
      return meaning_.time;
    case AST_NAME_AVOGADRO:
      return avogadro;
    case AST_CONSTANT_E:
      return "e";
    case AST_CONSTANT_PI:
      return "pi";
    case AST_NAME: {
      const auto given = arguments_.find(name_of(node));
      return given == arguments_.end() ? meaning_.value(name_of(node)) : given->second;
    }
    default:
      throw Unsupported("the element " + name_of(node));
  }
}

std::string MathText::joined(const ASTNode& node, const char* between, const char* of_none) {
  if (node.getNumChildren() == 0) return of_none;
  std::string text = argument(node, 0);
  for (unsigned k = 1; k < node.getNumChildren(); ++k) text += between + argument(node, k);
  return node.getNumChildren() == 1 ? text : "(" + text + ")";
}

std::string MathText::arithmetic(const ASTNode& node) {
  switch (node.getType()) {
    case AST_PLUS:
      return joined(node, " + ", "0");
    case AST_TIMES:
      return joined(node, "*", "1");
    case AST_MINUS:
      return node.getNumChildren() == 1 ? "(-" + argument(node, 0) + ")"
                                        : "(" + argument(node, 0) + " - " + argument(node, 1) + ")";
    case AST_DIVIDE:
      return "(" + argument(node, 0) + "/" + argument(node, 1) + ")";
    default:
      return "((" + argument(node, 0) + ")^(" + argument(node, 1) + "))";
  }
}

std::string MathText::nested(const ASTNode& node, const char* function) {
  std::string text = argument(node, 0);
  for (unsigned k = 1; k < node.getNumChildren(); ++k)
    text = fmt::format("{}({}, {})", function, text, argument(node, k));
  return text;
}

std::string MathText::factorial(const ASTNode& node) {
  const ASTNode& of = *node.getChild(0);
  const double n = of.getType() == AST_INTEGER || of.isReal() ? of.getValue() : -1;
  if (n < 0 || n > 170 || n != std::floor(n))
    throw Unsupported("the factorial of what is not a whole number from 0 to 170");
  return text_of(std::round(std::tgamma(n + 1)));
}

std::string MathText::call(const ASTNode& node) {
  const ASTNodeType_t type = node.getType();
  if (const auto same = same_functions().find(type); same != same_functions().end())
    return fmt::format("{}({})", same->second, argument(node, 0));
  if (const auto other = other_functions().find(type); other != other_functions().end())
    return fmt::format(fmt::runtime(other->second), argument(node, 0));
  switch (type) {
    case AST_FUNCTION_POWER:
      return "((" + argument(node, 0) + ")^(" + argument(node, 1) + "))";
    case AST_FUNCTION_ROOT:
      if (node.getNumChildren() == 1) return "sqrt(" + argument(node, 0) + ")";
      return argument(node, 0) == "2"
                 ? "sqrt(" + argument(node, 1) + ")"
                 : fmt::format("(({})^(1/{}))", argument(node, 1), argument(node, 0));
    case AST_FUNCTION_LOG:
      if (node.getNumChildren() == 1) return "log10(" + argument(node, 0) + ")";
      return argument(node, 0) == "10"
                 ? "log10(" + argument(node, 1) + ")"
                 : fmt::format("(log({})/log({}))", argument(node, 1), argument(node, 0));
    case AST_FUNCTION_MIN:
      return nested(node, "min");
    case AST_FUNCTION_MAX:
      return nested(node, "max");
    case AST_FUNCTION_QUOTIENT:
      return fmt::format("(sign(({0})/({1}))*floor(abs(({0})/({1}))))", argument(node, 0),
                         argument(node, 1));
    case AST_FUNCTION_REM:
      return fmt::format("(sign({0})*mod(abs({0}), abs({1})))", argument(node, 0),
                         argument(node, 1));
    case AST_FUNCTION_FACTORIAL:
      argument(node, 0);
      return factorial(node);
    case AST_FUNCTION_RATE_OF:
      argument(node, 0);
      return meaning_.rate(name_of(*node.getChild(0)));
    case AST_FUNCTION_DELAY:
      throw Unsupported("a delay");
    case AST_FUNCTION:
      return applied(node);
    default:
      throw Unsupported("the function " + name_of(node));
  }
}

std::string MathText::applied(const ASTNode& node) {
  const FunctionDefinition* const function = model_.getFunctionDefinition(name_of(node));
  if (!function || !function->isSetMath() || !function->getBody())
    throw Unsupported("a function without a definition, " + name_of(node));
  if (function->getNumArguments() != node.getNumChildren())
    throw Unsupported(fmt::format("{} with {} arguments", name_of(node), node.getNumChildren()));
  std::map<std::string, std::string> given;
  for (unsigned k = 0; k < node.getNumChildren(); ++k)
    given[name_of(*function->getArgument(k))] = "(" + argument(node, k) + ")";
  std::swap(arguments_, given);
  std::string text = number(*function->getBody());
  std::swap(arguments_, given);
  return "(" + text + ")";
}

bool MathText::are_opposite(const ASTNode& a, const ASTNode& b) {
  constexpr std::array opposites{std::pair{AST_RELATIONAL_GT, AST_RELATIONAL_LEQ},
                                 std::pair{AST_RELATIONAL_LT, AST_RELATIONAL_GEQ},
                                 std::pair{AST_RELATIONAL_EQ, AST_RELATIONAL_NEQ}};
  const auto is_pair = [&](const auto& pair) {
    return (a.getType() == pair.first && b.getType() == pair.second) ||
           (a.getType() == pair.second && b.getType() == pair.first);
  };
  return std::ranges::any_of(opposites, is_pair) && a.getNumChildren() == 2 &&
         b.getNumChildren() == 2 && argument(a, 0) == argument(b, 0) &&
         argument(a, 1) == argument(b, 1);
}

std::string MathText::piecewise(const ASTNode& node, unsigned from) {
  if (from >= node.getNumChildren()) throw Unsupported("a piecewise without an otherwise");
  const std::string value = argument(node, from);
  if (from + 1 == node.getNumChildren()) return value;
  // Programs write the last piece with the opposite of the condition before it, and no otherwise.
  if (from + 2 == node.getNumChildren() && from >= 2 &&
      are_opposite(*node.getChild(from - 1), *node.getChild(from + 1)))
    return value;
  return "if(" + condition(*node.getChild(from + 1)) + ", " + value + ", " +
         piecewise(node, from + 2) + ")";
}

}  // namespace odeum::adapters::sbml
