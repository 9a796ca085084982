// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace odeum {

/// For "did you mean": the candidate that other programs call by an unknown word, or the one with
/// the smallest edit distance to it; empty where that exceeds a third of its length plus one.
std::string nearest(std::string_view word, const std::vector<std::string>& candidates);

/// "; did you mean X?" with the nearest candidate; empty where none is near.
std::string near_one(std::string_view word, const std::vector<std::string>& candidates);

/// "one of a, b, c", for what an error expects; with the word that it got: "; did you mean b?".
std::string one_of(const std::vector<std::string>& candidates, std::string_view word = {});

}  // namespace odeum
