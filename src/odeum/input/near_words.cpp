// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/input/near_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace odeum {
namespace {

/// Words of other programs for keys of texts and scenes.
struct Synonyms {
  std::string_view key;
  std::vector<std::string_view> words;
};
const Synonyms synonyms[] = {
    {"states",
     {"start", "initial", "initial_values", "initial_conditions", "init", "ic", "y0", "x0", "u0",
      "variables"}},
    {"equations", {"ode", "odes", "rhs", "dynamics", "derivatives", "f", "model", "system"}},
    {"time",
     {"t", "end", "t_end", "tspan", "t_span", "interval", "until", "duration", "t_final", "tf"}},
    {"parameters", {"constants", "consts", "params", "p", "args"}},
    {"definitions", {"let", "where", "algebraic", "auxiliary", "expressions", "functions"}},
    {"exact", {"solution", "analytic", "analytical"}},
    {"end", {"stop", "t_end", "to", "final", "t1", "tf", "duration"}},
};

}  // namespace

std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  for (const auto& [key, words] : synonyms)
    if (std::ranges::find(words, word) != words.end() &&
        std::ranges::find(candidates, key) != candidates.end())
      return std::string(key);
  std::string best;
  std::size_t best_distance = word.size() / 3 + 2;
  std::vector<std::size_t> row;
  for (const std::string& candidate : candidates) {
    row.resize(candidate.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= word.size(); ++i) {
      std::size_t diagonal = row[0]++;
      for (std::size_t j = 1; j <= candidate.size(); ++j) {
        const std::size_t replaced = diagonal + (word[i - 1] != candidate[j - 1]);
        diagonal = row[j];
        row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
      }
    }
    if (row.back() < best_distance) {
      best_distance = row.back();
      best = candidate;
    }
  }
  return best;
}

std::string near_one(std::string_view word, const std::vector<std::string>& candidates) {
  const std::string near = nearest(word, candidates);
  return near.empty() ? "" : "; did you mean " + near + "?";
}

std::string one_of(const std::vector<std::string>& candidates, std::string_view word) {
  return fmt::format("{}{}{}", candidates.size() > 1 ? "one of " : "", fmt::join(candidates, ", "),
                     word.empty() ? "" : near_one(word, candidates));
}

}  // namespace odeum
