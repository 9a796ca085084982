// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cli/session.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <thread>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/scene_case.hpp"
#include "odeum/core/glob.hpp"
#include "odeum/core/standard_streams.hpp"
#include "odeum/input/near_words.hpp"
#include "odeum/input/utf8.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/solvers/pieces.hpp"
#include "odeum/solvers/runtime_library.hpp"
#include "odeum/studies/elements/problems.hpp"

namespace odeum::cli {
namespace {

std::vector<std::string> solver_ids() {
  std::vector<std::string> ids;
  for (const Solver& solver : all_solvers()) ids.push_back(solver.info.id());
  // What single problems bring: scenes of free particles, and FMUs.
  ids.insert(ids.end(), {"odeum/closed_form", "fmu/co_simulation"});
  return ids;
}

// Names the option that builds a library that is not in this build.
std::string missing_library(const std::string& word) {
  for (const LibraryInfo& info : all_libraries())
    for (const std::string& name : info.libraries)
      if (!info.built && word.starts_with(name + "/"))
        return fmt::format("{} was not built in; configure with -D{}=ON", name, info.option);
  return "";
}

void check_globs(const char* what, const std::vector<std::string>& globs,
                 const std::vector<std::string>& ids) {
  for (const std::string& glob : globs) {
    const std::string pattern = glob.substr(glob.starts_with('!'));
    if (std::ranges::any_of(ids, [&](const std::string& id) { return glob_matches(pattern, id); }))
      continue;
    if (const std::string missing = missing_library(glob); !missing.empty())
      throw UsageError(missing);
    const std::string near = did_you_mean(glob, ids);
    throw UsageError("no {0} matches '{1}'{2}", what, glob,
                     near.empty() ? fmt::format("; see odeum list {}s", what) : near);
  }
  if (std::ranges::none_of(ids, [&](const std::string& id) { return any_glob_matches(globs, id); }))
    throw UsageError("no {} is left by '{}'", what, fmt::join(globs, " "));
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& candidates) {
  std::vector<std::string> longer;
  for (const std::string& candidate : candidates)
    if (word.size() > 2 && candidate.starts_with(word)) longer.push_back(candidate);
  if (longer.size() > 1) {
    const bool more = longer.size() > 4;
    if (more) longer.resize(4);
    return fmt::format("; did you mean one of {}{}?", fmt::join(longer, ", "), more ? ", ..." : "");
  }
  std::string near = nearest(word, candidates);
  if (near.empty() && !longer.empty()) near = longer.front();
  return near.empty() ? "" : fmt::format("; did you mean {}?", near);
}

void print(const std::string& text) {
  // A reader of a pipe may close it (`| head`): the command goes on, for its files and exit code.
  static bool reader_gone = false;
  constexpr std::size_t most = 1U << 20U;  // so that a long text is not held twice
  for (std::string_view rest = text; !rest.empty() && !reader_gone;) {
    const std::size_t line = rest.size() > most ? rest.rfind('\n', most) : std::string::npos;
    const std::string_view piece = rest.substr(0, std::min(line, rest.size() - 1) + 1);
    rest.remove_prefix(piece.size());
    const std::string safe = for_terminal(piece);
    // A long text is written before the flush, which then does not report its failure.
    if (std::fwrite(safe.data(), 1, safe.size(), stdout) == safe.size() && std::fflush(stdout) == 0)
      continue;
    reader_gone = errno == EPIPE;
    if (!reader_gone)
      throw record::FileError(
          fmt::format("cannot write to the standard output: {}", std::strerror(errno)));
  }
}

void remark(const std::string& text) { tell(text + "\n"); }

void remark_on_page(bool written) {
  if (written) return;
  remark(
      "there is no page: share/odeum, which holds its code and texts, stands neither beside the "
      "program nor beside its folder");
}

void check_case_globs(const std::vector<std::string>& globs) {
  check_globs("case", globs, known_ids());
}
void check_solver_globs(const std::vector<std::string>& globs) {
  std::vector<std::string> firsts = globs;
  for (std::string& glob : firsts)
    if (glob.ends_with(as_it_comes)) glob.resize(glob.size() - as_it_comes.size());
  check_globs("solver", firsts, solver_ids());
}

std::string with_library(const std::string& glob) {
  const std::size_t name = glob.starts_with('!') ? 1 : 0;
  const std::string pattern = glob.substr(name);
  const auto matches = [&](const std::string& id) { return glob_matches(pattern, id); };
  if (pattern.empty() || pattern.find('/') != std::string::npos ||
      (pattern.find_first_of("*?") != std::string::npos &&
       std::ranges::any_of(solver_ids(), matches)))
    return glob;
  return glob.substr(0, name) + "odeum/" + pattern;
}

void refuse_in_space(const std::string& problems) {
  throw UsageError(
      "'{}' names problems in space alone, which have no steps in time; odeum elements and odeum "
      "converge measure their orders in the mesh size",
      problems);
}

const Case& find_case(const std::string& id) {
  if (knows_case(id)) return known_case(id);
  if (std::ranges::count(study::model_problems(), id, &study::ModelProblem::id) > 0)
    refuse_in_space(id);
  std::vector<std::string> names = known_ids();
  for (const auto& scene : cases::all_scenes()) names.emplace_back(scene.name);
  throw UsageError("unknown case '{}'{}", id, did_you_mean(id, names));
}

const Entrant& find_entrant(const Entrants& entrants, const std::string& on,
                            const std::string& id) {
  const std::string full = id.find('/') == std::string::npos ? "odeum/" + id : id;
  if (const Entrant* const entrant = entrants.find(full)) {
    if (entrant->unfit.empty()) return *entrant;
    throw UsageError("{} does not fit {}: {}", full, on, entrant->unfit);
  }
  if (const std::string missing = missing_library(full); !missing.empty())
    throw UsageError(missing);
  if (full == "odeum/closed_form")
    throw UsageError(
        "odeum/closed_form runs scenes; the exact solution of a case is drawn beside its solvers");
  throw UsageError("unknown solver '{}'{}", id, did_you_mean(full, solver_ids()));
}

unsigned StudyOptions::jobs_or_cores() const {
  if (jobs) return jobs;
  const unsigned here = std::max(1U, std::thread::hardware_concurrency());
  // The cores that a task of Slurm was given, where it is not bound to them.
  if (const char* const given = std::getenv("SLURM_CPUS_PER_TASK"))
    if (const int cores = std::atoi(given); cores > 0)
      return std::min(here, static_cast<unsigned>(cores));
  return here;
}

void add_study_options(CLI::App& command, StudyOptions& options) {
  add_option(command, "--solver GLOB", options.solvers,
             "solvers, as library/method with * and ? (a method alone: Odeum's own); !GLOB "
             "excludes")
      ->transform(with_library);
  add_option(command, "--out DIR", options.out, "folder for the files")->capture_default_str();
  add_option(command, "--jobs N", options.jobs, "solves at a time; default: the number of cores")
      ->check(CLI::Range(1, 1024));
  CLI::Option* resume = command.add_flag(
      "--resume", options.resume,
      "continue an interrupted run, as the same command does without it: results are kept");
  command
      .add_flag("--no-cache", options.no_cache,
                "measure all, and neither use nor keep the results of earlier runs")
      ->excludes(resume);
}

void add_format(CLI::App& command, std::string& format) {
  add_option(command, "--format FORMAT", format,
             "what is printed: table (for people), csv (rows), or json (all of it)")
      ->transform([](const std::string& word) { return word == "text" ? "table" : word; })
      ->check(CLI::IsMember({"table", "csv", "json"}));
}

}  // namespace odeum::cli
