// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string_view>

/// This build. The values are in a source file that is generated, so that a new revision compiles
/// that one alone.
namespace odeum::build {

extern const std::string_view version;
extern const std::string_view revision;  ///< when it was configured; empty: not known
extern const std::string_view compiler, type, flags;
extern const std::string_view truth_code;  ///< a hash of the files that compute references

}  // namespace odeum::build
