// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/record/output_folder.hpp"
#include "odeum/report/page.hpp"

namespace odeum::cli {

inline constexpr const char* replayed_case = "cloth11_two_way";

/// Runs the cloth with own integrators and those of Bullet, beside the exact motion, and writes
/// their replays in step, with the error as colour, into replay/; a section of the page tells of
/// them. Nothing where the page has no cloth. Throws Interrupted.
void add_replays(report::Page& page, const record::OutputFolder& folder, unsigned jobs);

}  // namespace odeum::cli
