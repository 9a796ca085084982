// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>

namespace odeum {

/// Opens the descriptors 0, 1 and 2 where the program was started with one of them closed, so that
/// no file which it writes later takes their place. To read from them, or to write to them, is an
/// error as before. To be called first.
void open_standard_streams();

/// Writes a text to the standard error, or nothing where that cannot be written: a program does
/// not end because nobody reads its remarks. Safe to call from several threads.
void tell(std::string_view text) noexcept;

}  // namespace odeum
