// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sbml/SBMLTypes.h>

#include <functional>
#include <map>
#include <stdexcept>
#include <string>

LIBSBML_CPP_NAMESPACE_USE

namespace odeum::adapters::sbml {

/// What cannot be said as a text: the message names it.
class Unsupported : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// What names stand for in an expression.
struct Meaning {
  std::function<std::string(const std::string& id)> value;
  std::function<std::string(const std::string& id)> rate;  ///< its derivative in time
  std::string time = "t";
};

/// MathML as an expression of a text, see formula/parser.hpp. Functions of the model are written
/// out. Throws Unsupported.
class MathText {
 public:
  MathText(const Model& model, const Meaning& meaning) : model_(model), meaning_(meaning) {}

  std::string number(const ASTNode& node);
  std::string condition(const ASTNode& node);

 private:
  std::string leaf(const ASTNode& node);
  std::string arithmetic(const ASTNode& node);
  std::string call(const ASTNode& node);
  /// Whether one of two comparisons holds where the other one does not.
  bool are_opposite(const ASTNode& a, const ASTNode& b);
  std::string piecewise(const ASTNode& node, unsigned from);
  std::string comparison(const ASTNode& node, const char* sign);
  std::string applied(const ASTNode& node);
  std::string joined(const ASTNode& node, const char* between, const char* of_none);
  std::string nested(const ASTNode& node, const char* function);
  std::string factorial(const ASTNode& node);
  std::string argument(const ASTNode& node, unsigned k);
  bool is_condition(const ASTNode& node) const;

  const Model& model_;
  const Meaning& meaning_;
  std::map<std::string, std::string> arguments_;  ///< of the function that is written out
  int depth_ = 0;
};

/// A number with all its digits. Throws Unsupported for one that is not finite.
std::string text_of(double value);

}  // namespace odeum::adapters::sbml
