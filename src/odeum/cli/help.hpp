// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace odeum::cli {

/// CLI11's help in lines of the terminal's width where words allow it; where there is no terminal,
/// of $COLUMNS, or of 100 columns. COLUMNS=0 has lines as long as they are.
class WrappedHelp : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  /// A name that reaches into the explanations has its own on the next line.
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
};

/// Adds the command `help`, which main() reads as --help behind the command that it names.
void add_help(CLI::App& app);
/// Puts the commands into the groups in which the help lists them.
void group_commands(CLI::App& app);

/// For arguments that the command (a subcommand of `app`, or itself) does not know: the nearest of
/// its options or subcommands, as did_you_mean() says it; empty: none is near.
std::string hint_of(const CLI::App& app);

/// Adds the command that prints completions for a shell and the manual page, from the declarations
/// of all commands that have been added.
void add_completion(CLI::App& app);

}  // namespace odeum::cli
