// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "odeum/advise/inquiry.hpp"

namespace odeum::advise {
namespace {

/// How large the run's own states became over those of the solution.
double blown_up(const Inquiry& q) {
  double most = 0;
  for (const Moment& at : q.run.moments)
    for (std::size_t i = 0; i < at.y.size(); ++i)
      if (q.sizes[i] > 0) {
        const double each = std::abs(at.y[i]) / q.sizes[i];
        if (!(each <= most)) most = each;
      }
  return q.run.ok() ? most : infinity;
}

/// Whether the method itself feeds or damps an undamped motion, by its amplification at the
/// fastest eigenvalue that lies on the imaginary axis.
void look_at_energy(Inquiry& q, double step, double steps) {
  double most = 0, frequency = 0;
  std::optional<std::size_t> component;
  for (const Sample& s : q.samples)
    for (const std::complex<double>& z : s.spectrum.all) {
      if (std::abs(z.real()) > 1e-6 * std::abs(z) || !(z.imag() > 0)) continue;
      // One of the solution, which its own rate shows, not a stiff one that rests.
      if (z.imag() > 3 * s.rate) continue;
      // Beyond an edge it is instability.
      if (const double used = step * std::abs(z) / q.region.edge(z); used > 1 && used < infinity)
        continue;
      const double growth = q.region.growth(step * z);
      if (std::abs(growth) > std::abs(most)) {
        most = growth;
        frequency = z.imag();
        component = s.spectrum.component;
      }
    }
  if (!(std::abs(most) * steps > 0.05)) return;
  // An energy that is known has to say so, too.
  if (q.c.energy) {
    const double before = q.c.energy(q.c.y0.data()),
                 after = q.c.energy(q.run.moments.back().y.data());
    if (std::abs(after - before) < 0.02 * std::abs(before)) return;
  }
  q.add(Cause::energy, 1, q.c.t0,
        fmt::format("each step multiplies an undamped motion of angular frequency {:.3g} by "
                    "{:.6g}, {:.3g} in the whole run",
                    frequency, std::exp(most), std::exp(std::clamp(most * steps, -700.0, 700.0))));
}

}  // namespace

void look_at_edge(Inquiry& q) {
  // Where a step first leaves the region, and for how much of the time.
  const Sample* first = nullptr;
  const Sample* worst = nullptr;
  double outside = 0, all = 0;
  for (const Sample& s : q.samples) {
    all += s.weight;
    // Without any step that is stable, what each step makes of the energy says more.
    if (!(s.used > 1) || (s.used == infinity && q.found(Cause::energy))) continue;
    outside += s.weight;
    if (!first) first = &s;
    if (!worst || s.used > worst->used) worst = &s;
  }
  if (!first) return;
  const double decays = std::abs(worst->binding.real());
  const std::string who =
      worst->spectrum.component ? q.names[*worst->spectrum.component] : "the state";
  const double step = worst->at.h, limit = worst->used < infinity ? step / worst->used : 0;
  q.add(Cause::stability, outside / all, first->at.t,
        fmt::format("{} {} at {:.3g} per unit of time, a step of {:.3g} is {:.3g} times what is "
                    "stable{}",
                    who, decays > 0.5 * std::abs(worst->binding) ? "decays" : "oscillates",
                    std::abs(worst->binding), step, worst->used,
                    limit > 0 ? fmt::format(" ({:.3g})", limit) : ""));
}

void look_at_fixed_step(Inquiry& q) {
  const double step = q.run.ends.size() > 1 ? q.run.ends[1] - q.run.ends[0]
                                            : (q.run.request.stops.back() - q.c.t0) /
                                                  static_cast<double>(q.run.request.steps);
  if (!q.trusted) return;
  const double off = q.difference(q.run), size = blown_up(q);
  const auto steps = static_cast<double>(q.run.request.steps);
  constexpr double shows = 0.02;
  if (!(off > shows)) return;
  look_at_energy(q, step, steps);
  if (!(size < 3)) look_at_edge(q);
  if (q.run.outcome.status == Status::newton_failed)
    q.add(Cause::newton, nan, q.run.ends.back(),
          fmt::format("the equations of a step of {:.3g} are not solved at t = {:.6g}", step,
                      q.run.ends.back()));
  if (!q.why.findings.empty()) return;
  // Not unstable: does the error fall with the step as that of a coarse one does?
  Request finer = q.run.request;
  finer.steps *= 4;
  const std::size_t k = q.also(q.why.solver, finer, 0, 0.3);
  const Run& fine = q.others[k];
  if (!fine.ok()) return;
  double rate = 0;
  for (const Sample& s : q.samples) rate = std::max(rate, s.rate);
  const double ratio = off / q.difference(fine);
  if (!(ratio > 2)) return;
  q.add(
      Cause::too_coarse, 1, q.c.t0,
      fmt::format("the solution changes at up to {:.3g} per unit of time, {:.3g} of its size in a "
                  "step; a quarter of the step has {:.2g} of the error",
                  rate, rate * step, 1 / ratio));
}

}  // namespace odeum::advise
