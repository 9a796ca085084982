// SPDX-License-Identifier: BSD-3-Clause
#include <dlfcn.h>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <set>

#include "odeum/contest/late.hpp"
#include "plugin/apart.hpp"
#include "plugin/names.hpp"
#include "plugin/problem.hpp"
#include "plugin/solver.hpp"

namespace odeum {
namespace adapters::plugin {
namespace {

bool is_name(const std::string& name) {
  return !name.empty() && name.size() <= 64 && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

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
  if (plugin.version != ODEUM_PLUGIN_VERSION)
    return fmt::format(
        "is of version {} of the interface, this Odeum has version {}: compile it "
        "with the odeum/plugin.h of this Odeum",
        plugin.version, ODEUM_PLUGIN_VERSION);
  if (const std::string fault = fault_of_name("plug-in", plugin.name); !fault.empty()) return fault;
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
    if (std::string fault = fault_of(plugin.problems[i]); !fault.empty()) return fault;
    if (!problems.insert(plugin.problems[i].name).second)
      return fmt::format("has two problems of the name {}", plugin.problems[i].name);
    if (std::string fault = Problem(plugin.problems[i]).fault(); !fault.empty()) return fault;
  }
  return {};
}

[[noreturn]] void refuse(const std::string& file, const std::string& why) {
  throw LateError(fmt::format("{}: {}", file, why));
}

std::string mark_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  return fmt::format("{:x}", std::hash<std::string>()(bytes));
}

void isolate(Case& c) {
  const std::size_t n = c.y0.size();
  for (Entrant& entrant : c.entrants)
    if (entrant.solve)
      entrant.solve = [n, solve = std::move(entrant.solve)](const Request& request) {
        return solve_apart(solve, request, n);
      };
}

}  // namespace

std::string fault_of_name(const char* what, const char* name) {
  if (!name) return fmt::format("a {} has a null pointer for its name", what);
  if (!is_name(name))
    return fmt::format("{} name: got \"{}\", expected 1 to 64 characters of a-z, 0-9 and _", what,
                       cleaned(name));
  return {};
}

std::string cleaned(const char* text) {
  std::string clean;
  for (; *text && clean.size() < 300; ++text)
    clean += static_cast<unsigned char>(*text) < 32 || *text == 127 ? ' ' : *text;
  return clean;
}

}  // namespace adapters::plugin

void add_plugin(const std::string& file) {
  using namespace adapters::plugin;
  // A name without a slash would be looked for in the system's folders.
  const std::string path = std::filesystem::absolute(file).string();
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) refuse(file, "is no file");
  // Whatever it does when it is loaded, it does first in a process of its own.
  const std::string fault = try_apart([&] {
    std::string why;
    const odeum_plugin* const plugin = open(path, why);
    return plugin ? fault_of_plugin(*plugin) : why;
  });
  if (!fault.empty()) refuse(file, fault);
  std::string why;
  const odeum_plugin* const plugin = open(path, why);
  if (!plugin) refuse(file, why);
  const std::string name = plugin->name;
  LateLibrary library;
  library.info = {
      .name = name, .libraries = {name}, .option = "", .built = true, .version = "plug-in " + path};
  library.mark = mark_of(path);
  library.enroll = [plugin, name](const ErasedContest& contest, std::vector<Entrant>& entrants) {
    for (std::size_t i = 0; i < plugin->solver_count; ++i)
      entrants.push_back(entrant_of(plugin->solvers[i], name, contest));
  };
  library.cases = [plugin, name] {
    std::vector<Case> cases;
    for (std::size_t i = 0; i < plugin->problem_count; ++i)
      cases.push_back(case_of(plugin->problems[i], name));
    return cases;
  };
  library.finish = isolate;
  add_late_library(std::move(library));
}

}  // namespace odeum
