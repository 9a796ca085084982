// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/report/output_folder.hpp"
#include "odeum/report/report_data.hpp"

namespace odeum::report {

/// Writes index.html and manifest.json beside the CSV files, which are there already. The page
/// stands alone: one file without scripts, its pictures within; the names that it shows may be
/// anybody's text. Pictures are drawn by gnuplot; without it the page is written all the same, and
/// says so, as the manifest does. Throws FileError.
void write_page(const ReportData& data, const OutputFolder& folder);

}  // namespace odeum::report
