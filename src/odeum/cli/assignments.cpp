// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/assignments.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "odeum/cli/session.hpp"
#include "odeum/input/yaml_tree.hpp"

namespace odeum::cli {

std::vector<std::pair<std::string, double>> parse_assignments(
    const std::string& option, const std::vector<std::string>& texts) {
  std::vector<std::pair<std::string, double>> list;
  for (const std::string& text : texts) {
    const auto fail = [&](const char* what) {
      throw UsageError(
          fmt::format("{}: {}; got {}, expected NAME=NUMBER", option, what, shown(text)));
    };
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) fail("no assignment");
    const std::string name = text.substr(0, equals);
    const char *begin = text.data() + equals + 1, *const end = text.data() + text.size();
    if (begin != end && *begin == '+') ++begin;
    double value = 0;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || stop != end) fail("not a number");
    if (!std::isfinite(value)) fail("not finite");
    for (const auto& [other, unused] : list)
      if (other == name) fail("given twice");
    list.emplace_back(name, value);
  }
  return list;
}

}  // namespace odeum::cli
