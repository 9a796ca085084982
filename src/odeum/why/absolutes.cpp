// SPDX-License-Identifier: BSD-3-Clause
// Absolute tolerances above the size that a component has, or has where it begins to grow.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/why/inquiry.hpp"

namespace odeum::why {
namespace {

/// The run with other absolute tolerances, of components with a size `level`; its row.
std::size_t with_absolutes(Inquiry& q, const std::vector<double>& level) {
  const Tolerance& tolerance = q.run.request.tolerance;
  Request request = q.run.request;
  request.record_steps = false;
  std::vector<double> absolute(level.size());
  for (std::size_t i = 0; i < absolute.size(); ++i)
    absolute[i] = of_two_digits(
        std::min(tolerance.absolute(i), level[i] > 0 ? tolerance.relative * level[i] : infinity));
  request.tolerance = Tolerance(tolerance.relative, absolute);
  return q.also(q.why.solver, request, 0.3);
}

}  // namespace

void look_for_growth_from_below(Inquiry& q) {
  if (!q.run.ok() || !q.trusted || !(q.difference(q.run) > 10 * wanted(q))) return;
  const Tolerance& tolerance = q.run.request.tolerance;
  const std::vector<Moment>& moments = q.trusted->moments;
  // Nearly every component that starts from zero is below for an instant.
  constexpr double part = 0.05, far = 10, helps = 0.2;
  const double long_enough = part * (moments.back().t - moments.front().t);
  std::vector<double> level(q.sizes.size());
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < level.size(); ++i) {
    double least = infinity, below = 0;
    std::size_t above = 0;
    for (std::size_t k = 0; k + 1 < moments.size(); ++k) {
      const double size = std::abs(moments[k].y[i]);
      if (size > far * tolerance.absolute(i)) above = k;
      if (size == 0 || size > tolerance.absolute(i)) continue;
      least = std::min(least, size);
      if (above == 0) below += moments[k + 1].t - moments[k].t;
    }
    if (!(below > long_enough) || above == 0 || !(far * least < tolerance.absolute(i))) continue;
    level[i] = least;
    if (!found || least / tolerance.absolute(i) < level[*found] / tolerance.absolute(*found))
      found = i;
  }
  if (!found) return;
  const double ours = q.difference(q.run),
               theirs = q.difference(q.others[with_absolutes(q, level)]);
  if (!(theirs < helps * ours)) return;
  q.add(Cause::absolute, nan, nan,
        fmt::format("{} grows from {:.2g}, below its absolute tolerance of {:.2g}, so that its "
                    "error there is not held and grows with it: with one below it the run ends "
                    "{:.2g} away, in place of {:.2g}",
                    q.names[*found], level[*found], tolerance.absolute(*found), theirs, ours));
}

void look_at_absolutes(Inquiry& q) {
  if (!q.known) return;
  const Tolerance& tolerance = q.run.request.tolerance;
  const std::vector<double>& exact = q.known->end;
  // The worst component stays below its absolute tolerance, and its error shows.
  std::size_t worst = q.sizes.size();
  double most = q.run.ok() ? std::max(1e-5, 10 * tolerance.relative) : 1;
  for (std::size_t i = 0; i < q.sizes.size(); ++i) {
    if (!(q.sizes[i] > 0) || !(q.sizes[i] < tolerance.absolute(i))) continue;
    const double shows = q.run.ok() ? std::abs(q.run.end()[i] - exact[i]) / q.sizes[i]
                                    : tolerance.absolute(i) / q.sizes[i];
    if (shows > most) most = shows, worst = i;
  }
  if (worst == q.sizes.size()) return;
  // The same run is made with the tolerance that the component's size asks for.
  const std::size_t other = with_absolutes(q, q.sizes);
  if (!q.run.ok() && !(q.difference(q.others[other]) <= far_off)) return;
  q.add(Cause::absolute, nan, nan,
        fmt::format("{} is never larger than {:.2g}, below its absolute tolerance of {:.2g}, so "
                    "that its error is not held{}",
                    q.names[worst], q.sizes[worst], tolerance.absolute(worst),
                    q.run.ok() ? fmt::format(": it is {:.2g} of its size at the end", most)
                               : ", and with one below it the run gets to the end"));
}

}  // namespace odeum::why
