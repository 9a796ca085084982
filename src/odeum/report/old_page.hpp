// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/record/output_folder.hpp"
#include "odeum/report/report_data.hpp"

namespace odeum::report {

/// Writes index.html, a page for each case in cases/, the pictures of stability/, and
/// manifest.json beside the CSV files, which are there already. The folder stands alone: no
/// scripts, nothing from elsewhere, addresses relative, so that it may be moved and opened from a
/// disk. The names that the pages show may be anybody's text. Pictures are drawn by gnuplot;
/// without it the page is written all the same, and says so, as the manifest does. Throws
/// FileError.
void write_page(const ReportData& data, const record::OutputFolder& folder);

}  // namespace odeum::report
