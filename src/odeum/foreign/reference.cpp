// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/foreign/reference.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/foreign/apart.hpp"

namespace odeum::foreign {
namespace {

using truth::Real;

constexpr std::size_t most_unknowns = 1000;
constexpr double most_seconds = 60;

/// The view's functions on numbers of extended precision.
class Widened {
 public:
  explicit Widened(const OdeView& view)
      : view_(view),
        n_(view.dimension),
        y_(n_),
        f_(n_),
        moved_(n_),
        j_(n_ <= dense ? n_ * n_ : 0) {}

  static constexpr std::size_t dense = 64;  ///< full matrices take too long beyond this

  void rhs(Real t, const Real* y, Real* f) {
    std::copy_n(y, n_, y_.begin());
    view_.rhs(view_.problem, static_cast<double>(t), y_.data(), f_.data());
    std::copy(f_.begin(), f_.end(), f);
  }
  /// The problem's own, or by differences: Newton's method converges with either, and the
  /// extrapolated Euler method has its order with any matrix.
  void jacobian(Real at, const Real* state, Real* j) {
    std::copy_n(state, n_, y_.begin());
    const auto t = static_cast<double>(at);
    if (view_.jacobian)
      view_.jacobian(view_.problem, t, y_.data(), j_.data());
    else
      by_differences(t);
    std::copy(j_.begin(), j_.end(), j);
  }

 private:
  void by_differences(double t) {
    view_.rhs(view_.problem, t, y_.data(), f_.data());
    for (std::size_t k = 0; k < n_; ++k) {
      const double before = y_[k];
      y_[k] += 0x1p-26 * std::max(std::abs(before), 1e-5);
      view_.rhs(view_.problem, t, y_.data(), moved_.data());
      for (std::size_t i = 0; i < n_; ++i) j_[i * n_ + k] = (moved_[i] - f_[i]) / (y_[k] - before);
      y_[k] = before;
    }
  }

  OdeView view_;
  std::size_t n_;
  std::vector<double> y_, f_, moved_, j_;
};

}  // namespace

std::optional<truth::Reference> reference_of(const Given& given, std::string& why) {
  const odeum_problem& p = given.functions;
  const std::size_t n = p.dimension;
  if (n > most_unknowns) {
    why = fmt::format("references are computed for up to {} unknowns, it has {}", most_unknowns, n);
    return std::nullopt;
  }
  const std::vector<double> stops(p.stops, p.stops + p.stop_count);
  const Problem problem(p);
  const auto widened = std::make_shared<Widened>(problem.view());
  truth::System system;
  system.states = n;
  system.t0 = p.t0;
  system.y0.assign(p.y0, p.y0 + n);
  system.rhs = [widened](Real t, const Real* y, Real* f) { widened->rhs(t, y, f); };
  if (n <= Widened::dense)
    system.jacobian = [widened](Real t, const Real* y, Real* j) { widened->jacobian(t, y, j); };
  system.rounding = 0x1p-53L;
  // Of a call of foreign code; what it really takes is not known.
  system.work = 200 + 20 * static_cast<double>(n);
  const std::size_t room = (stops.size() + 100) * (n + 3) * 32 + 4096;
  const auto [ended, text] = text_apart(
      [&] { return truth::to_text(truth::compute_reference(system, stops, given.scale)); }, room,
      most_seconds);
  std::optional<truth::Reference> reference;
  if (ended) reference = truth::from_text(text, n);
  if (!reference) why = ended ? "the reference could not be read" : text;
  return reference;
}

}  // namespace odeum::foreign
