// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/run.hpp"
#include "odeum/record/csv.hpp"

namespace odeum::cli {
namespace {

/// The same type as the one that the run is made with, see solvers/enroll_method.hpp.
const char* type_of_problem(const Case& c, const SolverInfo& info) {
  if (info.needs.find("second-order") == std::string::npos) return "SharedOde";
  return c.problem.view.velocity_dependent ? "SharedSecondOrder" : "SharedSeparable";
}

}  // namespace

std::string code_of(const Case& c, const Entrant& entrant, const Request& request) {
  const SolverInfo& info = entrant.info;
  if (info.library != "odeum")
    throw UsageError(
        "--code prints programs for Odeum's own methods; {} is called through its own library",
        info.id());
  const double end = request.stops.back();
  std::string absolute;
  for (const double each : request.tolerance.absolutes())
    absolute += (absolute.empty() ? "" : ", ") + record::format_number(each);
  if (!absolute.empty()) absolute = ", {" + absolute + "}";
  const std::string setting =
      request.mode == Mode::fixed
          ? fmt::format("Step{{{}}}",
                        record::format_number((end - c.t0) / static_cast<double>(request.steps)))
          : fmt::format("Tolerance{{{}{}}}", record::format_number(request.tolerance.relative),
                        absolute);
  return fmt::format(R"(// {0} by {1}.
//
//     find_package(Odeum REQUIRED COMPONENTS laboratory)
//     add_executable(run run.cpp)
//     target_link_libraries(run PRIVATE Odeum::laboratory)
//
// With a problem of your own in the place of the case, any struct of odeum/problem/concepts.hpp,
// Odeum::integrators suffices, which is headers only.
#include <odeum/api/integrate.hpp>
#include <odeum/methods/{2}.hpp>

#include <cstdio>
#include <odeum/problem/shared.hpp>
#include <odeum/studies/runner.hpp>

int main() {{
  const odeum::Case& c = odeum::study::find_case("{0}");  // {3}
  const odeum::{4} problem(c.problem.view, c.problem.keep_alive);
  std::vector<double> y = c.y0;
  const odeum::RunEnd run = odeum::integrate(problem, odeum::methods::{2}{{}}, y, {5}, {6},
                                             odeum::{7});
  std::printf("%s at t = %.17g, %llu steps\n", odeum::to_string(run.status), run.t,
              static_cast<unsigned long long>(run.steps));
  for (const double x : y) std::printf("%.17g\n", x);
  return run.ok() ? 0 : 1;
}}
)",
                     c.id, info.id(), info.method, c.equation, type_of_problem(c, info),
                     record::format_number(c.t0), record::format_number(end), setting);
}

}  // namespace odeum::cli
