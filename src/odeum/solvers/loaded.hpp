// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum {

/// The file of a library as it was loaded, and how that was compiled, see how_compiled().
struct LoadedLibrary {
  std::string name, file, compiled;

  std::string text() const { return compiled.empty() ? file : file + ", compiled " + compiled; }
};

/// The first loaded file of each built-in library that bears the name of its adapter, or the first
/// one compiled without optimisation; none of the libraries that are headers alone.
std::vector<LoadedLibrary> loaded_of(const std::vector<LibraryInfo>& libraries);

/// How the library of a solver was compiled, by the first part of the solver's id: found once for
/// all. Empty for what is compiled with the program.
const std::string& how_library_was_compiled(const std::string& library);

}  // namespace odeum
