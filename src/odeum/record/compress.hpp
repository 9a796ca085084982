// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace odeum::record {

/// A text as a .gz file, the same bytes for the same text (it holds no date). Throws
/// std::bad_alloc.
std::string gzip_of(std::string_view text);

/// Bytes compressed by zlib, as PNG files and scripts of pages hold them. Throws std::bad_alloc.
std::string zlib_of(std::string_view bytes);

/// The text of a .gz file; empty where it is damaged or cut off.
std::optional<std::string> text_of_gzip(std::string_view bytes);

}  // namespace odeum::record
