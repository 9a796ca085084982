// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>

namespace odeum {

/// The text of a file of at most `most_bytes`. Throws InputError for what is no regular file, is
/// larger or cannot be read; `name` says what the file is for ("scene"), `raise` what allows more.
std::string read_text_file(const std::string& path, const std::string& name, std::size_t most_bytes,
                           const std::string& raise = "");

}  // namespace odeum
