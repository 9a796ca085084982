// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "odeum/cli/help.hpp"
#include "odeum/cli/session.hpp"
#include "odeum/core/build_info.hpp"

namespace odeum::cli {
namespace {

/// An option or argument as completions and the manual page need it.
struct Word {
  std::vector<std::string> names;  ///< with dashes; empty: an argument without a name
  std::string usage, meaning;
  std::vector<std::string> values;  ///< those that it takes; empty: any, or none
  std::vector<std::string> listed;  ///< the values are those of `odeum list` with these words
  bool takes_value = false;
};
struct Command {
  std::string name, meaning;
  std::vector<Word> words;
};

/// The words in the braces of CLI11's type of an option that takes one of a list.
std::vector<std::string> values_in(const std::string& type) {
  const std::size_t open = type.find('{'), close = type.rfind('}');
  if (open == std::string::npos || close == std::string::npos) return {};
  return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

Word word_of(const CLI::Option& option) {
  Word word;
  for (const std::string& name : option.get_snames()) word.names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) word.names.push_back("--" + name);
  const std::string type = option.get_type_name();
  word.takes_value = option.get_items_expected_max() > 0;
  word.meaning = option.get_description();
  word.values = word.takes_value ? values_in(type) : std::vector<std::string>();
  word.usage = word.names.empty() ? option.get_name(true, false)
                                  : fmt::format("{}", fmt::join(word.names, ", "));
  if (word.takes_value && !type.empty()) word.usage += " " + type;
  const std::string first = word.names.empty() ? word.usage : word.names.back();
  if (first.starts_with("--solver")) word.listed = {"solvers"};
  if (first.starts_with("--case") || type.starts_with("CASE")) word.listed = {"cases"};
  if (type.starts_with("CASE|SCENE")) word.listed = {"cases", "scenes"};
  return word;
}

std::vector<Command> commands_of(const CLI::App& app) {
  std::vector<Command> commands;
  for (const CLI::App* each : app.get_subcommands([](const CLI::App*) { return true; })) {
    Command command{each->get_name(), each->get_description(), {}};
    for (const CLI::Option* option : each->get_options()) command.words.push_back(word_of(*option));
    commands.push_back(std::move(command));
  }
  return commands;
}

std::string names_of(const std::vector<Command>& commands) {
  std::vector<std::string> names;
  for (const Command& command : commands) names.push_back(command.name);
  return fmt::format("{}", fmt::join(names, " "));
}

/// The command that lists what may follow; own solvers also without their library.
std::string listing(const Word& word) {
  std::string text;
  for (const std::string& what : word.listed)
    text += fmt::format("{}odeum list {} --format csv 2>/dev/null | cut -d, -f2 | tail -n +2{}",
                        text.empty() ? "" : "; ", what,
                        what == "solvers" ? " | sed -n -e p -e s,^odeum/,,p" : "");
  return text;
}

std::string bash(const std::vector<Command>& commands) {
  std::string text = fmt::format(
      "# bash completion of odeum\n"
      "_odeum() {{\n"
      "  local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} words=\n"
      "  COMPREPLY=()\n"
      "  if ((COMP_CWORD == 1)); then\n"
      "    COMPREPLY=($(compgen -W '{} --help --version' -- \"$cur\"))\n"
      "    return\n"
      "  fi\n"
      "  case ${{COMP_WORDS[1]}} in\n",
      names_of(commands));
  for (const Command& command : commands) {
    std::string named, others;
    text += fmt::format("    {})\n      case $prev in\n", command.name);
    for (const Word& word : command.words) {
      const std::string values = word.listed.empty()
                                     ? fmt::format("{}", fmt::join(word.values, " "))
                                     : "$(" + listing(word) + ")";
      if (word.names.empty()) {
        others += " " + values;
        continue;
      }
      named += fmt::format(" {}", fmt::join(word.names, " "));
      if (!word.takes_value) continue;
      text += fmt::format("        {}) words=\"{}\" ;;\n", fmt::join(word.names, "|"), values);
    }
    text += fmt::format(
        "        *) if [[ $cur == -* ]]; then words='{}'; else words=\"{}\"; fi ;;\n"
        "      esac ;;\n",
        named.substr(std::min<std::size_t>(1, named.size())),
        others.substr(std::min<std::size_t>(1, others.size())));
  }
  return text +
         "  esac\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$cur\"))\n"
         "  [[ $cur == -* ]] || COMPREPLY+=($(compgen -f -- \"$cur\"))\n"
         "}\n"
         "complete -o filenames -F _odeum odeum\n";
}

/// The text in single quotes of zsh and fish.
std::string quoted(std::string text) {
  for (const auto& [from, to] : {std::pair("\\", "\\\\"), std::pair("'", "'\\''")})
    text = CLI::detail::find_and_replace(text, from, to);
  return "'" + text + "'";
}

/// A description inside of a specification of zsh's _arguments.
std::string in_arguments(std::string text) {
  for (const char* const special : {"\\", ":", "[", "]"})
    text = CLI::detail::find_and_replace(text, special, std::string("\\") + special);
  return CLI::detail::find_and_replace(text, "'", "'\\''");
}

std::string zsh(const std::vector<Command>& commands) {
  std::string text =
      "#compdef odeum\n# zsh completion of odeum\n\n_odeum() {\n  local -a commands\n  "
      "commands=(\n";
  for (const Command& command : commands)
    text += "    '" + command.name + ":" + in_arguments(command.meaning) + "'\n";
  text +=
      "  )\n  if ((CURRENT == 2)); then\n    _describe command commands\n    return\n  fi\n"
      "  local command=${words[2]}\n  shift words\n  ((CURRENT--))\n  case $command in\n";
  for (const Command& command : commands) {
    text += "    " + command.name + ") _arguments";
    for (const Word& word : command.words) {
      std::string values = "_files";
      if (!word.listed.empty())
        values = fmt::format("{{ compadd -- ${{(f)\"$({})\"}}; _files }}", listing(word));
      if (!word.values.empty()) values = fmt::format("({})", fmt::join(word.values, " "));
      const std::string value = word.takes_value ? ": :" + values : "";
      for (const std::string& name : word.names)
        text += fmt::format(" \\\n      '*{}[{}]{}'", name, in_arguments(word.meaning), value);
      if (word.names.empty()) text += " \\\n      '*" + value + "'";
    }
    text += " ;;\n";
  }
  return text + "  esac\n}\n\n_odeum \"$@\"\n";
}

std::string fish(const std::vector<Command>& commands) {
  std::string text = "# fish completion of odeum\n";
  for (const Command& command : commands) {
    text += fmt::format("complete -c odeum -n __fish_use_subcommand -f -a {} -d {}\n", command.name,
                        quoted(command.meaning));
    for (const Word& word : command.words) {
      text += fmt::format("complete -c odeum -n '__fish_seen_subcommand_from {}'", command.name);
      for (const std::string& name : word.names)
        text +=
            (name.starts_with("--") ? " -l " : " -s ") + name.substr(name.find_first_not_of('-'));
      if (word.takes_value && !word.names.empty()) text += " -r";
      if (!word.listed.empty())
        text += " -a '(" + listing(word) + ")'";
      else if (!word.values.empty())
        text += fmt::format(" -f -a '{}'", fmt::join(word.values, " "));
      text += " -d " + quoted(word.meaning) + "\n";
    }
  }
  return text;
}

/// Text of a manual page, without a character of roff's own.
std::string roff(std::string text) {
  for (const auto& [from, to] : {std::pair("\\", "\\e"), std::pair("-", "\\-")})
    text = CLI::detail::find_and_replace(text, from, to);
  return text.starts_with('.') || text.starts_with('\'') ? "\\&" + text : text;
}

std::string manual(const std::vector<Command>& commands) {
  std::string text = fmt::format(
      ".TH ODEUM 1 \"\" \"odeum {}\" \"User Commands\"\n"
      ".SH NAME\nodeum \\- a laboratory that compares time integrators\n"
      ".SH SYNOPSIS\n.B odeum\n.I COMMAND\n[\\fIARGUMENT\\fR ...]\n"
      ".SH COMMANDS\n",
      build::version);
  for (const Command& command : commands) {
    text += fmt::format(".SS \"odeum {}\"\n{}\n", command.name, roff(command.meaning));
    for (const Word& word : command.words)
      text += fmt::format(".TP\n.B {}\n{}\n", roff(word.usage), roff(word.meaning));
  }
  return text +
         ".SH \"EXIT STATUS\"\n"
         ".TP\n0\nsuccess\n.TP\n1\na check failed\n.TP\n2\nthe arguments or a file are wrong\n"
         ".TP\n3\nno run succeeded\n.TP\n4\na file could not be written\n"
         ".TP\n130\ninterrupted\n"
         ".SH ENVIRONMENT\n"
         ".TP\nXDG_CACHE_HOME\nthe folder in whose \\fIodeum\\fR results are kept; default: "
         "\\fI~/.cache\\fR\n"
         ".TP\nODEUM_COMPILER_SECONDS\nthe seconds of the processor that the compiler of a text "
         "may take; default: 60\n"
         ".TP\nODEUM_SILENCE_SECONDS\nhow long a plug-in or an FMU may work without evaluating a "
         "right-hand side or returning; default: 5\n";
}

}  // namespace

void add_completion(CLI::App& app) {
  const auto what = std::make_shared<std::string>();
  CLI::App* command = app.add_subcommand(
      "completion", "completions of commands and options for a shell, and the manual page");
  command->add_option("what", *what, "a shell, or man")
      ->required()
      ->check(CLI::IsMember({"bash", "zsh", "fish", "man"}));
  command->callback([what, &app] {
    const std::vector<Command> commands = commands_of(app);
    print(*what == "bash"   ? bash(commands)
          : *what == "zsh"  ? zsh(commands)
          : *what == "fish" ? fish(commands)
                            : manual(commands));
  });
}

}  // namespace odeum::cli
