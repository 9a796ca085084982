// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "odeum/report/report.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/stability/stability.hpp"
#include "support/page_data.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::test {

/// Made-up results for a report.
struct MadeUp {
  report::Facts facts;
  study::ConvergenceResult convergence;
  study::StabilityResult stability;
};

/// As many cases and solvers as the project has, every verdict and status among them, errors that
/// follow a power of the step down to rounding. The same every time.
MadeUp fabricate_report();

/// The same with two cases and three solvers, for tests that look at single cells.
MadeUp fabricate_small_report();

/// A report in a folder of its own, of whatever results are added.
class Report {
 public:
  explicit Report(report::Facts facts) : report_(std::move(facts), folder_) {}
  explicit Report(const MadeUp& data) : Report(data.facts) {
    add({.name = "convergence", .command = "converge", .help = ""}, data.convergence);
    add({.name = "stability", .command = "stability", .help = ""}, data.stability);
  }

  template <class Result>
  Report& add(const report::StudyFacts& study, const Result& result) {
    report_.study(study);
    record::for_each_list(result, [&](const auto& rows) { report_.rows(study.name, rows); });
    return *this;
  }
  Report& write(const report::RunFacts& run = {}) {
    report_.write(run);
    return *this;
  }
  report::Report& report() { return report_; }
  const record::OutputFolder& folder() const { return folder_; }
  std::string text(const std::string& file) const { return tests::text_of(folder_.path() / file); }
  nlohmann::json json(const std::string& file) const {
    return tests::json_of(folder_.path() / file);
  }
  nlohmann::json table(const std::string& name) const {
    return tests::table_in(folder_.path(), name);
  }
  std::vector<nlohmann::json> column(const std::string& table, const std::string& name) const {
    return tests::column_in(folder_.path(), table, name);
  }

 private:
  tests::TemporaryFolder root_;
  record::OutputFolder folder_{root_.path() / "out"};
  report::Report report_;
};

bool has(std::string_view text, std::string_view part);

}  // namespace odeum::test
