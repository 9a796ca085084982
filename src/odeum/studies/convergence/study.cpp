// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/convergence/section.hpp"

namespace odeum::study {
namespace {

class Convergence final : public StudyOf<ConvergenceResult> {
 public:
  Convergence()
      : StudyOf({.name = "converge",
                 .help = "error against step, and the measured order",
                 .place = 20,
                 .quick_help = "fewer step sizes",
                 .options = {{.name = "mode",
                              .help = "fixed or adaptive; default: both",
                              .words = {"fixed", "adaptive"}}}}) {}
  std::string table() const override {
    return record::table_of(result().orders, {{"case", "{case}"},
                                              {"solver", "{library}/{solver}"},
                                              {"mode", "{mode}"},
                                              {"claimed", "{claimed_order:.3g}"},
                                              {"measured", "{measured_order:.3f}"},
                                              {"verdict", "{verdict}: {reason}"}})
        .text();
  }

  void section(report::Page& page) const override { add_section(page, result(), origin()); }

 protected:
  ConvergenceResult run(const Options& options, const Runner& runner) const override {
    return converge(options, runner);
  }
};

}  // namespace

std::unique_ptr<Study> make_convergence() { return std::make_unique<Convergence>(); }

}  // namespace odeum::study
