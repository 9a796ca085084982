// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "goals.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/studies/precision/precision.hpp"

namespace odeum::bench {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A goal from an error on, down to the next one of the same case, or of a problem's file.
struct Level {
  const char* case_id;
  int from_exponent;  ///< error 1e-from
  double goal;
};
constexpr Level levels[] = {{"osc_undamped", 3, 2},
                            {"kepler_e06", 3, 1.2},
                            {"kepler_e06", 9, 1.1},
                            {"kepler_e09", 3, 1.1},
                            {"pleiades", 3, 2},
                            {"lorenz_kehlet_logg", 3, 1.1},
                            {"dahlquist_complex", 3, 1.1},
                            {"pendulum_large", 3, 1.1},
                            {"vdp_eps1e_6", 3, 3.2},
                            {"vdp_eps1e_6", 9, 8},
                            {"vdp_mu1000", 3, 3.2},
                            {"vdp_mu1000", 9, 8},
                            {"robertson_40", 3, 3.5},
                            {"robertson_40", 9, 8},
                            {"robertson", 3, 3.5},
                            {"robertson", 9, 8},
                            {"hires", 3, 4},
                            {"hires", 9, 8},
                            {"e5", 3, 3},
                            {"pollution", 3, 3},
                            {"reaction_diffusion", 3, 3},
                            {"brusselator_1d", 3, 2},
                            {"medakzo", 3, 2},
                            {"heat_2d", 3, 5},
                            {"heat_2d", 6, 2}};

/// Loads the problem file of that name where no case of the project has it.
void know(const std::string& id) {
  const std::vector<std::string> known = known_ids();
  if (std::count(known.begin(), known.end(), id)) return;
  const std::string file = "cases/problems/" + id + ".yaml";
  std::ifstream stream(file);
  const std::string text(std::istreambuf_iterator<char>(stream), {});
  add_user_case(cases::text_statements(file, text, id).front());
}

double goal_at(const std::string& case_id, int exponent) {
  double goal = nan;
  for (const Level& level : levels)
    if (level.case_id == case_id && exponent >= level.from_exponent) goal = level.goal;
  return goal;
}

/// The study takes wall time. Shorter runs than a slice of the scheduler are not lengthened by
/// other programs, as the least of some; of longer ones nothing is known.
bool is_disturbed(const study::PrecisionResult& result, double longer_ns) {
  constexpr double slice_ns = 1e6;
  double share = 1;
  for (const study::PrecisionRow& row : result.rows)
    if (row.processor_share < share) share = row.processor_share;
  return share < 0.95 && longer_ns > slice_ns;
}

/// The fastest of CVODE over the fastest own, the figure that others publish; none where one of
/// them does not have the error.
void add_against_cvode(std::vector<Row>& rows, const study::PrecisionResult& result,
                       const study::PrecisionSummary& line, int exponent) {
  const auto fastest_of = [&](const char* library) {
    return std::find_if(result.fastest.begin(), result.fastest.end(),
                        [&](const study::FastestRow& row) {
                          return row.library == library && row.compared == line.error;
                        });
  };
  const auto cvode = fastest_of("cvode"), own = fastest_of("odeum");
  if (cvode == result.fastest.end() || own == result.fastest.end()) return;
  rows.push_back({.what = fmt::format("{} at 1e-{}: CVODE / own", line.case_id, exponent),
                  .goal = exponent <= 6 ? 4 : nan,
                  .measured = cvode->wall_ns_min / own->wall_ns_min,
                  .low = cvode->wall_ns_min / own->wall_ns_median,
                  .high = cvode->wall_ns_median / own->wall_ns_min,
                  .note = fmt::format("odeum/{} / cvode/{}", own->solver, cvode->solver)});
  rows.back().disturbed = is_disturbed(result, std::max(cvode->wall_ns_min, own->wall_ns_min));
}

}  // namespace

std::vector<Row> precision_rows() {
  std::vector<Row> rows;
  std::vector<std::string> done;
  for (const Level& level : levels) {
    if (std::count(done.begin(), done.end(), level.case_id)) continue;
    done.emplace_back(level.case_id);
    know(level.case_id);
    const study::PrecisionResult result =
        study::measure_precision({.cases = {level.case_id}}, study::Runner(2));
    for (const study::PrecisionSummary& line : result.summary) {
      const int exponent = static_cast<int>(std::lround(-std::log10(line.error)));
      if (exponent != 3 && exponent != 6 && exponent != 9 && exponent != 11) continue;
      Row row{.what = fmt::format("{} at 1e-{}", line.case_id, exponent),
              .goal = goal_at(line.case_id, exponent),
              .measured = line.ratio,
              .low = line.ratio_low,
              .high = line.ratio_high,
              .note = line.reason.empty() ? line.own + " / " + line.peer : line.reason};
      row.disturbed = is_disturbed(result, std::max(line.own_ns, line.peer_ns));
      if (!std::isnan(row.measured))
        row.note += fmt::format(", {} us", three_digits(line.own_ns / 1e3));
      if (!line.own.empty() && line.peer.empty()) row.note += ": " + line.own + " does";
      rows.push_back(std::move(row));
      // Small stiff systems: what codes of chemistry publish.
      for (const char* const stiff : {"hires", "robertson", "vdp", "e5", "pollution"})
        if (line.case_id.starts_with(stiff)) add_against_cvode(rows, result, line, exponent);
    }
  }
  return rows;
}

}  // namespace odeum::bench
