// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <set>
#include <string>
#include <string_view>

#include "odeum/report/page.hpp"
#include "odeum/studies/convergence/section.hpp"
#include "odeum/studies/stability/stability.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::test {

/// Made-up results for the page.
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
  explicit Report(report::Facts facts) : page_(std::move(facts), folder_) {}
  explicit Report(const MadeUp& data) : Report(data.facts) {
    add(data.convergence);
    add(data.stability);
  }

  template <class Result>
  Report& add(const Result& result, const study::Origin& origin = {}) {
    add_section(page_, result, origin);
    return *this;
  }
  /// Writes all and returns index.html and the pages of the sections, one after the other.
  std::string index(const report::RunFacts& run = {}) {
    page_.write(run);
    std::set<std::filesystem::path> pages;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      if (entry.path().extension() == ".html") pages.insert(entry.path());
    std::string text;
    for (const auto& page : pages) text += tests::text_of(page);
    return text;
  }
  /// The page of a case.
  std::string case_page(std::size_t index) {
    page_.write({});
    return tests::text_of(folder_.path() / page_.facts().cases.at(index).file);
  }
  const record::OutputFolder& folder() const { return folder_; }

 private:
  tests::TemporaryFolder root_;
  record::OutputFolder folder_{root_.path() / "out"};
  report::Page page_;
};

bool has(std::string_view text, std::string_view part);
std::size_t count(std::string_view text, std::string_view part);

}  // namespace odeum::test
