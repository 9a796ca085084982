// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>

#include "odeum/cases/printed_text.hpp"

namespace odeum::cases {

/// What was printed of a built-in text when Odeum was built; null where there is none of that stem.
const PrintedText* printed_of(std::string_view stem);

}  // namespace odeum::cases
