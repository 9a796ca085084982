// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/foreign_reference.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "odeum/isolated/isolated_process.hpp"
#include "odeum/problem/difference_jacobian.hpp"
#include "odeum/problem/shared.hpp"
#include "odeum/truth/samples.hpp"

namespace odeum::truth {
namespace {

constexpr std::size_t most_unknowns = 1000;
constexpr double most_seconds = 60;

/// A problem's functions on numbers of extended precision.
class Widened {
 public:
  explicit Widened(const OdeView& view)
      : problem_(view, nullptr),
        y_(problem_.size()),
        f_(y_.size()),
        j_(y_.size() <= dense ? y_.size() * y_.size() : 0) {}

  static constexpr std::size_t dense = 64;  ///< full matrices take too long beyond this

  void rhs(Real t, const Real* y, Real* f) {
    std::copy_n(y, y_.size(), y_.begin());
    problem_.rhs(static_cast<double>(t), y_.data(), f_.data());
    std::ranges::copy(f_, f);
  }
  /// The problem's own, or by differences: Newton's method converges with either, and the
  /// extrapolated Euler method has its order with any matrix.
  void jacobian(Real t, const Real* y, Real* j) {
    std::copy_n(y, y_.size(), y_.begin());
    jacobian_or_differences(problem_, static_cast<double>(t), y_.data(), j_.data());
    std::ranges::copy(j_, j);
  }

 private:
  SharedOde problem_;
  std::vector<double> y_, f_, j_;
};

}  // namespace

std::optional<Reference> reference_of(const foreign::ProblemCallbacks& given, std::string& why) {
  const odeum_problem& p = given.functions;
  const std::size_t n = p.dimension;
  if (n > most_unknowns) {
    why = fmt::format("references are computed for up to {} unknowns, it has {}", most_unknowns, n);
    return std::nullopt;
  }
  const std::vector<double> stops(p.stops, p.stops + p.stop_count);
  const foreign::Problem problem(p);
  const auto widened = std::make_shared<Widened>(view_of(problem));
  System system;
  system.states = n;
  system.t0 = p.t0;
  system.y0.assign(p.y0, p.y0 + n);
  system.rhs = [widened](Real t, const Real* y, Real* f) { widened->rhs(t, y, f); };
  if (n <= Widened::dense)
    system.jacobian = [widened](Real t, const Real* y, Real* j) { widened->jacobian(t, y, j); };
  system.insight = [&system](Real span) { return sampled_insight(system, shortest_seen * span); };
  system.rounding = 0x1p-53L;
  // Of a call of foreign code; what it really takes is not known.
  system.work = 200 + 20 * static_cast<double>(n);
  const std::size_t room = (stops.size() + 100) * (n + 3) * 32 + 4096;
  const auto [ended, text] = isolated::text_isolated(
      [&] { return to_text(compute_reference(system, stops, given.scale)); }, room, most_seconds);
  std::optional<Reference> reference;
  if (ended) reference = from_text(text, n);
  if (!reference) why = ended ? "the reference could not be read" : text;
  return reference;
}

}  // namespace odeum::truth
