// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>

#include "odeum/report/facts.hpp"

namespace odeum::report {

/// A whole page of the report. `top` and `main` are markup; `scripts` holds addresses. Scripts and
/// pictures may come from the folder itself and nowhere else.
std::string document(const std::string& title, const std::string& top, const std::string& main,
                     const std::vector<std::string>& scripts = {});

/// The name of the file in data/ with a case's data for the views, without its ending.
std::string data_name(const CaseFacts& c);

}  // namespace odeum::report
