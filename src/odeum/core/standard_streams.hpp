// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>

namespace odeum {

/// Opens the descriptors 0, 1 and 2 where the program was started with one of them closed, so that
/// no file which it writes later takes their place. To read from them, or to write to them, is an
/// error as before. To be called first.
void open_standard_streams();

/// Writes a text to the standard error, or nothing where that cannot be written: a program does
/// not end because nobody reads its remarks. Whatever it holds of names and files, it is a
/// terminal's (for_terminal of input/utf8.hpp). Safe to call from several threads.
void tell(std::string_view text) noexcept;
/// The same for a line in place of the last one, which is not ended; empty: none.
void tell_in_place(std::string_view line) noexcept;

}  // namespace odeum
