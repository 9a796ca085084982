// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/record/output_folder.hpp"
#include "odeum/report/page.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/precision/precision.hpp"

/// What a report has beside the sections of its studies.
namespace odeum::cli {

inline constexpr const char* replayed_case = "cloth11_two_way";

/// Runs the cloth with own integrators and those of Bullet, beside the exact motion, and writes
/// their replays in step, with the error as colour, into replay/; a section of the page tells of
/// them. Nothing where the page has no cloth. Throws Interrupted.
void add_replays(report::Page& page, const record::OutputFolder& folder, unsigned jobs);

/// Makes the cheap runs of both studies again, with output, on those cases of the page whose ids
/// `cases` holds (empty: on all), and hands them to the page: data/solutions_<data of the case>.js.
/// Throws Interrupted.
void add_solutions(report::Page& page, const std::vector<std::string>& cases,
                   const study::ConvergenceResult& converged, const study::PrecisionResult& timed,
                   unsigned jobs);

}  // namespace odeum::cli
