// SPDX-License-Identifier: BSD-3-Clause
// What equal steps make of an energy that the equations keep.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "odeum/why/inquiry.hpp"

namespace odeum::why {
namespace {

/// a(q) of q'' = a(q) without friction, of which the work between two states depends on nothing
/// but these.
class Forces {
 public:
  explicit Forces(const Case& c) : c_(c), n_(c.problem.view.degrees_of_freedom) {}
  /// Whether a depends on neither time nor velocities, and has a potential: its derivative is
  /// symmetric at that state.
  bool has_potential(const Moment& at, const std::vector<double>& sizes) const {
    constexpr double by = 1e-6, alike = 1e-4;
    Moment moved = at;
    moved.t += 0.37 * std::max(1.0, std::abs(at.t));
    for (std::size_t i = 0; i < n_; ++i) moved.y[n_ + i] += 0.31 * sizes[n_ + i];
    const std::vector<double> here = acceleration(at), there = acceleration(moved);
    if (here != there) return false;
    std::vector<double> derivative(n_ * n_);
    double most = 0;
    for (std::size_t j = 0; j < n_; ++j) {
      const double step = by * (sizes[j] > 0 ? sizes[j] : 1);
      Moment up = at, down = at;
      up.y[j] += step;
      down.y[j] -= step;
      const std::vector<double> above = acceleration(up), below = acceleration(down);
      for (std::size_t i = 0; i < n_; ++i) {
        derivative[i * n_ + j] = (above[i] - below[i]) / (up.y[j] - down.y[j]);
        most = std::max(most, std::abs(derivative[i * n_ + j]));
      }
    }
    for (std::size_t i = 0; i < n_; ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (std::abs(derivative[i * n_ + j] - derivative[j * n_ + i]) > alike * most) return false;
    return std::isfinite(most);
  }
  double kinetic(const Moment& at) const {
    double sum = 0;
    for (std::size_t i = 0; i < n_; ++i) sum += 0.5 * at.y[n_ + i] * at.y[n_ + i];
    return sum;
  }
  /// Along the straight line, by Gauss's formula of ten points in two parts.
  double work(const Moment& from, const Moment& to) const {
    constexpr std::array nodes{0.1488743389816312, 0.4333953941292472, 0.6794095682990244,
                               0.8650633666889845, 0.9739065285171717};
    constexpr std::array weights{0.2955242247147529, 0.2692667193099963, 0.2190863625159821,
                                 0.1494513491505806, 0.0666713443086881};
    double sum = 0;
    for (const double middle : {0.25, 0.75})
      for (std::size_t k = 0; k < nodes.size(); ++k)
        for (const double side : {-1.0, 1.0}) {
          Moment at = from;
          const double share = middle + 0.25 * side * nodes[k];
          for (std::size_t i = 0; i < n_; ++i) at.y[i] += share * (to.y[i] - from.y[i]);
          const std::vector<double> a = acceleration(at);
          for (std::size_t i = 0; i < n_; ++i)
            sum += 0.25 * weights[k] * a[i] * (to.y[i] - from.y[i]);
        }
    return sum;
  }

 private:
  std::vector<double> acceleration(const Moment& at) const {
    const std::vector<double> f = slope(c_, at.t, at.y);
    return {f.begin() + static_cast<std::ptrdiff_t>(n_), f.end()};
  }
  const Case& c_;
  std::size_t n_;
};

/// Whether the energy of q'' = a(q) rises or falls along the whole run, and a method of no higher
/// order that keeps it ends far nearer with the same steps.
void look_at_kept_energy(Inquiry& q, double off) {
  constexpr std::uint64_t least = 20, most_states = 20'000;
  constexpr std::size_t most_unknowns = 60;
  if (!q.c.problem.view.second_order() || !q.run.ok() || q.c.y0.size() > most_unknowns) return;
  const Forces forces(q.c);
  for (const Moment* at : {&q.run.moments.front(), &q.run.moments.back()})
    if (!forces.has_potential(*at, q.sizes)) return;
  // The line between two states far apart may pass a pole of the potential.
  const Run run =
      q.make(q.c, q.why.solver, q.run.request, std::min(most_states, q.run.request.steps + 1), 0.2);
  const std::vector<Moment>& moments = run.moments;
  if (!run.ok() || moments.size() < least) return;
  // The change of the energy since the start, and the largest kinetic one.
  std::vector<double> change{0};
  double largest = forces.kinetic(moments.front());
  for (std::size_t k = 1; k < moments.size(); ++k) {
    const double now = forces.kinetic(moments[k]);
    change.push_back(change.back() + now - forces.kinetic(moments[k - 1]) -
                     forces.work(moments[k - 1], moments[k]));
    largest = std::max(largest, now);
  }
  const double all = change.back(), half = change[change.size() / 2];
  constexpr double shows = 1e-5, steady = 0.25;  // of the kinetic energy, and of the whole change
  if (!(std::abs(all) > shows * largest) || !(half * all > 0) ||
      !(std::abs(half) > steady * std::abs(all)) ||
      !(std::abs(half) < (1 - steady) * std::abs(all)))
    return;
  Request same = q.run.request;
  same.record_steps = false;
  for (const char* id : {"odeum/blanes_moan4", "odeum/stormer_verlet"}) {
    const Entrant* const keeps = q.c.entrants.find(id);
    if (!keeps || !keeps->unfit.empty() ||
        keeps->info.order > q.c.entrants.find(q.why.solver)->info.order)
      continue;
    const double theirs = q.difference(q.others[q.also(id, same, 0.2)]);
    if (!(theirs < 0.5 * off)) continue;
    q.add(Cause::energy, 1, q.c.t0,
          fmt::format("the steps {} the energy, which the equations keep: it {} by {:.2g} of the "
                      "largest kinetic one in the whole run, and {} ends {:.2g} away with the same "
                      "steps",
                      all > 0 ? "feed" : "damp", all > 0 ? "rises" : "falls",
                      std::abs(all) / largest, id, theirs));
    return;
  }
}

}  // namespace

/// Whether the method itself feeds or damps an undamped motion that its steps resolve, by what it
/// makes of it at the eigenvalues on the imaginary axis along the solution.
void look_at_energy(Inquiry& q, double step, double off) {
  constexpr double resolved = 1.5;  // in radians
  double sum = 0, weight = 0, all = 0, frequency = 0;
  for (const Sample& s : q.samples) {
    double most = 0;
    for (const std::complex<double>& z : s.spectrum.all) {
      if (std::abs(z.real()) > 1e-6 * std::abs(z) || !(z.imag() > 0)) continue;
      // One of the solution, which its own rate shows, not a stiff one that rests.
      if (z.imag() > 3 * s.rate || step * z.imag() > resolved) continue;
      // Beyond an edge it is instability.
      if (const double used = step * std::abs(z) / q.region.edge(z); used > 1 && used < infinity)
        continue;
      const double growth = q.region.growth(step * z);
      if (std::abs(growth) > std::abs(most)) most = growth, frequency = z.imag();
    }
    all += s.weight;
    if (most == 0) continue;
    weight += s.weight;
    sum += s.weight * most;
  }
  // It has to explain a part of how far the run is off; the rest may be its phase.
  const double factor = std::exp(std::clamp(sum, -700.0, 700.0));
  if (!(std::abs(factor - 1) > 0.2 * std::min(off, 1.0)) || weight < 0.5 * all)
    return look_at_kept_energy(q, off);
  // An energy that is known has to say so, too.
  if (q.c.energy) {
    const double before = q.c.energy(q.c.y0.data()),
                 after = q.c.energy(q.run.moments.back().y.data());
    if (std::abs(after - before) < 0.02 * std::abs(before)) return;
  }
  q.add(Cause::energy, 1, q.c.t0,
        fmt::format("each step multiplies an undamped motion of angular frequency {:.3g} by "
                    "{:.6g}, {:.3g} in the whole run",
                    frequency, std::exp(sum / weight), factor));
}

}  // namespace odeum::why
