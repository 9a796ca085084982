// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/kinds/kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "odeum/cases/text_case.hpp"
#include "odeum/formula/cache.hpp"

namespace odeum::cases {

namespace {

ReadProblem read_text(const Named& named, const Given& given) {
  const std::string& text = problem_text(named);
  return {text_statements(named.word(), text, given.id, given.set, given.span),
          fmt::format("{} {}", formula::content_key(text), given.set)};
}

}  // namespace

Kind text_kind() {
  // Without a file the message is that of a problem's.
  return {"problem", "_text", false,
          [](const Named& named) {
            return is_problem_text(named) || (named.has_yaml_name() && !named.exists());
          },
          read_text};
}

}  // namespace odeum::cases
