// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

/// The built program, run by a shell. Only for tests of the label unit, which know its path.
namespace odeum::tests {

struct Result {
  int code = -1;
  std::string output;  ///< stdout and stderr together
};

/// Runs a shell command in which `odeum` stands for the built program.
inline Result shell(const std::string& command) {
  const std::string script = "odeum() { '" ODEUM_BINARY "' \"$@\"; }; { " + command + "; } 2>&1";
  FILE* const pipe = ::popen(("bash -c '" +
                              [&] {
                                std::string quoted;
                                for (const char c : script)
                                  quoted += c == '\'' ? "'\\''" : std::string(1, c);
                                return quoted;
                              }() +
                              "'")
                                 .c_str(),
                             "r");
  Result result;
  std::array<char, 4096> buffer{};
  while (const std::size_t n = std::fread(buffer.data(), 1, buffer.size(), pipe))
    result.output.append(buffer.data(), n);
  const int status = ::pclose(pipe);
  result.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace odeum::tests
