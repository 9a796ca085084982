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

/// The text of a .gz file; nothing where it is damaged, cut off or followed by something else, or
/// where the text has more than `most` bytes.
std::optional<std::string> text_of_gzip(std::string_view bytes,
                                        std::size_t most = std::string_view::npos);

}  // namespace odeum::record
