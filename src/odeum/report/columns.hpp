// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/record/row.hpp"

namespace odeum::report {

/// Rows as JSON for the page's scripts, column by column, which compresses well: an object with the
/// columns in `names` that the rows have. A column of numbers is an array, rounded to 8 digits, NaN
/// as null and infinities as "inf" and "-inf"; a column of texts is {"words": [distinct texts],
/// "of": [an index for each row]}.
std::string columns_json(const std::vector<record::Fields>& rows,
                         const std::vector<std::string>& names);

/// A number as in columns_json.
std::string json_number(double value);

/// A script that hands a JSON text to the page's scripts under a name: compressed (zlib) and in
/// base64, since a page that is opened from a disk may load scripts and nothing else.
std::string data_script(const std::string& name, const std::string& json);

}  // namespace odeum::report
