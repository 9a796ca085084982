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
  std::vector<double> least(q.sizes.size(), infinity);
  for (const Moment& at : q.trusted->moments)
    for (std::size_t i = 0; i < least.size(); ++i) {
      if (at.y[i] != 0) least[i] = std::min(least[i], std::abs(at.y[i]));
      // One that passes zero has no smallest size.
      if (at.y[i] * q.trusted->moments.back().y[i] < 0) least[i] = -infinity;
    }
  const Tolerance& tolerance = q.run.request.tolerance;
  const auto below = [&](std::size_t i) {
    return q.sizes[i] > 0 && least[i] > 0 && least[i] < 0.1 * tolerance.absolute(i) &&
           std::abs(q.trusted->moments.back().y[i]) > 10 * least[i];
  };
  std::optional<std::size_t> found;
  for (std::size_t i = 0; i < least.size(); ++i)
    if (below(i) &&
        (!found || least[i] / tolerance.absolute(i) < least[*found] / tolerance.absolute(*found)))
      found = i;
  if (!found) return;
  const std::size_t who = *found;
  const std::size_t other = with_absolutes(q, least);
  constexpr double helps = 0.2;
  if (!(q.difference(q.others[other]) < helps * q.difference(q.run))) return;
  q.add(Cause::absolute, nan, nan,
        fmt::format("{} grows from {:.2g}, below its absolute tolerance of {:.2g}, so that its "
                    "error there is not held and grows with it: with one below it the run ends "
                    "{:.2g} away, in place of {:.2g}",
                    q.names[who], least[who], tolerance.absolute(who),
                    q.difference(q.others[other]), q.difference(q.run)));
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
