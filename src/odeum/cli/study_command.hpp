// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>

#include "odeum/studies/study.hpp"

namespace odeum::cli {

/// Adds the command that a study declares; `result` receives the exit code when it runs.
void add_study(CLI::App& app, study::Study& study, int& result);

}  // namespace odeum::cli
