// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/print/print_text.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "odeum/formula/cache.hpp"
#include "odeum/formula/case_section.hpp"
#include "odeum/print/print_problem.hpp"

namespace odeum::print {
namespace {

/// VanDerPol for van_der_pol.
std::string type_name(const std::string& stem) {
  std::string name;
  for (std::size_t k = 0; k < stem.size(); ++k) {
    if (stem[k] == '_') continue;
    const bool first = k == 0 || stem[k - 1] == '_';
    name += first && stem[k] >= 'a' && stem[k] <= 'z' ? static_cast<char>(stem[k] - 'a' + 'A')
                                                      : stem[k];
  }
  return name;
}

}  // namespace

Printed print_text(const std::string& file, const std::string& text) {
  constexpr std::size_t most_states = 40;
  const std::string stem = std::filesystem::path(file).stem().string();
  formula::Problem problem = formula::read_problem(file, text, {}, formula::Parameters::names);
  if (problem.kinetic_energy != formula::no_node || problem.states.size() > most_states)
    throw InputError(
        file, {},
        fmt::format("got {} states{}, expected at most {} and no mass matrix: such "
                    "built-in cases are C++",
                    problem.states.size(),
                    problem.kinetic_energy != formula::no_node ? ", mass" : "", most_states));
  std::string names, fields, invariants;
  std::size_t count = 0;
  const auto& definitions = problem.graph.definitions();
  const std::vector<std::string> members = member_names(type_name(stem), problem.graph);
  for (std::size_t k = 0; k < definitions.size(); ++k) {
    const formula::Definition& each = definitions[k];
    if (!problem.parameters.contains(each.name)) continue;
    names += fmt::format("{}\"{}\"", count ? ", " : "", each.name);
    fields += fmt::format("{}.{} = values[{}]", count ? ", " : "", members[k], count);
    ++count;
  }
  for (const formula::Invariant& invariant : problem.invariants)
    if (!invariant.is_energy())
      invariants += fmt::format(
          "            c.invariants.push_back({{\"{0}\", [problem](const double* y) {{ return "
          "problem.kept_{0}(y); }}}});\n",
          invariant.name);
  const formula::Analysis analysis = formula::analyse(problem);
  // Members are named as the file names its parameters, also where an argument has that name.
  return {
      fmt::format(
          "// Printed from cases/{}.yaml.\n#pragma once\n#include <cmath>\n#include <cstddef>\n\n"
          "#pragma GCC diagnostic push\n#pragma GCC diagnostic ignored \"-Wshadow\"\n"
          "namespace odeum::cases {{\n{}}}\n#pragma GCC diagnostic pop\n",
          stem,
          print_struct(type_name(stem), problem, analysis,
                       formula::CaseSection(file, text).offers())),
      fmt::format(
          "// Printed from cases/{0}.yaml.\n#include \"problems/{0}.hpp\"\n\n"
          "#include \"odeum/cases/printed_text.hpp\"\n"
          "#include \"odeum/cases/set_problem.hpp\"\n\nnamespace odeum::cases {{\n"
          "PrintedText printed_{0}() {{\n"
          "  return {{{{{1}}}, []([[maybe_unused]] const double* values, Case& c) {{\n"
          "            const {2} problem{{{3}}};\n"
          "            set_problem(c, problem);\n{4}          }},\n          \"{5}\"}};\n}}\n}}\n",
          stem, names, type_name(stem), fields, invariants,
          formula::content_key(formula::code_of_problem(file, text)))};
}

}  // namespace odeum::print
