// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/kinds/sbml/sbml.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/core/build_info.hpp"
#include "odeum/formula/cache.hpp"
#include "odeum/solvers/loaded.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::cli {

void add_doctor(CLI::App& app) {
  app.add_subcommand("doctor", "libraries found, versions, compiler, flags")->callback([] {
    std::string text = fmt::format("odeum      {}\ncompiler   {}\nflags      {}\n", build::version,
                                   build::compiler, build::flags);
    for (const LibraryInfo& info : all_libraries())
      text += fmt::format("{:<10} {}\n", info.name,
                          info.built
                              ? info.version
                              : fmt::format("not built in; configure with -D{}=ON", info.option));
    for (const LoadedLibrary& loaded : loaded_of(all_libraries()))
      text += fmt::format("loaded     {}\n", loaded.text());
    const std::string fmi = fmi_support();
    text += fmt::format("{:<10} {}\n", "fmi",
                        fmi.empty() ? "not built in; configure with -DODEUM_WITH_FMI=ON" : fmi);
    const std::string sbml = cases::sbml_support();
    text +=
        fmt::format("{:<10} {}\n", "sbml",
                    sbml.empty() ? "not built in; scripts/bootstrap --with sbml builds it" : sbml);
    const formula::CacheFolder cache = formula::find_cache_folder();
    text +=
        fmt::format("cache      {}\n", cache.path.empty() ? "none: " + cache.problem : cache.path);
    std::size_t solvers = all_solvers().size();
    text += fmt::format("cases      {}\nsolvers    {}\n", known_ids().size(), solvers);
    print(text);
  });
}

}  // namespace odeum::cli
