// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <string>

#include "odeum/core/request.hpp"

namespace odeum::isolated {

/// A request as bytes, for a process of this program that was started before it was made.
std::string bytes_of(const Request& request);
Request request_of(const char* bytes);

}  // namespace odeum::isolated
