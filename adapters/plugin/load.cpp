// SPDX-License-Identifier: BSD-3-Clause
#include <dlfcn.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

#include "odeum/core/checksum.hpp"
#include "odeum/isolated/isolated_process.hpp"
#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/solvers/runtime_library.hpp"
#include "plugin/solver.hpp"

namespace odeum {
namespace adapters::plugin {
namespace {

/// The description in a shared object, or a sentence that says why there is none.
const odeum_plugin* open(const std::string& file, std::string& why) {
  void* const handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) {
    why = fmt::format("cannot be loaded: {}", dlerror());
    return nullptr;
  }
  using Entry = const odeum_plugin* (*)();
  const auto entry = reinterpret_cast<Entry>(dlsym(handle, ODEUM_PLUGIN_ENTRY));
  if (!entry) {
    why = "exports no function " ODEUM_PLUGIN_ENTRY;
    return nullptr;
  }
  const odeum_plugin* const plugin = entry();
  if (!plugin) why = ODEUM_PLUGIN_ENTRY " returned a null pointer";
  return plugin;
}

/// What is wrong with a description.
std::string fault_of_plugin(const odeum_plugin& plugin) {
  // What version 2 added stands behind all that a plug-in of version 1 reads.
  if (plugin.version < 1 || plugin.version > ODEUM_PLUGIN_VERSION)
    return fmt::format(
        "is of version {} of the interface, this Odeum has versions 1 to {}: compile it "
        "with the odeum/plugin.h of this Odeum",
        plugin.version, ODEUM_PLUGIN_VERSION);
  if (std::string fault = foreign::fault_of_name("plug-in", plugin.name); !fault.empty())
    return fault;
  constexpr std::size_t most = 1000;
  if (plugin.solver_count > most || plugin.problem_count > most)
    return fmt::format("has {} solvers and {} problems, expected at most {}", plugin.solver_count,
                       plugin.problem_count, most);
  if (plugin.solver_count + plugin.problem_count == 0) return "has neither solvers nor problems";
  if ((plugin.solver_count && !plugin.solvers) || (plugin.problem_count && !plugin.problems))
    return "has a count of solvers or problems, but a null pointer for them";
  std::set<std::string> solvers, problems;
  for (std::size_t i = 0; i < plugin.solver_count; ++i) {
    if (std::string fault = fault_of(plugin.solvers[i]); !fault.empty()) return fault;
    if (!solvers.insert(plugin.solvers[i].name).second)
      return fmt::format("has two solvers of the name {}", plugin.solvers[i].name);
  }
  for (std::size_t i = 0; i < plugin.problem_count; ++i) {
    if (std::string fault = foreign::fault_of(plugin.problems[i]); !fault.empty()) return fault;
    if (!problems.insert(plugin.problems[i].name).second)
      return fmt::format("has two problems of the name {}", plugin.problems[i].name);
    if (std::string fault = foreign::Problem(plugin.problems[i]).fault(); !fault.empty())
      return fault;
  }
  return {};
}

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw LoadError(fmt::format("{}: {}", file, why));
}

std::string mark_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  return fmt::format("{:x}", checksum(bytes));
}

/// The problem as a case is made of it.
foreign::ProblemCallbacks given(const odeum_problem& p, const std::string& library,
                                const std::string& mark) {
  const auto text = [](const char* said, const std::string& otherwise) {
    return said ? foreign::cleaned(said) : otherwise;
  };
  foreign::ProblemCallbacks given;
  given.functions = p;
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
  if (!std::filesystem::is_regular_file(path, ignored)) refuse(file, "is not a file");
  // Whatever it does when it is loaded, it does first in a process of its own.
  const auto [ended, fault] = isolated::text_isolated([&] {
    std::string why;
    const odeum_plugin* const plugin = open(path, why);
    return plugin ? fault_of_plugin(*plugin) : why;
  });
  if (!fault.empty()) refuse(file, fault);
  std::string why;
  const odeum_plugin* const plugin = open(path, why);
  if (!plugin) refuse(file, why);
  const std::string name = plugin->name;
  RuntimeLibrary library;
  library.info = {
      .name = name, .libraries = {name}, .option = "", .built = true, .version = "plug-in " + path};
  library.mark = mark_of(path);
  for (std::size_t i = 0; i < plugin->solver_count; ++i)
    library.solvers.push_back(solver_of(plugin->solvers[i], name));
  library.problems = [plugin, name, mark = library.mark] {
    std::vector<foreign::ProblemCallbacks> problems;
    for (std::size_t i = 0; i < plugin->problem_count; ++i)
      problems.push_back(given(plugin->problems[i], name, mark));
    return problems;
  };
  add_runtime_library(std::move(library));
}

}  // namespace odeum
