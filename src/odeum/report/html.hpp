// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>

namespace odeum::report {

/// Text that is safe to show anywhere, a terminal included: valid UTF-8 on one line. Line breaks
/// and tabs become spaces; other control characters (terminal escapes), characters that turn the
/// direction of writing, and bytes that are no UTF-8 become U+FFFD.
std::string plain(std::string_view text);

/// `plain`, and & < > " ' as entities: safe as the content of an element and of an attribute.
std::string escape(std::string_view text);

/// A number for a reader, at most `digits` significant digits: 0.0125, 3.1e-12, ∞, and – for NaN.
std::string show_number(double value, int digits = 3);

/// Nanoseconds for a reader: "850 ns", "12.3 µs", "4.56 ms", "1.2 s".
std::string show_time(double ns);

/// `count` with its noun: "1 case", "3 cases".
std::string show_count(std::size_t count, std::string_view noun);

/// Bytes as base64, for data: addresses.
std::string base64(std::string_view bytes);

/// A file name as a relative address: everything but letters, digits and -._~/ percent-encoded.
std::string as_address(std::string_view path);

}  // namespace odeum::report
