// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <cstdio>
#include "odeum/harness/case.hpp"
using namespace odeum;
int main() {
  for (const Case& c : all_cases()) {
    std::printf("%s\n", c.id.c_str());
    for (const Entrant& e : c.entrants) {
      std::printf("  %-34s ", e.info.id().c_str());
      if (!e.unfit.empty()) {
        std::printf("%s\n", e.unfit.c_str());
        continue;
      }
      std::vector<double> y(c.y0.size());
      double last = 0;
      for (std::uint64_t n = c.coarsest_steps * 8; n <= c.coarsest_steps * 32; n *= 2) {
        Request r;
        r.steps = n;
        r.stops = c.stops;
        Outcome o = e.solve(r);
        if (o.status != Status::ok) {
          std::printf(" [%s %s]", to_string(o.status), o.detail.c_str());
          continue;
        }
        double err = 0;
        c.truth.at(c.stops.back(), y.data());
        const double* s = o.states.data() + (c.stops.size() - 1) * y.size();
        for (std::size_t i = 0; i < (c.measured.empty() ? y.size() : c.measured.size()); ++i)
          err = std::fmax(err, std::fabs(s[i] - y[i]));
        std::printf(" %9.2e (%5.2f)", err, std::log2(last / err));
        last = err;
      }
      if (e.info.adaptive) {
        Request r;
        r.mode = Mode::adaptive;
        r.tolerance = 1e-6;
        r.stops = c.stops;
        Outcome o = e.solve(r);
        const double* s = o.states.data() + (c.stops.size() - 1) * y.size();
        double err = 0;
        if (o.status == Status::ok)
          for (std::size_t i = 0; i < (c.measured.empty() ? y.size() : c.measured.size()); ++i)
            err = std::fmax(err, std::fabs(s[i] - y[i]));
        std::printf(" | tol 1e-6: %s %9.2e %lu+%lu", to_string(o.status), err, o.counters.steps,
                    o.counters.rejected_steps);
      }
      std::printf("\n");
    }
  }
}
