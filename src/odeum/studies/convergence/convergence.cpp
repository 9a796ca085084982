// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/convergence/convergence.hpp"

#include <map>
#include <mutex>

#include "odeum/judge/rounding.hpp"
#include "odeum/studies/convergence/pair_runs.hpp"

namespace odeum::study {
namespace {

/// The perturbation gains of the cases of some pairs, each measured at its first use.
class Gains {
 public:
  explicit Gains(const std::vector<Pair>& pairs) {
    for (const Pair& pair : pairs) gains_[pair.c];
  }
  double of(const Case& c) {
    Gain& gain = gains_.at(&c);
    std::call_once(gain.once, [&] { gain.value = judge::perturbation_gain(c); });
    return gain.value;
  }

 private:
  struct Gain {
    std::once_flag once;
    double value = 0;
  };
  std::map<const Case*, Gain> gains_;
};

}  // namespace

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
  Gains gains(pairs);
  return runner.run("converge", pairs, key_of, [&](const Pair& pair) {
    const std::string& reason = reason_against(pair);
    return reason.empty() ? converge_pair(pair, gains.of(*pair.c), options.quick)
                          : not_measured(pair, reason);
  });
}

}  // namespace odeum::study
