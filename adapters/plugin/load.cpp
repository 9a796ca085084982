// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "odeum/core/checksum.hpp"
#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/solvers/runtime_library.hpp"
#include "plugin/image.hpp"
#include "plugin/solver.hpp"

namespace odeum {
namespace adapters::plugin {
namespace {

std::string mark_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  return fmt::format("{:x}", checksum(bytes));
}

/// The problem as a case is made of it.
foreign::ProblemCallbacks given(const std::shared_ptr<const Plugin::Linked>& linked,
                                const std::string& library, const std::string& mark) {
  const odeum_problem& p = linked->functions;
  const auto text = [](const char* said, const std::string& otherwise) {
    return said ? foreign::cleaned(said) : otherwise;
  };
  foreign::ProblemCallbacks given;
  given.functions = p;
  given.keep_alive = linked;
  given.id = library + "_" + p.name;
  given.title = text(p.title, given.id);
  given.equation = text(p.equation, "of the plug-in " + library);
  given.source = text(p.source, "the plug-in " + library);
  given.provider = "the plug-in";
  given.tag = "plugin";
  given.content = given.id + " " + mark;
  return given;
}

}  // namespace
}  // namespace adapters::plugin

void add_plugin(const std::string& file) {
  using namespace adapters::plugin;
  // A name without a slash would be looked for in the system's folders.
  const std::string path = std::filesystem::absolute(file).string();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored))
    throw LoadError(fmt::format("{}: is not a file", file));
  std::shared_ptr<const Plugin> plugin;
  try {
    plugin = Plugin::open(path);
  } catch (const LoadError& error) {
    throw LoadError(fmt::format("{}: {}", file, error.what()));
  }
  const odeum_plugin& image = plugin->image();
  const std::string name = image.name;
  RuntimeLibrary library;
  library.info = {
      .name = name, .libraries = {name}, .option = "", .built = true, .version = "plug-in " + path};
  library.mark = mark_of(path);
  for (std::size_t i = 0; i < image.solver_count; ++i)
    library.solvers.push_back(solver_of(plugin, i));
  library.problems = [plugin, name, mark = library.mark] {
    std::vector<foreign::ProblemCallbacks> problems;
    for (std::size_t i = 0; i < plugin->image().problem_count; ++i)
      problems.push_back(given(plugin->problem(i), name, mark));
    return problems;
  };
  add_runtime_library(std::move(library));
}

}  // namespace odeum
