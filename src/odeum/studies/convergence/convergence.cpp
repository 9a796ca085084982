// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/convergence.hpp"

#include <fmt/format.h>

#include <map>
#include <mutex>

#include "odeum/judge/amplification.hpp"
#include "odeum/studies/convergence/pair_runs.hpp"
#include "odeum/studies/convergence/settings.hpp"

namespace odeum::study {
namespace {

/// What is measured of the cases of some pairs, each at its first use.
class Measures {
 public:
  explicit Measures(const std::vector<Pair>& pairs) {
    for (const Pair& pair : pairs) of_cases_[pair.c];
  }
  const CaseMeasures& of(const Pair& pair) {
    const Case& c = *pair.c;
    OfCase& measured = of_cases_.at(&c);
    std::call_once(measured.gain, [&] { measured.values.gain = judge::perturbation_gain(c); });
    if (pair.mode == Mode::adaptive)
      std::call_once(measured.amplification, [&] {
        measured.values.amplification = judge::measure_amplification(c, convergence_stops(c));
      });
    return measured.values;
  }

 private:
  struct OfCase {
    std::once_flag gain, amplification;
    CaseMeasures values;
  };
  std::map<const Case*, OfCase> of_cases_;
};

/// The value to so many significant digits.
double rounded(double value, int digits) {
  return record::number_of(fmt::format("{:.{}e}", value, digits - 1));
}

}  // namespace

TimeRow time_row(const ConvergenceRow& run, const judge::StopError& stop) {
  return {.case_id = run.case_id,
          .library = run.library,
          .solver = run.solver,
          .mode = run.mode,
          .step = run.step,
          .time = stop.time,
          .error_max = rounded(stop.error_max, 6),
          .error_rms = rounded(stop.error_rms, 6),
          .energy = rounded(stop.energy, 9),
          .energy_error = rounded(stop.energy_error, 6)};
}

ConvergenceResult converge(const Options& options, const Runner& runner) {
  const std::string only = options.word("mode");
  std::vector<Pair> pairs;
  for (Pair pair : select_pairs(select_cases(options.cases), options.solvers))
    for (const Mode mode : {Mode::fixed, Mode::adaptive}) {
      pair.mode = mode;
      const SolverInfo& info = pair.entrant->info;
      if ((mode == Mode::fixed ? info.fixed : info.adaptive) &&
          (only.empty() || only == to_string(mode)))
        pairs.push_back(pair);
    }
  Measures measures(pairs);
  return runner.run("converge", pairs, key_of, [&](const Pair& pair) {
    const std::string& reason = reason_against(pair);
    return reason.empty() ? converge_pair(pair, measures.of(pair), options.quick)
                          : not_measured(pair, reason);
  });
}

}  // namespace odeum::study
