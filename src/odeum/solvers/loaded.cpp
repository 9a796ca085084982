// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/solvers/loaded.hpp"

#include <cctype>
#include <filesystem>
#include <map>
#include <utility>

#include "odeum/core/machine.hpp"

namespace odeum {

std::vector<LoadedLibrary> loaded_of(const std::vector<LibraryInfo>& libraries) {
  std::vector<LoadedLibrary> all;
  const std::vector<std::string> loaded = loaded_libraries();
  for (const LibraryInfo& info : libraries) {
    if (!info.built) continue;
    LoadedLibrary worst;
    for (const std::string& file : loaded) {
      std::string name = std::filesystem::path(file).filename().string();
      for (char& c : name) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
      if (name.find(info.name) == std::string::npos) continue;
      const std::string compiled = how_compiled(file);
      if (worst.file.empty() || (compiled == unoptimised && worst.compiled != unoptimised))
        worst = {info.name, file, compiled};
    }
    if (!worst.file.empty()) all.push_back(std::move(worst));
  }
  return all;
}

const std::string& how_library_was_compiled(const std::string& library) {
  static const std::map<std::string, std::string> by_library = [] {
    std::map<std::string, std::string> found;
    for (const LoadedLibrary& loaded : loaded_of(all_libraries()))
      for (const LibraryInfo& info : all_libraries())
        if (info.name == loaded.name)
          for (const std::string& each : info.libraries) found[each] = loaded.compiled;
    return found;
  }();
  static const std::string with_the_program;
  const auto found = by_library.find(library);
  return found == by_library.end() ? with_the_program : found->second;
}

}  // namespace odeum
