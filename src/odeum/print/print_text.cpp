// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/print/print_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>

#include "odeum/formula/case_section.hpp"
#include "odeum/print/print_problem.hpp"

namespace odeum::print {

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
  for (const formula::Definition& each : problem.graph.definitions()) {
    if (!problem.parameters.contains(each.name)) continue;
    names += fmt::format("{}\"{}\"", count ? ", " : "", each.name);
    fields += fmt::format("{}.{} = values[{}]", count ? ", " : "", each.name, count);
    ++count;
  }
  for (const formula::Invariant& invariant : problem.invariants)
    if (!is_energy(invariant.name))
      invariants += fmt::format(
          "            c.invariants.push_back({{\"{0}\", [problem](const double* y) {{ return "
          "problem.kept_{0}(y); }}}});\n",
          invariant.name);
  return {print_problem(stem, problem, formula::analyse(problem),
                        formula::CaseSection(file, text).offers()),
          fmt::format("// Printed from cases/{0}.yaml.\n#include \"problems/{0}.hpp\"\n\n"
                      "#include \"odeum/cases/printed_text.hpp\"\n"
                      "#include \"odeum/cases/set_problem.hpp\"\n\nnamespace odeum::cases {{\n"
                      "PrintedText printed_{0}() {{\n"
                      "  return {{{{{1}}}, []([[maybe_unused]] const double* values, Case& c) {{\n"
                      "            const {2} problem{{{3}}};\n"
                      "            set_problem(c, problem);\n{4}          }}}};\n}}\n}}\n",
                      stem, names, type_name(stem), fields, invariants)};
}

}  // namespace odeum::print
