// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>

/// The units of the build that results are kept by (scripts/cmake/HashUnits.cmake).
namespace odeum {

/// The stem of the file in cases/ that makes a case, by the case's id; no cases of libraries that
/// come at run time.
const std::map<std::string, std::string>& case_files();

/// The unit of an own method: that of its family, the first word of its name.
inline std::string unit_of_own(const std::string& method) {
  return "own/" + method.substr(0, method.find_first_not_of("abcdefghijklmnopqrstuvwxyz"));
}

}  // namespace odeum
