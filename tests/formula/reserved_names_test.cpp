// SPDX-License-Identifier: BSD-3-Clause
// Names of a file that C, C++ or their headers have another use for.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "odeum/formula/text_ode.hpp"
#include "odeum/print/print_problem.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::reserved_names_test {
namespace {

const char* const names[] = {
    "int",      "new",      "default", "double",   "register",  "static",   "class",    "auto",
    "bool",     "break",    "case",    "char",     "const",     "continue", "delete",   "do",
    "else",     "enum",     "extern",  "float",    "for",       "goto",     "inline",   "long",
    "return",   "short",    "signed",  "sizeof",   "struct",    "switch",   "this",     "throw",
    "true",     "typedef",  "union",   "unsigned", "using",     "void",     "volatile", "while",
    "template", "operator", "private", "public",   "namespace", "xor",      "asm",      "restrict",
    "I",        "NULL",     "NAN",     "INFINITY", "EOF",       "M_PI",     "HUGE_VAL", "errno",
    "stdin",    "OVERFLOW", "linux",   "unix",     "gamma",     "lgamma",   "j0",       "y0",
    "y1",       "jn",       "signgam", "div",      "time",      "index",    "signal",   "remainder",
    "rhs",      "jacobian", "taylor",  "energy",   "dimension", "sum",      "square",   "power",
    "root",     "std",      "Problem", "R",        "y",         "f",        "j",        "v1",
    "c3_",      "c12_",     "_Bool",   "_x",       "a__b",      "p_int",    "export",   "concept",
    "requires", "kept_H"};

formula::Problem problem(formula::Parameters kind) {
  std::string parameters, sum = "0";
  for (std::size_t k = 0; k < std::size(names); ++k) {
    parameters += fmt::format("{}\"{}\": {}", k ? ", " : "", names[k], k + 1);
    sum += fmt::format(" + 2*{}*z", names[k]);
  }
  return formula::read_problem(
      "f",
      fmt::format("parameters: {{{}}}\nstates: {{z: 1, w: 1}}\ntime: {{end: 1}}\n"
                  "equations: {{z: {}, w: -w*sqrt(w)}}\n",
                  parameters, sum),
      {}, kind);
}

TEST(ReservedNames, AreParametersOfCompiledCode) {
  const formula::TextOde ode(problem(formula::Parameters::names));
  EXPECT_EQ(ode.how().find("interpreted"), std::string::npos) << ode.how();
}

TEST(ReservedNames, StatesAndDefinitionsAreNumbers) {
  std::string states, definitions, equations;
  for (const char* const name : names) {
    states += fmt::format("{}\"{}\": 1", states.empty() ? "" : ", ", name);
    definitions += fmt::format("{}of_{}: 2*{}", definitions.empty() ? "" : ", ", name, name);
    equations += fmt::format("{}\"{}\": -of_{}", equations.empty() ? "" : ", ", name, name);
  }
  const formula::TextOde ode(formula::read_problem(
      "f", fmt::format("states: {{{}}}\ndefinitions: {{{}}}\nequations: {{{}}}\ntime: {{end: 1}}\n",
                       states, definitions, equations)));
  EXPECT_EQ(ode.how().find("interpreted"), std::string::npos) << ode.how();
}

TEST(ReservedNames, MakeAProgramThatCompiles) {
  formula::Problem text = problem(formula::Parameters::names);
  const formula::Analysis analysis = formula::analyse(text);
  const std::string printed = print::print_struct("Problem", text, analysis, {});
  const tests::TemporaryFolder folder;
  const std::string file = (folder.path() / "run.cpp").string(),
                    program = (folder.path() / "run").string();
  std::ofstream(file)
      << "#include <cerrno>\n#include <climits>\n#include <cmath>\n#include <csignal>\n"
         "#include <cstddef>\n#include <cstdio>\n#include <cstdlib>\n#include <ctime>\n"
         "#include <cstring>\n"
      << printed
      << "int main() {\n  const Problem problem;\n  const double y[] = {1, 1};\n  double f[2];\n"
         "  problem.rhs(0.0, y, f);\n  std::printf(\"%.17g\", f[0]);\n}\n";
  const tests::Result result =
      tests::shell("c++ -std=gnu++17 -Wall -Werror " + file + " -o " + program + " && " + program);
  // 2 (1 + 2 + ... + n)
  EXPECT_EQ(result.output, fmt::format("{}", std::size(names) * (std::size(names) + 1)))
      << printed.substr(0, 2000);
  EXPECT_NE(printed.find("double p_new = 0x1p+1;  // new"), std::string::npos) << printed;
}

TEST(ReservedNames, KeepThoseThatAreFree) {
  formula::Problem text = problem(formula::Parameters::names);
  const std::vector<std::string> members = print::member_names("Problem", text.graph);
  const auto member = [&](const std::string& name) {
    const auto& all = text.graph.definitions();
    for (std::size_t k = 0; k < all.size(); ++k)
      if (all[k].name == name) return members[k];
    return std::string();
  };
  for (const char* const name : {"I", "gamma", "j0", "y0", "R", "y", "time", "index"})
    EXPECT_EQ(member(name), name);
  EXPECT_EQ(member("p_int"), "p_int");
  EXPECT_EQ(member("int"), "p_int_");
}

}  // namespace
}  // namespace odeum::reserved_names_test
