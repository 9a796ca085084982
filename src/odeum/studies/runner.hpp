// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "odeum/contest/case.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/core/progress.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/record/rows.hpp"

namespace odeum::study {

/// A solver on a case, in a mode where a study has both.
struct Pair {
  const Case* c;
  const Entrant* entrant;
  Mode mode = Mode::fixed;
};

/// Every selected case (globs on ids; none: all), every selected solver on it (globs on
/// library/method), in the order of enrolment.
std::vector<const Case*> select_cases(const std::vector<std::string>& globs);
std::vector<Pair> select_pairs(const std::vector<const Case*>& cases,
                               const std::vector<std::string>& solver_globs);

/// Throw std::out_of_range where there is none of that id.
const Case& find_case(const std::string& id);
const Entrant& find_solver(const std::vector<Entrant>& entrants, const std::string& id);

/// The names of a pair, for the journal.
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

/// Runs the tasks of a study: several at a time, with progress, and with a journal from which a
/// killed run continues.
class Runner {
 public:
  explicit Runner(unsigned jobs = 1, record::Journal* journal = nullptr)
      : jobs_(jobs), journal_(journal) {}

  /// Calls work(task), which returns a Result (record/rows.hpp), for each task and joins the
  /// results in the order of the tasks, so that they do not depend on the number of jobs. A task
  /// found in the journal is not measured again: key(task) must be unique within a run, and `what`
  /// names the part of the study. Throws Interrupted.
  template <class Task, class Key, class Work>
  auto run(const std::string& what, const std::vector<Task>& tasks, Key&& key, Work&& work) const {
    using Result = decltype(work(tasks.front()));
    std::vector<Result> results(tasks.size());
    Progress progress(what, static_cast<double>(tasks.size()));
    parallel_for(tasks.size(), jobs_, [&](std::size_t i) {
      results[i] =
          held_or([&] { return what + ' ' + key(tasks[i]); }, [&] { return work(tasks[i]); });
      progress.advance();
    });
    Result all;
    for (Result& result : results) record::append(all, std::move(result));
    return all;
  }

  /// For timed tasks, which are neither journaled nor run in parallel.
  unsigned jobs() const { return jobs_; }

 private:
  template <class Key, class Work>
  auto held_or(Key&& key, Work&& work) const {
    using Result = decltype(work());
    if (!journal_) return work();
    const std::string name = key();
    if (const auto held = journal_->find(name)) return record::from_record<Result>(*held);
    Result result = work();
    // An interrupted task has no result.
    if (interrupted) throw Interrupted();
    journal_->add(name, record::to_record(result));
    return result;
  }

  unsigned jobs_;
  record::Journal* journal_;
};

}  // namespace odeum::study
