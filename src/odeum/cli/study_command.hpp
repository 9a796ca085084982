// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>
#include <string>

#include "odeum/studies/study.hpp"

namespace odeum::cli {

/// Adds the command that a study declares; `result` receives the exit code when it runs.
void add_study(CLI::App& app, study::Study& study, int& result);

/// The fingerprint that a journal must have to be resumed: of this program and these options.
std::string journal_mark(const study::Options& options);

}  // namespace odeum::cli
