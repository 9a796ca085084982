// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdio>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

/// What tests of answers share.
namespace odeum::advise_tests {

/// The number after a word at the start of a line.
inline double number_after(const std::string& text, const std::string& word) {
  double value = -1;
  const std::size_t at = text.find("\n" + word);
  if (at != std::string::npos) std::sscanf(text.c_str() + at + 1 + word.size(), "%lf", &value);
  return value;
}

/// The lines of a text that begin with a word.
inline std::size_t lines_with(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = 0; (at = text.find("\n" + word, at)) != std::string::npos; ++at) ++count;
  return count;
}

/// A problem's file in a folder of its own, as a word of a command.
struct File {
  explicit File(const std::string& text) {
    tests::write_text((root.path() / "problem.yaml").string(), text);
  }
  std::string word() const { return "'" + (root.path() / "problem.yaml").string() + "' "; }
  tests::TemporaryFolder root;
};

}  // namespace odeum::advise_tests
