// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>

namespace odeum {

/// The stem of the file in cases/ that makes a case, by the case's id; no cases of late libraries.
const std::map<std::string, std::string>& case_files();

}  // namespace odeum
