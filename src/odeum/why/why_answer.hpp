// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "odeum/advise/answer.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/why/why.hpp"

/// What why() found, for people and for programs.
namespace odeum::why {

/// The options of `odeum run` and `odeum why` that make a request.
std::string setting_of(const Request& request, const Case& c);

/// The rows of why.csv, one for each segment: from, to, steps, rhs_evaluations, bound_by, step,
/// fastest, rate, of_edge, component.
record::Records segments_of(const Why& why);

/// The command of the better run; empty: there is none.
std::string command_of(const Why& why, const Case& c, const advise::Asked& asked);

/// Lines; the first says the main cause, the last the next command. `judged`: names and texts of
/// what the judge says of the run.
std::string text_of(const Why& why, const Case& c, const advise::Asked& asked,
                    const std::vector<std::pair<std::string, std::string>>& judged = {});

/// With the keys `summary`, `status`, `causes`, `segments`, `others`, `command` and more.
nlohmann::ordered_json json_of(const Why& why, const Case& c, const advise::Asked& asked);

}  // namespace odeum::why
