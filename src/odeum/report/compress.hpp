// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <string_view>

namespace odeum::report {

/// Bytes compressed by zlib at its highest level. Throws std::bad_alloc.
std::string zlib_of(std::string_view bytes);

}  // namespace odeum::report
