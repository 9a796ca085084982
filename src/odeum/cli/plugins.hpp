// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "odeum/contest/late.hpp"

namespace odeum::cli {

/// --plugin FILE on every command that has been added: its problems and solvers are known before
/// the command runs.
inline void add_plugin_option(CLI::App& app) {
  const auto add = [](CLI::App& to) {
    to.add_option_function<std::vector<std::string>>(
          "--plugin",
          [](const std::vector<std::string>& files) {
            for (const std::string& file : files) add_plugin(file);
          },
          "a shared object with problems and solvers of your own, see odeum/plugin.h")
        ->type_name("FILE.so")
        ->allow_extra_args(false);
  };
  add(app);
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) add(*command);
}

}  // namespace odeum::cli
