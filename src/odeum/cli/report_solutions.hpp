// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/report/page.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/precision/precision.hpp"

namespace odeum::cli {

/// Makes the cheap runs of both studies again, with output, on those cases of the page whose ids
/// `cases` holds (empty: on all), and hands them to the page: data/solutions_<data of the case>.js.
/// Throws Interrupted.
void add_solutions(report::Page& page, const std::vector<std::string>& cases,
                   const study::ConvergenceResult& converged, const study::PrecisionResult& timed,
                   unsigned jobs);

}  // namespace odeum::cli
