// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/kept_results.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "odeum/cases/catalogue.hpp"
#include "odeum/core/build_info.hpp"
#include "odeum/core/file_sum.hpp"
#include "odeum/core/machine.hpp"
#include "odeum/formula/cache.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::cli {
namespace {

/// The processor, and the shared libraries (the C library's functions among them).
std::string mark_of_machine() {
  std::string mark = cpu_model();
  for (const std::string& path : loaded_libraries()) {
    std::error_code none;
    const std::filesystem::path file = std::filesystem::canonical(path, none);
    const auto size = none ? 0 : std::filesystem::file_size(file, none);
    if (none) continue;  // what the kernel adds
    const auto time = std::filesystem::last_write_time(file, none).time_since_epoch().count();
    mark += fmt::format(" {} {} {}", file.string(), size, time);
  }
  return mark;
}

}  // namespace

std::string mark_of_program() {
  static const std::string program =
      fmt::format("{} {} {} {}", build::version, build::revision, build::flags,
                  sum_of_file("/proc/self/exe"));  // every shard of a plan begins with it
  std::string mark = program;
  for (const RuntimeLibrary& library : runtime_libraries()) mark += " " + library.mark;
  return mark;
}

record::Store* seconds_of_tasks(const Session& session) {
  static const std::string folder = formula::cache_folder();
  static const auto store =
      folder.empty() ? nullptr : std::make_unique<record::Store>(folder + "/seconds", 1U << 26);
  const bool elsewhere = session.assignment.role == shards::Role::shard ||
                         session.assignment.role == shards::Role::merge;
  return elsewhere ? nullptr : store.get();
}

study::ResultCache result_cache_of(const Session& session, record::Store* store,
                                   const study::Options& options) {
  static const std::string here = mark_of_program() + ' ' + mark_of_machine() + ' ';
  const std::string build = session.assignment.is_alone() ? here : session.assignment.plan + ' ';
  const std::string run = build + options.text() + session.content;
  study::Options settings = options;
  settings.cases.clear();
  settings.solvers.clear();
  return {.store = store,
          .dependencies = run,
          .dependencies_of_built_in = build + settings.text(),
          .share = session.assignment.share,
          .seconds = seconds_of_tasks(session),
          .settings = "seconds " + settings.text()};
}

std::unique_ptr<record::Store> open_store(const Session& session, const StudyOptions& options) {
  if (!session.assignment.is_alone()) return shards::store_of(session.assignment);
  const std::string folder = options.no_cache ? "" : formula::cache_folder();
  return folder.empty() ? nullptr : std::make_unique<record::Store>(folder + "/results");
}

void remark_on(const record::Store* store) {
  if (!store) return;
  if (!store->problem().empty())
    remark("results are not kept: " + store->problem());
  else if (store->taken() > 0)
    remark("reused {} of {} results from {}; --no-cache measures all again", store->taken(),
           store->taken() + store->added(), store->folder().string());
}

std::string resume_hint(const record::Store* store) {
  return store && store->problem().empty() ? "the same command continues" : "no file was written";
}

}  // namespace odeum::cli
