// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cctype>
#include <string_view>

#include "odeum/cli/problems.hpp"

namespace odeum::cli {

std::string shell_word(const std::string& word) {
  const bool plain = std::ranges::all_of(word, [](unsigned char c) {
    return std::isalnum(c) ||
           std::string_view("_./=+-,:@%").find(static_cast<char>(c)) != std::string_view::npos;
  });
  if (plain) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

std::string words_of(const std::vector<std::string>& sets, const CLI::App& command) {
  std::string words;
  for (const std::string& set : sets) words += " --set " + shell_word(set);
  if (const auto* const chosen = command.get_option_no_throw("--case"); chosen && *chosen)
    words += " --case " + shell_word(chosen->results().front());
  for (const std::string& file : command.get_option("--plugin")->results())
    words += " --plugin " + shell_word(file);
  return words;
}

}  // namespace odeum::cli
