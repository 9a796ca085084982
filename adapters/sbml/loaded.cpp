// SPDX-License-Identifier: BSD-3-Clause
// Loads what reads models when a command names one: to load libsbml takes as long as the rest of a
// short command, most of it for the addresses of its functions.
#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

#include "odeum/input/yaml_tree.hpp"
#include "sbml/module.hpp"

namespace odeum {
namespace adapters::sbml {
namespace {

/// The module stands beside the program, above its tests, or where it is installed. A path that is
/// not absolute would be searched for, where anybody's could lie.
std::filesystem::path module_path() {
  const std::filesystem::path folder =
      std::filesystem::read_symlink("/proc/self/exe").parent_path();
  for (const char* const where : {"", "..", "../lib/odeum"})
    if (const auto path = folder / where / "odeum_sbml.so"; std::filesystem::exists(path))
      return path;
  throw std::runtime_error("SBML is not read: odeum_sbml.so is missing beside " + folder.string());
}

template <class Function>
Function* function(const char* name) {
  static void* const handle = [] {
    void* const loaded = ::dlopen(module_path().c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!loaded) throw std::runtime_error(std::string("SBML is not read: ") + ::dlerror());
    return loaded;
  }();
  void* const found = ::dlsym(handle, name);
  if (!found) throw std::runtime_error(std::string("SBML is not read: ") + ::dlerror());
  return reinterpret_cast<Function*>(found);
}

}  // namespace
}  // namespace adapters::sbml

std::string cases::sbml_support() {
  std::string words;
  adapters::sbml::function<decltype(odeum_sbml_support)>("odeum_sbml_support")(words);
  return words;
}

cases::SbmlText cases::text_of_sbml(const std::string& file, const std::string& xml, double end) {
  SbmlText result;
  std::string fault;
  adapters::sbml::function<decltype(odeum_sbml_text)>("odeum_sbml_text")(file, xml, end, result,
                                                                         fault);
  if (!fault.empty()) throw InputError(fault);
  return result;
}

}  // namespace odeum
