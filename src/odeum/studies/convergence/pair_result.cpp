// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/pair_result.hpp"

#include "odeum/record/fields.hpp"

namespace odeum::study {
namespace {

template <class Record, class Row>
void fields(Record& record, Row& row) requires requires {
  row.counters;
}
{
  record.field(row.status);
  record.field(row.detail);
  record.field(row.step);
  record.field(row.tolerance);
  record.field(row.steps);
  record.field(row.error_max);
  record.field(row.error_rms);
  record.field(row.energy_error);
  record.field(row.counters.steps);
  record.field(row.counters.rejected_steps);
  record.field(row.counters.rhs_evaluations);
  record.field(row.counters.jacobian_evaluations);
}
template <class Record, class Row>
void fields(Record& record, Row& row) requires requires {
  row.energy;
}
{
  record.field(row.step);
  record.field(row.time);
  record.field(row.error_max);
  record.field(row.error_rms);
  record.field(row.energy);
  record.field(row.energy_error);
}
template <class Record, class Fit>
void fit_fields(Record& record, Fit& fit) {
  record.field(fit.reason);
  record.field(fit.order);
  record.field(fit.low);
  record.field(fit.high);
  record.field(fit.points);
  record.field(fit.step_coarsest);
  record.field(fit.step_finest);
  record.field(fit.floor);
}

}  // namespace

std::string write_record(const PairResult& result) {
  record::RecordWriter record;
  record.field(static_cast<int>(result.order.fit.verdict));
  fit_fields(record, result.order.fit);
  record.field(result.rows.size());
  for (const ConvergenceRow& row : result.rows) fields(record, row);
  record.field(result.times.size());
  for (const TimeRow& row : result.times) fields(record, row);
  return record.text();
}

PairResult read_record(const std::string& text) {
  record::RecordReader record(text);
  PairResult result;
  int verdict = 0;
  record.field(verdict);
  result.order.fit.verdict = static_cast<judge::Verdict>(verdict);
  fit_fields(record, result.order.fit);
  std::size_t count = 0;
  record.field(count);
  for (; count > 0; --count) fields(record, result.rows.emplace_back());
  record.field(count);
  for (; count > 0; --count) fields(record, result.times.emplace_back());
  return result;
}

}  // namespace odeum::study
