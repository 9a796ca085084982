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

}  // namespace odeum
