// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/report/report_data.hpp"

namespace odeum::test {

/// Synthetic results for the page: as many cases and solvers as the project has, with every verdict
/// and status, errors that follow a power of the step down to rounding. Deterministic.
report::ReportData fabricate_report();

/// The same with two cases and three solvers, for tests that look at single cells.
report::ReportData fabricate_small_report();

}  // namespace odeum::test
