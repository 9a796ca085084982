// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/foreign_reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "odeum/isolated/isolated_process.hpp"
#include "odeum/problem/difference_jacobian.hpp"
#include "odeum/problem/shared.hpp"
#include "odeum/truth/foreign_happenings.hpp"

namespace odeum::truth {
namespace {

constexpr std::size_t most_unknowns = 1000;
constexpr double most_seconds = 60;

/// Looks into the steps of a right-hand side of which nothing but values is at hand: by samples of
/// it, `spacing` apart, along the step. Where one is not what its neighbours let expect, the step
/// has something inside that its stages may have missed. What is shorter than `spacing` may fall
/// between two samples.
class Samples final : public Insight {
 public:
  Samples(const System& system, Real spacing)
      : rhs_(system.rhs), spacing_(spacing), y_(system.states) {}

  Inside look(Real t, Real h, const State& y, const State& next) override {
    const auto count = static_cast<std::size_t>(std::ceil(h / spacing_)) + 1;
    // The stages of shorter steps are closer than the samples.
    constexpr std::size_t fewest = 16;
    if (count < fewest) return {};
    sample(t, h, y, next, count);
    std::size_t first = count;
    for (std::size_t i = 0; i < y.size(); ++i) first = std::min(first, first_unexpected(i, count));
    if (first == count) return {};
    const auto part = [&](std::size_t k) {
      return static_cast<Real>(k) / static_cast<Real>(count - 1);
    };
    return {Inside::Kind::hidden, part(first - 2), part(first + 2)};
  }

 private:
  /// f along the cubic through both ends of the step.
  void sample(Real t, Real h, const State& y, const State& next, std::size_t count) {
    f_.resize(count, State(y.size()));
    rhs_(t, y.data(), f_.front().data());
    rhs_(t + h, next.data(), f_[count - 1].data());
    for (std::size_t k = 1; k + 1 < count; ++k) {
      const Real s = static_cast<Real>(k) / static_cast<Real>(count - 1);
      const Real risen = s * s * (3 - 2 * s), from = s * (1 - s) * (1 - s), to = s * s * (s - 1);
      for (std::size_t i = 0; i < y.size(); ++i)
        y_[i] = y[i] + risen * (next[i] - y[i]) + h * (from * f_[0][i] + to * f_[count - 1][i]);
      rhs_(t + s * h, y_.data(), f_[k].data());
    }
  }

  /// The first sample of a component that is farther from the cubic through two neighbours on each
  /// side than a hundred times what is usual in the step, and than rounding; `count`: none.
  std::size_t first_unexpected(std::size_t i, std::size_t count) {
    constexpr Real unusual = 100, rounding = 1e-10L;
    Real largest = 0;
    for (std::size_t k = 0; k < count; ++k) largest = std::max(largest, std::abs(f_[k][i]));
    apart_.clear();
    for (std::size_t k = 2; k + 2 < count; ++k)
      apart_.push_back(std::abs(
          f_[k][i] - (4 * (f_[k - 1][i] + f_[k + 1][i]) - f_[k - 2][i] - f_[k + 2][i]) / 6));
    sorted_ = apart_;
    const auto middle = sorted_.begin() + static_cast<std::ptrdiff_t>(sorted_.size() / 2);
    std::nth_element(sorted_.begin(), middle, sorted_.end());
    const Real allowed = std::max(unusual * *middle, rounding * largest);
    for (std::size_t k = 0; k < apart_.size(); ++k)
      if (!(apart_[k] <= allowed)) return k + 2;
    return count;
  }

  std::function<void(Real t, const Real* y, Real* f)> rhs_;
  Real spacing_;
  State y_, apart_, sorted_;
  std::vector<State> f_;
};

}  // namespace

std::optional<Reference> reference_of(const foreign::ProblemCallbacks& given, std::string& why,
                                      const TruthBounds& bounds) {
  const odeum_problem& p = given.functions;
  const std::size_t n = p.dimension;
  if (n > most_unknowns) {
    why = fmt::format("references are computed for up to {} unknowns, it has {}", most_unknowns, n);
    return std::nullopt;
  }
  const std::vector<double> stops(p.stops, p.stops + p.stop_count);
  const foreign::Problem given_problem(p);
  const SharedOde problem(view_of(given_problem), nullptr);
  System system;
  system.states = n;
  system.t0 = p.t0;
  system.y0.assign(p.y0, p.y0 + n);
  system.rhs = widened(n, n, [&](double t, const double* y, double* f) { problem.rhs(t, y, f); });
  if (n <= most_in_matrix)
    system.jacobian = widened(n, n * n, [&](double t, const double* y, double* j) {
      jacobian_or_differences(problem, t, y, j);
    });
  system.insight = [&system](Real span) {
    return std::make_unique<Samples>(system, shortest_seen * span);
  };
  system.rounding = 0x1p-53L;
  // The work of a call of foreign code is assumed; what it really takes is not known.
  system.work = 200 + 20 * static_cast<double>(n);
  add_happenings(given, system);
  const std::size_t room = (stops.size() + 100) * 2 * (n + 2) * 32 + 4096;
  constexpr const char* none = "none: ";
  const auto [ended, text] = isolated::text_isolated(
      [&] {
        if (const double t = first_event_of_step(given, view_of(given_problem)); std::isfinite(t))
          return fmt::format(
              "{}it asks for an event at the end of a step, at t = {:.6g}, so that "
              "its solution depends on the steps",
              none, t);
        return to_text(compute_reference(system, stops, {given.scale}, bounds));
      },
      room, most_seconds);
  std::optional<Reference> reference;
  if (ended && !text.starts_with(none)) reference = from_text(text, n);
  if (!reference)
    why = !ended                   ? text
          : text.starts_with(none) ? text.substr(std::strlen(none))
                                   : "the reference could not be read";
  return reference;
}

}  // namespace odeum::truth
