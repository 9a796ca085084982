// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/elements/rows.hpp"
#include "odeum/studies/elements/section.hpp"

namespace odeum::study {
namespace {

class Elements final : public StudyOf<ElementsResult> {
 public:
  Elements()
      : StudyOf({.name = "elements",
                 .help = "linear finite elements: error against mesh size, and linear solvers",
                 .place = 78,
                 .cases_help = "",
                 .options = {{.name = "most",
                              .help = "divisions of a unit length in the finest mesh, of which the "
                                      "largest power of two is taken; default: 128",
                              .least = 16,
                              .most = 1024,
                              .whole = true}}}) {}

  std::vector<Options> report_runs(bool quick) const override {
    return quick ? std::vector<Options>() : std::vector<Options>(1);
  }

  std::string table() const override {
    std::string text;
    for (const ElementsTable& each : elements_tables(result()))
      if (!each.table.rows.empty()) text += each.title + "\n\n" + each.table.text() + "\n";
    return text;
  }

  void section(report::Page& page) const override {
    add_elements_section(page, result(), origin());
  }

 protected:
  ElementsResult run(const Options& options, const Runner& runner) const override {
    return measure_elements(options, runner);
  }
};

}  // namespace

std::unique_ptr<Study> make_elements() { return std::make_unique<Elements>(); }

}  // namespace odeum::study
