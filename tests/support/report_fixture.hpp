// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/report/report_data.hpp"

namespace odeum::test {

/// A made-up contest for the page: as many cases and solvers as the project has, every verdict and
/// status among them, errors that follow a power of the step down to rounding. The same every time.
report::ReportData fabricate_report();

/// The same with two cases and three solvers, for tests that look at single cells.
report::ReportData fabricate_small_report();

}  // namespace odeum::test
