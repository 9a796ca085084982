// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/glob.hpp"

namespace odeum {

bool glob_matches(std::string_view pattern, std::string_view text) {
  // On a mismatch after a *, extend its match by one character.
  std::size_t p = 0, t = 0, star = std::string_view::npos, star_text = 0;
  while (t < text.size()) {
    if (p < pattern.size() && pattern[p] == '*') {
      star = p++;
      star_text = t;
    } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
      ++p;
      ++t;
    } else if (star != std::string_view::npos) {
      p = star + 1;
      t = ++star_text;
    } else {
      return false;
    }
  }
  while (p < pattern.size() && pattern[p] == '*') ++p;
  return p == pattern.size();
}

bool any_glob_matches(const std::vector<std::string>& patterns, std::string_view text) {
  bool chosen = false, chooses = false;
  for (const std::string_view pattern : patterns) {
    const bool excludes = pattern.starts_with('!');
    const bool matches = glob_matches(pattern.substr(excludes), text);
    if (excludes && matches) return false;
    chooses = chooses || !excludes;
    chosen = chosen || (!excludes && matches);
  }
  return chosen || !chooses;
}

}  // namespace odeum
