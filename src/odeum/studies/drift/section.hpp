// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <vector>

#include "odeum/report/page.hpp"
#include "odeum/studies/drift/drift.hpp"

namespace odeum::study {

/// Parts of the page, each empty without rows: the energy of every solver against time on one case;
/// what the undamped oscillator loses of amplitude and phase; and for how long chaos can be
/// followed.
std::string drift_diagram(const report::Facts& facts, const std::vector<DriftRow>& rows,
                          const std::string& case_id);
std::string oscillator_part(const report::Facts& facts, const std::vector<DriftRow>& rows);
std::string horizons_part(const report::Facts& facts, const std::vector<HorizonRow>& rows);

/// By what power of time an error grows: the slope between its largest in the last tenth of the
/// times and in the tenth before. 0 where all is rounding, NaN with too few rows.
double growth_power(const std::vector<const DriftRow*>& series);

}  // namespace odeum::study
