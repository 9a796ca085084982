// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "odeum/cli/session.hpp"
#include "odeum/studies/study.hpp"

namespace odeum::cli {

/// What a run of a study with these options keeps its results by, in a store (null: nowhere).
/// - Any result depends on the whole program, all options, and what was loaded.
/// - One of a built-in case and solver depends on the object files of the solver's family (of its
///   adapter), of the case, of own families that the judge uses, and of all that is no method,
///   adapter, case or page; on options that are no globs, shared libraries and the processor.
/// A function that several object files define is linked from one of them; its copies have the same
/// source, but may round differently where the compiler joins operations differently.
study::ResultCache result_cache_of(record::Store* store, const study::Options& options);

/// The store of kept results; null with --no-cache, and where the user has no folder for it.
std::unique_ptr<record::Store> open_store(const StudyOptions& options);

/// Prints how many results were not measured, or why they are not kept. `store` may be null.
void remark_on(const record::Store* store);

/// What an interrupted run leaves.
std::string what_continues(const record::Store* store);

}  // namespace odeum::cli
