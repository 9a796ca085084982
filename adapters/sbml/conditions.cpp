// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "sbml/math.hpp"

namespace odeum::adapters::sbml {

std::string MathText::comparison(const ASTNode& node, const char* sign) {
  std::string text;
  for (unsigned k = 1; k < node.getNumChildren(); ++k)
    text += fmt::format("{}({}) {} ({})", k == 1 ? "" : " and ", argument(node, k - 1), sign,
                        argument(node, k));
  return text.empty() ? "1 == 1" : text;
}

std::string MathText::condition(const ASTNode& node) {
  const auto all = [&](const char* word, const char* of_none) {
    std::string text;
    for (unsigned k = 0; k < node.getNumChildren(); ++k)
      text += fmt::format("{}({})", k == 0 ? "" : word, condition(*node.getChild(k)));
    return text.empty() ? of_none : text;
  };
  switch (node.getType()) {
    case AST_CONSTANT_TRUE:
      return "1 == 1";
    case AST_CONSTANT_FALSE:
      return "1 == 0";
    case AST_LOGICAL_AND:
      return all(" and ", "1 == 1");
    case AST_LOGICAL_OR:
      return all(" or ", "1 == 0");
    case AST_LOGICAL_NOT:
      return "not (" + condition(*node.getChild(0)) + ")";
    case AST_LOGICAL_XOR: {
      std::string count = "0";
      for (unsigned k = 0; k < node.getNumChildren(); ++k)
        count += " + if(" + condition(*node.getChild(k)) + ", 1, 0)";
      return "mod(" + count + ", 2) == 1";
    }
    case AST_LOGICAL_IMPLIES:
      return fmt::format("(not ({})) or ({})", condition(*node.getChild(0)),
                         condition(*node.getChild(1)));
    case AST_RELATIONAL_EQ:
      return comparison(node, "==");
    case AST_RELATIONAL_NEQ:
      return comparison(node, "!=");
    case AST_RELATIONAL_LT:
      return comparison(node, "<");
    case AST_RELATIONAL_LEQ:
      return comparison(node, "<=");
    case AST_RELATIONAL_GT:
      return comparison(node, ">");
    case AST_RELATIONAL_GEQ:
      return comparison(node, ">=");
    case AST_FUNCTION_PIECEWISE:
    default:
      return "(" + number(node) + ") != 0";
  }
}

}  // namespace odeum::adapters::sbml
