// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/standard_streams.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

#include "odeum/input/utf8.hpp"

namespace odeum {
namespace {

void write(std::string_view before, std::string_view text) noexcept {
  try {
    const std::string all = std::string(before) + for_terminal(text);
    std::fwrite(all.data(), 1, all.size(), stderr);
    std::fflush(stderr);
  } catch (const std::exception&) {  // no memory is left for a remark
    return;
  }
}

}  // namespace

void open_standard_streams() {
  for (int descriptor = 0; descriptor <= 2; ++descriptor) {
    if (::fcntl(descriptor, F_GETFD) >= 0) continue;
    // The lowest free one is taken. The other direction than that of its use, which then fails.
    if (::open("/dev/null", descriptor == 0 ? O_WRONLY : O_RDONLY) != descriptor) std::abort();
  }
}

void tell(std::string_view text) noexcept { write("", text); }
void tell_in_place(std::string_view line) noexcept { write("\r\x1b[K", line); }

}  // namespace odeum
