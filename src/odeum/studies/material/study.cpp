// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/record/table.hpp"
#include "odeum/studies/material/material.hpp"
#include "odeum/studies/material/section.hpp"

namespace odeum::study {
namespace {

class Material final : public StudyOf<MaterialResult> {
 public:
  Material()
      : StudyOf({.name = "material",
                 .help = "effective stiffness and damping of engines, cloth errors and costs",
                 .place = 70,
                 .cases_help = ""}) {}

  /// It takes a quarter of a minute: a quick report shows the rows of an earlier one.
  std::vector<Options> report_runs(bool quick) const override {
    return quick ? std::vector<Options>() : std::vector<Options>(1);
  }

  std::string table() const override {
    return record::table_of(result().material, {{"scene", "{scene}"},
                                                {"solver", "{library}/{solver}"},
                                                {"step", "{step:.3g}"},
                                                {"sweeps", "{sweeps:d}"},
                                                {"newton", "{newton:d}"},
                                                {"resting", "{resting:.3g}"},
                                                {"vibrating", "{vibrating:.3g}"},
                                                {"damping", "{damping:.3g}"},
                                                {"added", "{added_damping_ratio:.2g}"},
                                                {"status", "{status}: {detail}"}})
               .text() +
           '\n' +
           record::table_of(result().errors, {{"errors in m", "{library}/{solver}"},
                                              {"step", "{step:.3g}"},
                                              {"sweeps", "{sweeps:d}"},
                                              {"newton", "{newton:d}"},
                                              {"total", "{total:.2g}"},
                                              {"iteration", "{iteration:.2g}"},
                                              {"time step", "{time_step:.2g}"},
                                              {"model", "{model:.2g}"},
                                              {"status", "{status}: {detail}"}})
               .text();
  }

  void section(report::Page& page) const override { add_section(page, result(), origin()); }

 protected:
  MaterialResult run(const Options& options, const Runner& runner) const override {
    return measure_material(options, runner);
  }
};

}  // namespace

std::unique_ptr<Study> make_material() { return std::make_unique<Material>(); }

}  // namespace odeum::study
