// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/cloth/cloth.hpp"

namespace odeum::study {
namespace {

ClothResult measure_cloth(const Options& options, const Runner& runner) {
  ClothResult result = measure_error_parts(options, runner);
  record::append(result, measure_long_runs(options, runner));
  return result;
}

}  // namespace

// It takes several seconds: a quick report shows the rows of an earlier one.
std::unique_ptr<Study> make_cloth() {
  return make_study<ClothResult>(
      {.name = "cloth",
       .help = "where the error of a cloth comes from, and its energy and momentum over 10 s",
       .place = 71,
       .cases_help = "",
       .figures = {{"side", cloth_side}}},
      {.measure = measure_cloth});
}

}  // namespace odeum::study
