// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "odeum/advise/answer.hpp"
#include "odeum/advise/why.hpp"

/// What why() found, for people and for programs.
namespace odeum::advise {

/// The options of `odeum run` and `odeum why` that make a request.
std::string setting_of(const Request& request, const Case& c);

/// Lines; the first says the main cause, the last the next command.
std::string text_of(const Why& why, const Case& c, const Asked& asked);

/// With the keys `summary`, `status`, `causes`, `segments`, `others`, `command` and more.
nlohmann::ordered_json json_of(const Why& why, const Case& c, const Asked& asked);

}  // namespace odeum::advise
