// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "odeum/core/parallel.hpp"
#include "odeum/core/progress.hpp"
#include "odeum/record/rows.hpp"
#include "odeum/record/store.hpp"
#include "odeum/solvers/settings.hpp"
#include "odeum/studies/stopwatch.hpp"

namespace odeum::study {

/// A solver on a case, in a mode where a study has both.
struct Pair {
  const Case* c = nullptr;
  const Entrant* entrant = nullptr;
  Mode mode = Mode::fixed;
};

/// Every selected case (globs on ids; none: all), every selected solver on it (globs on
/// library/method), in the order of enrolment.
std::vector<const Case*> select_cases(const std::vector<std::string>& globs);
std::vector<Pair> select_pairs(const std::vector<const Case*>& cases,
                               const std::vector<std::string>& solver_globs);

/// Throws std::out_of_range where there is none of that id.
const Entrant& find_solver(const Entrants& entrants, const std::string& id);

/// The names of a pair, by which its results are kept.
std::string key_of(const Pair& pair);

/// A row with the names of its case and solver.
template <class Row>
Row named_row(const SolverInfo& info) {
  Row row;
  row.library = info.library;
  row.solver = info.method;
  return row;
}
template <class Row>
Row named_row(const Case& c, const SolverInfo& info) {
  Row row = named_row<Row>(info);
  row.case_id = c.id;
  return row;
}
/// The row of a pair that cannot be measured.
template <class Row>
Row not_applicable(Row row, const std::string& reason) {
  row.status = "not_applicable";
  row.detail = reason;
  return row;
}

/// Adds a sentence to the detail of a row.
void remark(auto& row, const std::string& sentence) {
  row.detail += (row.detail.empty() ? "" : "; ") + sentence;
}

/// What a plan learns of the tasks of a command.
struct PlannedTasks {
  std::vector<double> seconds = {};      ///< of the processor, by task, in the order of a run
  std::vector<bool> alone = {};          ///< by task: its times are its result
  std::uint64_t earlier = 0, timed = 0;  ///< tasks whose seconds are of earlier runs, of a sample

  /// Adds tasks. `earlier_of` a task: its seconds in an earlier run; NaN: not known. Of others
  /// some, evenly spread, are done and timed for a few seconds, or none without `work`, where tasks
  /// are timed; the rest is taken to be as long as the nearest of these, or one second.
  void add(std::size_t tasks, const std::function<double(std::size_t)>& earlier_of,
           const std::function<void(std::size_t)>& work);
};

/// A result of a shard that is not there, or is not one of the task: the shard is bad input.
class ResultLost : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The tasks of a command that this process does.
struct Share {
  std::uint64_t at = 0;
  /// For each task, the number of the share that has it; null: all are this one's.
  std::shared_ptr<const std::vector<std::uint32_t>> shares = nullptr;
  std::shared_ptr<std::uint64_t> begun = nullptr;  ///< tasks of the runs before, beside `shares`
  bool all_kept = false;  ///< every result is to be in the store: another is an error
  std::shared_ptr<PlannedTasks> plan = nullptr;  ///< only adds its tasks to it

  /// The number of the first task of a run of so many.
  std::uint64_t begin(std::size_t tasks) const {
    return begun ? std::exchange(*begun, *begun + tasks) : 0;
  }
  bool has(std::uint64_t task) const {
    return !shares || (task < shares->size() && (*shares)[task] == at);
  }
};

/// Where a run keeps results and takes those of earlier runs from, and what they depend on. The
/// stores belong to the caller, have to outlive the run and may be used by its threads at once.
struct ResultCache {
  record::Store* store = nullptr;  ///< null: nowhere
  /// What any result of the run depends on: the whole program and all options.
  std::string dependencies = {};
  /// What those of pairs on the project's own cases depend on; empty: `dependencies`, too.
  std::string dependencies_of_built_in = {};
  Share share = {};
  record::Store* seconds = nullptr;  ///< where the seconds of tasks are kept, for plans
  std::string settings = {};         ///< key of `seconds`: all options except globs
};

/// Runs the tasks of a study: several at a time, with progress, and keeps their results, so that
/// they need not be measured again, by a run that continues a killed one or by any later one.
class Runner {
 public:
  explicit Runner(unsigned jobs = 1, ResultCache cache = {})
      : jobs_(jobs), cache_(std::move(cache)) {}

  /// Calls work(task), which returns a Result (record/rows.hpp), for each task and joins the
  /// results in the order of the tasks, so that they do not depend on the number of jobs. A task
  /// with a result in the store is not measured again: key(task) must be unique within a run, and
  /// `what` names the part of the study. Results of tasks other than a Pair are kept for the very
  /// program and options; those of a Pair must depend on nothing but its case, its solver and the
  /// options other than globs. Throws Interrupted.
  template <class Task, class Key, class Work>
  auto run(const std::string& what, const std::vector<Task>& tasks, Key&& key, Work&& work) const {
    return run_by(jobs_, what, tasks, key, work);
  }
  /// The same one after the other, for tasks whose times are the result: a plan times none.
  template <class Task, class Key, class Work>
  auto run_in_turn(const std::string& what, const std::vector<Task>& tasks, Key&& key,
                   Work&& work) const {
    return run_by(0, what, tasks, key, work);
  }

  /// How many threads the tasks may take.
  unsigned jobs() const { return jobs_; }

 private:
  const std::string& dependencies_of(const auto&) const { return cache_.dependencies; }
  const std::string& dependencies_of(const Pair& pair) const;

  template <class Task, class Key, class Work>
  auto run_by(unsigned jobs, const std::string& what, const std::vector<Task>& tasks, Key&& key,
              Work&& work) const {
    using Result = decltype(work(tasks.front()));
    const auto name = [&](std::size_t i) { return what + ' ' + key(tasks[i]); };
    if (cache_.share.plan) {
      cache_.share.plan->add(
          tasks.size(), [&](std::size_t i) { return seconds_of(name(i)); },
          jobs == 0 ? std::function<void(std::size_t)>() : [&](std::size_t i) { work(tasks[i]); });
      return Result();
    }
    const std::uint64_t first = cache_.share.begin(tasks.size());
    std::vector<Result> results(tasks.size());
    Progress progress(what, static_cast<double>(tasks.size()));
    parallel_for(tasks.size(), std::max(jobs, 1U), [&](std::size_t i) {
      if (!cache_.share.has(first + i)) return;
      results[i] = kept_or(
          tasks[i], [&] { return name(i); }, [&] { return work(tasks[i]); });
      progress.advance();
    });
    Result all;
    for (Result& result : results) record::append(all, std::move(result));
    return all;
  }

  /// Seconds of a task in an earlier run; NaN: not known.
  double seconds_of(const std::string& name) const;
  void keep_seconds(const std::string& name, double seconds) const;

  template <class Task, class Key, class Work>
  auto kept_or(const Task& task, Key&& key, Work&& work) const {
    using Result = decltype(work());
    if (!cache_.store) return work();
    const std::string name = key(), dependencies = dependencies_of(task);
    if (const auto kept = cache_.store->take(dependencies, name)) try {
        return record::from_record<Result>(*kept);
      } catch (const record::BadField&) {
        if (cache_.share.all_kept)
          throw ResultLost("the result of " + name + " in the shards is damaged");
      }
    if (cache_.share.all_kept) throw ResultLost("the shards lack the result of " + name);
    const double start = thread_seconds();
    Result result = work();
    // An interrupted task has no result.
    if (interrupted) throw Interrupted();
    cache_.store->add(dependencies, name, record::to_record(result));
    keep_seconds(name, thread_seconds() - start);
    return result;
  }

  unsigned jobs_;
  ResultCache cache_;
};

}  // namespace odeum::study
