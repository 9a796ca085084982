// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/order_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "odeum/judge/fit_parts.hpp"

namespace odeum::judge {
namespace {

using Points = std::vector<ErrorPoint>;

// A window's finest step against the finest of all; where slopes before it are; how long it is.
constexpr double finest_end = 1.65, slopes_before = 4, short_span = 2, long_span = 8;
constexpr double still_converging = 2;   // above a claim of at least: no error of an order yet
constexpr double most_rejected = 0.35;   // of the tries at each of the finest two tolerances
constexpr double two_terms_below = 0.1;  // how far below the claim p may lie, to confirm it

/// One fit of points clear of rounding, from the finest to the verdict.
class Fitting {
 public:
  Fitting(Points points, double claimed_order, const FitTolerance& tolerance)
      : points_(std::move(points)),
        claimed_(claimed_order),
        guess_(std::isnan(claimed_order) ? 1 : claimed_order),
        tolerance_(tolerance) {
    const std::size_t solved = points_.size();
    while (!points_.empty() && points_.back().error <= points_.back().clear_error())
      points_.pop_back();
    reached_rounding_ = points_.size() < solved;
    certain_end_ = points_.size();
    while (certain_end_ > 0 && !certain(certain_end_ - 1)) --certain_end_;
  }

  OrderFit conclude() {
    const Window window = choose_window();
    const ErrorFloor floor = find_floor(points_, certain_end_, guess_, tolerance_.stray);
    if (std::isnan(claimed_))
      return verdict(Verdict::not_applicable, "the order varies during a run, so none is claimed");
    if (!falls_away(points_, certain_end_, claimed_, tolerance_)) {
      if (window.count && confirms(window)) return held(confirmed());
      if (!settled_lower(window) && confirmed_by_two_terms()) return held(fit_);
    }
    if (floor.first < certain_end_) return floors(floor);
    return settled_elsewhere(window);
  }

 private:
  bool certain(std::size_t i) const { return points_[i].error > points_[i].certain_error(); }
  OrderFit verdict(Verdict verdict, std::string reason) {
    fit_.verdict = verdict;
    fit_.reason = std::move(reason);
    return fit_;
  }
  OrderFit confirmed() {
    const bool more = fit_.order - claimed_ > tolerance_.order;
    return verdict(Verdict::confirmed,
                   more ? fmt::format("errors fall with order {:.2f} in the mean step, at least "
                                      "the {:g} that is claimed",
                                      fit_.order, claimed_)
                        : "");
  }
  OrderFit held(const OrderFit& order) {
    const double share = rejected_share(points_);
    if (!tolerance_.at_least || !(share > most_rejected)) return order;
    return undetermined(NoOrder::rejections, "order {:.2f}, with {:.0f} % of the tries rejected",
                        order.order, 100 * share);
  }
  template <class... Arguments>
  OrderFit undetermined(NoOrder why, fmt::format_string<Arguments...> reason,
                        Arguments&&... arguments) {
    fit_.why = why;
    return verdict(Verdict::undetermined,
                   fmt::format(reason, std::forward<Arguments>(arguments)...));
  }

  /// The first of points [first, certain_end_) that is neither rounding nor what `law` predicts;
  /// `certain_end_`: none.
  template <class Law>
  std::size_t first_stray(std::size_t first, const Law& law) const {
    for (std::size_t i = first; i < certain_end_; ++i)
      if (certain(i) && std::abs(std::log(points_[i].error / law.at(points_[i].step))) >
                            std::log(tolerance_.stray))
        return i;
    return certain_end_;
  }

  PowerLaw law_of(const Window& window) const {
    return fit_power_law(points_.data() + window.first, window.count);
  }

  bool is_claimed(double order) const {
    return claimed_ - order <= tolerance_.order &&
           order - claimed_ <= tolerance_.order + (tolerance_.at_least ? still_converging : 0);
  }

  bool confirms(const Window& window) const {
    const PowerLaw law = law_of(window);
    const bool known = 2 * law.half_width <= claimed_ / 2 ||
                       (tolerance_.at_least && law.order - law.half_width >= claimed_);
    return known && is_claimed(law.order) && first_stray(window.end(), law) == certain_end_;
  }

  // The finest window that confirms the claim; else the finest clear of rounding, if there is one.
  Window choose_window() {
    const auto window_to = [&](std::size_t end) {
      return find_window(points_, end, guess_, tolerance_.settled);
    };
    Window chosen = window_to(points_.size());
    while (chosen.count && !confirms(chosen) && chosen.end() > certain_end_)
      chosen = window_to(chosen.end() - 1);
    if (!chosen.count) chosen = window_to(points_.size());
    if (chosen.count) record(law_of(chosen), chosen);
    return chosen;
  }

  void record(const auto& law, const Window& window) {
    fit_.order = law.order;
    fit_.low = law.order - law.half_width;
    fit_.high = law.order + law.half_width;
    fit_.points = window.count;
    fit_.step_coarsest = points_[window.first].step;
    fit_.step_finest = points_[window.end() - 1].step;
  }

  double finest_slope() const { return local_slope_to(points_, points_.size() - 1); }

  // Many slopes agree below the claim: two terms through them and points next to rounding say
  // nothing.
  bool settled_lower(const Window& window) const {
    return window.count >= 8 && fit_.high < claimed_ - tolerance_.apart;
  }

  // Slopes that still move, or settle elsewhere than they will: the next term of the error. A term
  // of lower order, which the fit has not, lowers p, so that a p below the claim confirms nothing.
  bool confirmed_by_two_terms() {
    const TwoTermFit two = fit_two_terms(points_);
    if (two.points == 0 || two.half_width > tolerance_.order || !is_claimed(two.order) ||
        claimed_ - two.order > two_terms_below ||
        first_stray(two.first + two.points, two) < certain_end_)
      return false;
    record(two, {two.first, two.points});
    verdict(Verdict::confirmed,
            fmt::format("local slopes still move, {:.2f} at the finest steps; by the error's first "
                        "two terms, C h^p (1 + D h), p is {:.2f}",
                        finest_slope(), two.order));
    return true;
  }

  // The next term explains slopes that move, and the order before it is another one.
  bool denied_by_two_terms() const {
    const TwoTermFit two = fit_two_terms(points_);
    return two.points > 0 && two.half_width <= tolerance_.order &&
           std::abs(two.order - claimed_) > tolerance_.apart;
  }

  double span(const Window& window) const {
    return points_[window.first].step / points_[window.end() - 1].step;
  }
  /// Whether the slope of a window is an order: constant for long, or a whole number, of which only
  /// the next above the claim needs no more than one term of the error to vanish.
  bool is_an_order(const Window& window) const {
    if (std::isinf(tolerance_.whole)) return true;
    const double half_width = (fit_.high - fit_.low) / 2, nearest = std::round(fit_.order);
    const bool whole = nearest > 0 && nearest <= claimed_ + 1 &&
                       std::abs(fit_.order - nearest) + half_width <= tolerance_.whole;
    return half_width <= tolerance_.whole && span(window) >= (whole ? short_span : long_span);
  }

  /// Whether the slopes were higher before the window: a term of lower order has taken over.
  bool took_over(const Window& window) const {
    const ErrorPoint& coarsest = points_[window.first];
    for (std::size_t i = window.first; i-- > 0;)
      if (points_[i].step >= slopes_before * coarsest.step)
        return local_slope(points_[i], coarsest) > fit_.high + tolerance_.apart;
    return false;
  }

  OrderFit floors(const ErrorFloor& floor) {
    fit_.floor = floor.level;
    fit_.floor_step = floor.step;
    fit_.floor_scale = floor.scale;
    const ErrorPoint& at = points_[(floor.first + certain_end_) / 2];
    std::string reason = fmt::format("the error stops falling at {:.1e}, from steps of {:.2g} on",
                                     floor.level, floor.step);
    if (at.rounding_unit > 0)
      reason += fmt::format(", {:.0f} times rounding", floor.level / at.typical_rounding());
    if (!floor.scale.empty()) reason += "; " + floor.scale;
    fit_.order = fit_.low = fit_.high = nan;
    fit_.points = 0;
    if (const Window before = find_window(points_, floor.first + 1, guess_, tolerance_.settled);
        before.count) {
      record(law_of(before), before);
      reason += fmt::format("; order {:.2f} before", fit_.order);
    }
    return verdict(Verdict::floors, reason);
  }

  OrderFit settled_elsewhere(const Window& window) {
    if (points_.size() < fewest_points)
      return undetermined(
          reached_rounding_ ? NoOrder::few_points : NoOrder::few_solved,
          "{} steps give an error that is solved, converging and clear of rounding; {} are needed",
          points_.size(), fewest_points);
    const auto moving = [&] {
      return undetermined(NoOrder::unsettled,
                          "local slopes do not settle: {:.2f} at the finest steps", finest_slope());
    };
    if (!window.count) return moving();
    const PowerLaw law = law_of(window);
    if (const std::size_t i = first_stray(window.end(), law); i < certain_end_)
      return undetermined(NoOrder::denied,
                          "order {:.2f} down to steps of {:.2g}, but at {:.2g} the error is {:.2g} "
                          "times what that predicts",
                          law.order, fit_.step_finest, points_[i].step,
                          points_[i].error / law.at(points_[i].step));
    const double finest = points_[std::max<std::size_t>(certain_end_, 1) - 1].step;
    if (fit_.step_finest > finest_end * finest) return moving();
    // Rounding lowers a slope: a lower one must be seen where errors are clear of rounding.
    const bool rounding = fit_.order < claimed_ && window.end() > certain_end_;
    if (fit_.high - fit_.low > claimed_ / 2 || rounding ||
        (fit_.low <= claimed_ && claimed_ <= fit_.high))
      return undetermined(NoOrder::wide_interval,
                          "the slope {:.2f} is known to lie in [{:.2f}, {:.2f}] only, which does "
                          "not settle whether it is {:g}",
                          fit_.order, fit_.low, fit_.high, claimed_);
    return denial(window);
  }

  // The claim is none of the slopes; what they are instead.
  OrderFit denial(const Window& window) {
    if (std::abs(fit_.order - claimed_) <= tolerance_.apart)
      return undetermined(NoOrder::unsettled,
                          "the slope {:.2f} is near {:g} but has not settled there", fit_.order,
                          claimed_);
    const double whole = tolerance_.at_least ? slope_of_resolved(points_, window.end()) : nan;
    if (fit_.order < claimed_ && window.count < fewest_points + 2 && whole >= claimed_)
      return undetermined(NoOrder::unsettled,
                          "the slope {:.2f} over {} tolerances; {:.2f} over all", fit_.order,
                          window.count, whole);
    if (moves_towards(points_, window, claimed_, tolerance_.order) && !denied_by_two_terms())
      return undetermined(NoOrder::unsettled,
                          "the slope {:.2f} has not settled: local slopes move towards {:g}, to "
                          "{:.2f} at the finest steps",
                          fit_.order, claimed_,
                          local_slope(points_[window.end() - 2], points_[window.end() - 1]));
    if ((tolerance_.at_least && fit_.order > claimed_) ||
        (!is_an_order(window) && !(fit_.order < claimed_ && took_over(window))))
      return undetermined(NoOrder::unsettled,
                          "the slope {:.2f} has not settled: over a factor of {:.2g} in the steps "
                          "it is not an order",
                          fit_.order, span(window));
    return verdict(
        fit_.order > claimed_ ? Verdict::higher : Verdict::lower,
        fmt::format("converges with order {:.2f} where {:g} is claimed", fit_.order, claimed_));
  }

  Points points_;
  double claimed_, guess_;
  FitTolerance tolerance_;
  std::size_t certain_end_ = 0;  ///< finer points may be rounding
  bool reached_rounding_ = false;
  OrderFit fit_;
};

}  // namespace

OrderFit fit_order(const Points& points, double claimed_order, const FitTolerance& tolerance) {
  OrderFit fit;
  Points solved = points;
  std::erase_if(solved, [](const ErrorPoint& p) { return !std::isfinite(p.error); });
  if (solved.empty()) {
    fit.verdict = Verdict::failed;
    fit.why = NoOrder::few_solved;
    fit.reason = "no run was solved";
    return fit;
  }
  if (is_exact(solved)) {
    double largest = 0;
    for (const ErrorPoint& p : solved) largest = std::max(largest, p.error);
    fit.verdict = Verdict::higher;
    fit.reason = fmt::format("exact but for rounding: errors up to {:.1e}", largest);
    return fit;
  }
  merge_same_steps(solved);
  // An error ten times the solution itself is a blow-up; tolerances may be too loose for a
  // solution.
  const double most = tolerance.at_least ? 0.25 : 10;
  std::erase_if(solved, [&](const auto& p) { return p.scale > 0 && p.error > most * p.scale; });
  return Fitting(std::move(solved), claimed_order, tolerance).conclude();
}

}  // namespace odeum::judge
