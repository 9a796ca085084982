// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "odeum/cli/session.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::cli {

/// What a run of a study with these options keeps its results by, in a store (null: nowhere): the
/// program's own bytes, the processor and shared libraries, the options, and the texts that were
/// loaded. A pair of a built-in case depends on neither the options that are globs nor these texts.
study::ResultCache result_cache_of(const Session& session, record::Store* store,
                                   const study::Options& options);

/// Where the seconds of tasks are kept, in the folder that is the user's at the first call; null in
/// shards, whose machine is another, and where there is no folder.
record::Store* seconds_of_tasks(const Session& session);

/// Identifies the program's own bytes and the plug-ins that are loaded.
std::string mark_of_program();

/// The store of kept results; null with --no-cache, and where the user has no folder for it.
std::unique_ptr<record::Store> open_store(const Session& session, const StudyOptions& options);

/// Prints how many results were not measured, or why they are not kept. `store` may be null.
void remark_on(const record::Store* store);

/// What an interrupted run leaves.
std::string resume_hint(const record::Store* store);

}  // namespace odeum::cli
