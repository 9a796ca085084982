// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/kinds/kind.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>

#include "odeum/cases/text_case.hpp"
#include "odeum/formula/cache.hpp"
#include "odeum/input/text_file.hpp"

namespace odeum::cases {

// lists/kinds.inc is generated: the folders of kinds.
#define ODEUM_ITEM(name) Kind name##_kind();
#include "lists/kinds.inc"
#undef ODEUM_ITEM

bool Named::is_file() const {
  std::error_code ignored;
  return std::filesystem::is_regular_file(word_, ignored);
}

bool Named::exists() const {
  std::error_code ignored;
  return std::filesystem::exists(word_, ignored);
}

const std::string& Named::text(const std::string& name, std::size_t most_bytes,
                               const std::string& raise) const {
  if (!text_ || text_->size() > most_bytes) text_ = read_text_file(word_, name, most_bytes, raise);
  return *text_;
}

const std::string& problem_text(const Named& named) {
  return named.text("problem", formula::most_problem_bytes);
}

bool is_problem_text(const Named& named) {
  try {
    return named.is_file() && formula::looks_like_problem(named.word(), problem_text(named));
  } catch (const InputError&) {
    return false;
  }
}

ReadProblem translated(const Named& named, const Given& given,
                       const std::function<std::string(double end)>& text) {
  constexpr double usual_end = 10;
  const std::string made = text(std::isnan(given.span.until) ? usual_end : given.span.until);
  // Errors in it have places of its own.
  return {text_statements(named.word() + " (as a text)", made, given.id, given.set, given.span),
          fmt::format("{} {}", formula::content_key(made), given.set)};
}

const Kind* kind_of(const Named& named) {
  static const std::vector<Kind> all{
#define ODEUM_ITEM(name) name##_kind(),
#include "lists/kinds.inc"
#undef ODEUM_ITEM
  };
  for (const Kind& kind : all)
    if (kind.recognises(named)) return &kind;
  return nullptr;
}

}  // namespace odeum::cases
