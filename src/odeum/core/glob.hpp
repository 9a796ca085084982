// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace odeum {

/// Whether a shell pattern (* any run of characters, ? any one) matches the whole text.
bool glob_matches(std::string_view pattern, std::string_view text);

/// Whether one of the patterns matches and none of those that begin with ! does; without a pattern
/// that does not, everything matches that is not excluded.
bool any_glob_matches(const std::vector<std::string>& patterns, std::string_view text);

/// The candidate with the smallest edit distance to an unknown word, for "did you mean"; empty
/// where that exceeds a third of its length plus one.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// "; did you mean X?" with the nearest candidate; empty where none is near.
std::string near_one(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace odeum
