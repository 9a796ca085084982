// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>

namespace odeum::report {

/// Text that is safe to show anywhere, a terminal included: valid UTF-8 on one line. Line breaks
/// and tabs become spaces; other control characters (terminal escapes), characters that turn the
/// direction of writing, and bytes that are not UTF-8 become U+FFFD.
std::string plain(std::string_view text);

/// Text as part of a file name: letters, digits, - and _, whatever it was.
std::string file_stem(std::string_view text);

/// Bytes as base64, for data in scripts.
std::string base64(std::string_view bytes);

}  // namespace odeum::report
