// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/report/origin.hpp"
#include "odeum/report/page.hpp"
#include "odeum/studies/limits/limits.hpp"

namespace odeum::study {

/// What the page shows of a result.
void add_section(report::Page& page, const LimitsResult& result, const report::Origin& origin);

}  // namespace odeum::study
