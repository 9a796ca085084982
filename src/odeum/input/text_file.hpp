// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace odeum {

/// The text of a file of at most `most_bytes`. Throws InputError for what is not a regular file, is
/// larger or cannot be read; `name` is the kind of file in errors ("scene"), `raise` the option
/// that allows more.
std::string read_text_file(const std::string& path, const std::string& name, std::size_t most_bytes,
                           const std::string& raise = "");

/// The bytes of a file that Odeum itself wrote; nothing where it cannot be read or is not a regular
/// file: a pipe or a device in its place would never end.
std::optional<std::string> text_of_file(const std::filesystem::path& path);
/// Whether the file could be written.
bool write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace odeum
