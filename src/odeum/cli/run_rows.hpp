// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "odeum/trajectories/run_page.hpp"

namespace odeum::cli {

using trajectories::RunRow;

/// Prints rows as JSON (an object with the list `runs`) or CSV. JSON has the states of a case, too,
/// at the end or at the outputs; `runs`: of a case, one a row.
void print_rows(const std::vector<RunRow>& rows, const std::string& format, const Case* c = nullptr,
                const std::vector<trajectories::CaseRun>& runs = {});

/// `82 evaluations, 3 Jacobians, 214 products in linear solvers`.
std::string cost_text(const Counters& counters);

/// The text of a run whose error waits for the truth: how it ended, and its end state where it has
/// few numbers. `seconds`: of the processor.
std::string first_text(const trajectories::CaseRun& run, std::size_t numbers, double seconds);

/// Lines: the error, whether the tolerance explains it, and what else the run shows.
std::string error_text(const Case& c, const trajectories::CaseRun& run, const RunRow& row);

/// `wrong: <reason>`; empty where nothing is said of the answer.
std::string answer_text(const RunRow& row);
/// Names and texts: the answer, where something is said of it, and the remarks.
std::vector<std::pair<std::string, std::string>> answer_and_remarks(const RunRow& row);

/// Lines: a scene's run at its setting, how it ended, its cost, energy and contacts. `seconds`: of
/// the processor.
std::vector<std::string> describe_run(const trajectories::SceneRun& run, double seconds);

/// Lines: its error in m, and what the judge says of it. `errors`: null where no truth was asked
/// for.
std::string text_of_answer(const trajectories::SceneRun& run,
                           const trajectories::SceneErrors* errors, const RunRow& row);

}  // namespace odeum::cli
