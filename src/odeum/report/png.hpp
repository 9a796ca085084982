// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace odeum::report {

/// Red, green, blue and opacity.
using Colour = std::array<std::uint8_t, 4>;

/// A PNG file of at most 16 colours: `pixels` holds an index into `palette` for each, row by row
/// from the top, `width` to a row.
std::string png_of(std::size_t width, const std::vector<std::uint8_t>& pixels,
                   const std::vector<Colour>& palette);

}  // namespace odeum::report
