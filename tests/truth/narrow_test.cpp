// SPDX-License-Identifier: BSD-3-Clause
// Pulses, switches and kinks of widths from 1e-6 to 1, which steps may pass over: what a computed
// truth claims to be known is known, against closed forms.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>

#include "odeum/cases/text_truth.hpp"

namespace odeum::narrow_test {
namespace {

using Real = long double;

constexpr Real end = 20, decay = 0.1L;
const Real centre = std::strtold("7.3", nullptr);

struct Narrow {
  const char* name;
  const char* text;  ///< W: the width
  Real (*exact)(Real w);
};

/// y(end) of y' = -decay y + (1 from a to b), y(0) = 1.
Real of_pulse(Real a, Real b) {
  return std::exp(-decay * end) +
         (std::exp(-decay * (end - b)) - std::exp(-decay * (end - a))) / decay;
}
Real log_cosh(Real x) {
  return std::abs(x) + std::log1p(std::exp(-2 * std::abs(x))) - std::numbers::ln2_v<Real>;
}
Real of_peaks(Real w) {
  // cos(t) > 1 - w around 0, 2 pi, 4 pi and 6 pi, the last perhaps cut by the end.
  const Real half = std::acos(1 - w), last = end - 6 * std::numbers::pi_v<Real>;
  return 1 + half + 4 * half + half + std::min(half, last);
}

// The parser reads decimals in extended precision, as strtold does.
const Narrow narrow[] = {
    {"switches", "if(abs(t - 7.3) < W, 1, 0) - 0.1*y",
     [](Real w) { return of_pulse(centre - w, centre + w); }},
    {"conditions", "if(t > 7.3, 1, 0)*if(t < 7.3 + W, 1, 0) - 0.1*y",
     [](Real w) { return of_pulse(centre, centre + w); }},
    {"signs", "0.5*(sign(t - 7.3) - sign(t - 7.3 - W)) - 0.1*y",
     [](Real w) { return of_pulse(centre, centre + w); }},
    {"nested", "if(t > 7.3, if(t < 7.3 + W, 1, 0), 0) - 0.1*y",
     [](Real w) { return of_pulse(centre, centre + w); }},
    {"kinks", "max(0, 1 - abs(t - 7.3)/W)", [](Real w) { return 1 + w; }},
    {"tanh", "0.5*(tanh((t - 7.3)/W) - tanh((t - 7.3)/W - 2))",
     [](Real w) {
       const auto part = [w](Real t) {
         return log_cosh((t - centre) / w) - log_cosh((t - centre) / w - 2);
       };
       return 1 + w / 2 * (part(end) - part(0));
     }},
    {"gauss", "exp(-((t - 7.3)/W)^2)",
     [](Real w) {
       return 1 + w * std::sqrt(std::numbers::pi_v<Real>) / 2 *
                      (std::erf((end - centre) / w) + std::erf(centre / w));
     }},
    {"quotient", "1/(1 + ((t - 7.3)/W)^2)",
     [](Real w) { return 1 + w * (std::atan((end - centre) / w) + std::atan(centre / w)); }},
    {"of_a_state", "if(x > 1 - W, 1, 0)", of_peaks},
    {"smooth_of_a_state", "exp(-((s - 7.3)/W)^2)",
     [](Real w) {
       return 1 + w * std::sqrt(std::numbers::pi_v<Real>) / 2 *
                      (std::erf((end - centre) / w) + std::erf(centre / w));
     }},
};

/// The claim's error over its floor; -1: nothing is claimed.
Real error_over_floor(const Narrow& problem, const std::string& width, double& floor) {
  std::string equation = problem.text;
  for (std::size_t at = 0; (at = equation.find('W', at)) != std::string::npos;)
    equation.replace(at, 1, width);
  const std::string text = fmt::format(
      "states: {{y: 1, x: 1, v: 0, s: 0}}\nequations: {{y: \"{}\", x: v, v: -x, s: 1}}\n"
      "time: {{end: 20}}\n",
      equation);
  const cases::TextTruth truth = cases::truth_of(std::make_shared<const formula::TextOde>(
      formula::read_problem("f", text), formula::TextOde::Code::interpreted));
  floor = truth.extended_floor;
  Real y[4];
  if (!truth.extended(static_cast<double>(end), y)) return -1;
  return std::abs(y[0] - problem.exact(std::strtold(width.c_str(), nullptr))) / floor;
}

class NarrowFeature : public testing::TestWithParam<Narrow> {};

TEST_P(NarrowFeature, NoWrongDigitIsClaimed) {
  int known = 0;
  for (const char* width : {"1e-6", "1e-5", "1e-4", "1e-3", "1e-2", "0.1", "1"}) {
    double floor = 0;
    const Real ratio = error_over_floor(GetParam(), width, floor);
    known += ratio >= 0;
    // The closed forms round too: some ten units of the last place.
    EXPECT_LE(ratio * floor, floor + 2e-18L * 10) << width;
    std::cout << fmt::format("{} of width {}: {}\n", GetParam().name, width,
                             ratio < 0 ? "not known" : fmt::format("known to {:.1e}", floor));
  }
  EXPECT_GE(known, 6);
}

INSTANTIATE_TEST_SUITE_P(Texts, NarrowFeature, testing::ValuesIn(narrow),
                         [](const auto& instance) { return instance.param.name; });

}  // namespace
}  // namespace odeum::narrow_test
