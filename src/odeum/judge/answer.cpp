// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/judge/answer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace odeum::judge {

namespace {

/// The answer of a run that has a state past the end of the solution; none where it has not.
std::optional<JudgedAnswer> past_the_end(const std::vector<StopError>& errors) {
  for (const StopError& error : errors)
    if (std::isinf(error.error_max))
      return JudgedAnswer{
          .answer = Answer::wrong,
          .reason = fmt::format(
              "the run ended ok at t = {}, and the solution is infinite before that time",
              error.time)};
  return std::nullopt;
}

/// Errors relative to the solution's size: above the first a run is not a solution, above the
/// second it has hardly a digit.
constexpr double most_of_size = 10, useless = 0.1;

/// What is explained is an estimate, by some directions and controls: an error above it by less
/// than this is not called wrong.
constexpr double margin = 1.1;

/// Says it of the largest error, before a semicolon; empty where digits are left.
std::string no_digit_left(const std::vector<StopError>& errors, double scale) {
  const StopError* worst = nullptr;
  for (const StopError& error : errors)
    if (error.error_max > (worst ? worst->error_max : useless * scale)) worst = &error;
  if (!worst) return "";
  return fmt::format("an error of the size of the solution, {:.2g} at t = {}; ", worst->error_max,
                     worst->time);
}

}  // namespace

bool has_diverged(const std::vector<StopError>& errors, double scale) {
  return std::ranges::any_of(
      errors, [&](const StopError& error) { return error.error_max > most_of_size * scale; });
}

JudgedAnswer judge_fixed_answer(const std::vector<StopError>& errors, double scale) {
  if (const auto wrong = past_the_end(errors)) return *wrong;
  for (const StopError& error : errors)
    if (error.error_max > most_of_size * scale)
      return {.answer = Answer::wrong,
              .reason = fmt::format("the run ended ok and has diverged: an error of {:.2g} at t = "
                                    "{}, the solution being of the size {:.2g}",
                                    error.error_max, error.time, scale)};
  return {};
}

double explained_error(double tolerance, double steps, const Amplification& amplification,
                       std::size_t stop, double floor, double scale) {
  const double of_hundred = tolerance * 100 * amplification.at_stops[stop];
  const double of_all = of_hundred * std::max(steps / 100, 1.0);
  // Takes the finest control that is no finer than the run; without one, the coarsest.
  const Control* control = nullptr;
  for (const Control& each : amplification.controls)
    if (!control || each.tolerance >= 0.99 * tolerance) control = &each;
  if (!control || !std::isfinite(control->errors[stop])) return of_all + floor;
  return std::min(of_all, std::max({of_hundred, 0.5 * scale, 100 * control->errors[stop]})) + floor;
}

JudgedAnswer judge_answer(const std::vector<StopError>& errors, const Amplification& amplification,
                          double tolerance, double steps, double floor, double scale) {
  if (const auto wrong = past_the_end(errors)) return *wrong;
  if (!amplification.unknown.empty())
    return {.answer = Answer::undetermined,
            .reason = no_digit_left(errors, scale) + amplification.unknown};
  JudgedAnswer judged{.answer = Answer::undetermined, .reason = {}};
  double worst = -1;
  std::size_t at = 0;
  for (std::size_t stop = 0; stop < errors.size(); ++stop) {
    const double explained = explained_error(tolerance, steps, amplification, stop, floor, scale);
    const double ratio = errors[stop].error_max / explained;
    if (!(ratio > worst)) continue;  // NaN: the truth is not known there
    worst = ratio;
    at = stop;
    judged.explained = explained;
  }
  if (worst < 0)
    return {.answer = Answer::undetermined, .reason = "the truth is not known at the stops"};
  std::string what =
      fmt::format("tolerance {:.0e}, {:.0f} steps and an amplification of {:.2g} explain {:.2g}",
                  tolerance, steps, amplification.at_stops[at], judged.explained);
  if (judged.explained == 0.5 * scale + floor)
    what += ", half of the solution, where a method of high order gets far closer";
  judged.answer = worst > margin ? Answer::wrong : worst > 1 ? judged.answer : Answer::explained;
  if (worst > margin)
    judged.reason = fmt::format("the run ended ok with an error of {:.2g} at t = {}; {}",
                                errors[at].error_max, errors[at].time, what);
  else if (worst > 1)
    judged.reason = fmt::format("an error of {:.3g} at t = {} is within 10 % of the bound; {}",
                                errors[at].error_max, errors[at].time, what);
  else if (const std::string lost = no_digit_left({errors[at]}, scale); !lost.empty())
    judged.reason = lost + what;
  return judged;
}

}  // namespace odeum::judge
