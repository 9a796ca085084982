// SPDX-License-Identifier: BSD-3-Clause
#include "plugin/image.hpp"

#include <dlfcn.h>
#include <sys/stat.h>

#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <set>
#include <utility>

#include "odeum/isolated/child_process.hpp"
#include "odeum/isolated/isolated_process.hpp"
#include "odeum/isolated/kept_arithmetic.hpp"
#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/solvers/runtime_library.hpp"
#include "plugin/solver.hpp"

namespace odeum::adapters::plugin {
namespace {

constexpr std::size_t most_bytes = 1U << 28U;  // of which those that are written are taken

/// The description in a shared object, or a sentence that says why there is none.
const odeum_plugin* load(const std::string& file, std::string& why) {
  const isolated::KeptArithmetic kept;
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

/// Copies a description into shared memory.
class Copier {
 public:
  explicit Copier(void* memory) : at_(static_cast<char*>(memory)), end_(at_ + most_bytes) {}

  template <class T>
  T* copy(const T* from, std::size_t count) {
    if (!from) return nullptr;
    const std::size_t bytes = (count * sizeof(T) + 15) / 16 * 16;
    if (bytes > static_cast<std::size_t>(end_ - at_))
      throw LoadError(fmt::format("its description has more than {} bytes", most_bytes));
    auto* const to = reinterpret_cast<T*>(std::exchange(at_, at_ + bytes));
    if (count > 0) std::memcpy(to, from, count * sizeof(T));
    return to;
  }
  const char* text(const char* from) { return from ? copy(from, std::strlen(from) + 1) : nullptr; }

 private:
  char *at_, *end_;
};

void copy(const odeum_plugin& from, void* memory) {
  Copier copier(memory);
  odeum_plugin& to = *copier.copy(&from, 1);
  to.name = copier.text(from.name);
  odeum_solver* const solvers = copier.copy(from.solvers, from.solver_count);
  for (std::size_t i = 0; i < from.solver_count; ++i)
    for (const char* odeum_solver::*text :
         {&odeum_solver::name, &odeum_solver::family, &odeum_solver::source})
      solvers[i].*text = copier.text(from.solvers[i].*text);
  odeum_problem* const problems = copier.copy(from.problems, from.problem_count);
  for (std::size_t i = 0; i < from.problem_count; ++i) {
    const odeum_problem& p = from.problems[i];
    for (const char* odeum_problem::*text : {&odeum_problem::name, &odeum_problem::title,
                                             &odeum_problem::equation, &odeum_problem::source})
      problems[i].*text = copier.text(p.*text);
    problems[i].y0 = copier.copy(p.y0, p.dimension);
    problems[i].stops = copier.copy(p.stops, p.stop_count);
    problems[i].row = p.sparse_jacobian ? copier.copy(p.row, p.entries) : nullptr;
    problems[i].column = p.sparse_jacobian ? copier.copy(p.column, p.entries) : nullptr;
  }
  to.solvers = solvers;
  to.problems = problems;
}

/// A sentence where the plug-in cannot be used; else its image is in the memory.
std::string describe(const std::string& path, void* memory) {
  std::string why;
  const odeum_plugin* const plugin = load(path, why);
  if (!plugin) return why;
  if (std::string fault = fault_of_plugin(*plugin); !fault.empty()) return fault;
  try {
    copy(*plugin, memory);
  } catch (const LoadError& error) {
    return error.what();
  }
  return {};
}

std::string state_of(const std::string& path) {
  struct stat s {};
  if (::stat(path.c_str(), &s) != 0) return {};
  return fmt::format("{} {} {} {} {}", s.st_dev, s.st_ino, s.st_size, s.st_mtim.tv_sec,
                     s.st_mtim.tv_nsec);
}

/// The loaded problem behind the `data` of a linked one.
const odeum_problem& problem_of(void* data) {
  const auto& linked = *static_cast<const Plugin::Linked*>(data);
  return linked.plugin->loaded().problems[linked.number];
}

/// A function of the image's problem as one that calls the loaded one's.
template <auto member>
struct Link;
template <class... Arguments, int (*odeum_problem::*member)(void*, Arguments...)>
struct Link<member> {
  static int call(void* data, Arguments... arguments) {
    const odeum_problem& problem = problem_of(data);
    return (problem.*member)(problem.data, arguments...);
  }
};

template <auto... members>
void link(odeum_problem& p) {
  ((p.*members = p.*members ? Link<members>::call : nullptr), ...);
}

}  // namespace

Plugin::Plugin(std::string path) : path_(std::move(path)), state_(state_of(path_)) {}

std::shared_ptr<Plugin> Plugin::open(const std::string& path) {
  auto memory = std::make_unique<isolated::SharedMemory>(most_bytes);
  std::shared_ptr<Plugin> plugin(new Plugin(path));
  // An interpreter that imports its packages took 8 s on a machine with much else to do.
  constexpr std::size_t room = 2000;
  const double patience = 10 * isolated::longest_silence();
  const auto [ended, fault] = isolated::text_isolated([&] { return describe(path, memory->get()); },
                                                      room, patience, patience);
  if (!fault.empty()) throw LoadError(fault);
  memory->seal();
  // Kept as long as the program: cases point into it.
  plugin->image_ = static_cast<const odeum_plugin*>(memory.release()->get());
  return plugin;
}

const odeum_plugin& Plugin::loaded() const {
  if (loaded_) return *loaded_;
  if (state_of(path_) != state_) throw LoadError("the plug-in's file has changed during the run");
  std::string why;
  const odeum_plugin* const plugin = load(path_, why);
  if (!plugin) throw LoadError("the plug-in " + why);
  return *(loaded_ = plugin);
}

std::shared_ptr<const Plugin::Linked> Plugin::problem(std::size_t number) const {
  auto linked =
      std::make_shared<Linked>(Linked{shared_from_this(), number, image_->problems[number]});
  odeum_problem& p = linked->functions;
  p.data = linked.get();
  link<&odeum_problem::rhs, &odeum_problem::jacobian, &odeum_problem::banded_jacobian,
       &odeum_problem::sparse_jacobian, &odeum_problem::time_derivative,
       &odeum_problem::acceleration, &odeum_problem::energy, &odeum_problem::exact>(p);
  return linked;
}

}  // namespace odeum::adapters::plugin
