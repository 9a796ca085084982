// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>

#include "odeum/record/csv.hpp"

namespace odeum::record {

/// The table in a text, as read_records() has it of a file; errors call it `name`.
Records records_of(std::string_view text, const std::string& name);

}  // namespace odeum::record
