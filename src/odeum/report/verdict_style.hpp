// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <string>

#include "odeum/judge/order_fit.hpp"

namespace odeum::report {

/// A verdict as pages show it; its CSS class and name are its to_string.
struct VerdictStyle {
  judge::Verdict verdict;
  const char* glyph;    ///< tells verdicts apart without colour
  const char* meaning;  ///< in a clause
};

/// Every verdict, the best first.
inline constexpr std::array<VerdictStyle, 7> verdict_styles{{
    {judge::Verdict::confirmed, "✓", "the claimed order lies within the tolerance of the slope"},
    {judge::Verdict::higher, "▲", "errors fall faster than claimed"},
    {judge::Verdict::lower, "▼", "errors fall more slowly than claimed"},
    {judge::Verdict::floors, "⊥", "errors stop falling at a level that is printed"},
    {judge::Verdict::undetermined, "?", "too few points, or no settled slope"},
    {judge::Verdict::failed, "✗", "no run gave a result"},
    {judge::Verdict::not_applicable, "·", "the solver does not fit the case, or there is no claim"},
}};

inline const VerdictStyle& style_of(judge::Verdict verdict) {
  return verdict_styles[static_cast<std::size_t>(verdict)];
}

/// "✓ confirmed" as a coloured chip.
inline std::string verdict_chip(judge::Verdict verdict) {
  const std::string name = to_string(verdict);
  return "<span class=\"chip " + name + "\">" + style_of(verdict).glyph + " " + name + "</span>";
}

}  // namespace odeum::report
