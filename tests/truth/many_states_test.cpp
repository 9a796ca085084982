// SPDX-License-Identifier: BSD-3-Clause
// References of many states, of which each run takes seconds.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numbers>
#include <string>

#include "odeum/cases/text_truth.hpp"
#include "odeum/truth/system.hpp"

namespace odeum::many_states_test {
namespace {

using truth::Real;

/// Masses in a line between two walls, in their lowest mode.
struct Chain {
  std::size_t masses = 100;
  Real stiffness = 101 * 101;
  std::shared_ptr<std::size_t> evaluations = std::make_shared<std::size_t>(0);

  Real shape(std::size_t i) const {
    return std::sin(std::numbers::pi_v<Real> * static_cast<Real>(i + 1) /
                    static_cast<Real>(masses + 1));
  }
  Real frequency() const {
    const Real half = std::numbers::pi_v<Real> / (2 * static_cast<Real>(masses + 1));
    return 2 * std::sqrt(stiffness) * std::sin(half);
  }
  truth::System system() const {
    truth::System system;
    system.states = 2 * masses;
    system.work = 10 * static_cast<double>(system.states);
    for (std::size_t i = 0; i < masses; ++i) system.y0.push_back(shape(i));
    system.y0.resize(system.states);
    system.rhs = [n = masses, k = stiffness, count = evaluations](Real, const Real* y, Real* f) {
      ++*count;
      for (std::size_t i = 0; i < n; ++i) {
        f[i] = y[n + i];
        f[n + i] = k * ((i > 0 ? y[i - 1] : 0) - 2 * y[i] + (i + 1 < n ? y[i + 1] : 0));
      }
    };
    return system;
  }
};

// A tolerance at which rounding decides the steps took fifty times the work of one above it, for no
// digit more.
TEST(ManyStates, NoWorkIsSpentOnTolerancesBelowRounding) {
  const Chain chain;
  const truth::Reference found = truth::compute_reference(chain.system(), {0.5, 1}, {});
  ASSERT_EQ(found.known_until, 1);
  const Real phase = std::cos(chain.frequency());
  for (std::size_t i = 0; i < chain.masses; ++i)
    EXPECT_LE(std::abs(found.states.back()[i] - phase * chain.shape(i)), found.floors.back()[i]);
  EXPECT_LE(*std::ranges::max_element(found.floors.back()), 1e-11);
  EXPECT_LE(*chain.evaluations, 40'000U);
}

// Networks of more species than a full matrix is taken for, in no order of which the Jacobian has a
// narrow band: a hub that decays, and what relaxes to it at rates of 2 to 1e7, with closed forms.
TEST(ManyStates, StiffNetworksAreKnownByTheEntriesOfTheirJacobian) {
  constexpr int leaves = 66;
  std::string states = "hub: 1", equations = "hub: -hub";
  std::vector<double> exact{std::exp(-2.0)};
  for (int i = 0; i < leaves; ++i) {
    const double k = 2 * std::pow(10.0, i * 6.7 / (leaves - 1));
    states += fmt::format(", s{}: 0", i);
    equations += fmt::format(", s{0}: {1:.17g}*(hub - s{0})", i, k);
    exact.push_back(k / (k - 1) * (std::exp(-2.0) - std::exp(-2 * k)));
  }
  const cases::TextTruth truth = cases::truth_of(std::make_shared<const formula::TextOde>(
      formula::read_problem("f", fmt::format("{{states: {{{}}}, equations: {{{}}}, time: "
                                             "{{end: 2, stops: [2]}}}}",
                                             states, equations)),
      formula::TextOde::Code::interpreted));
  std::vector<double> y(exact.size());
  ASSERT_TRUE(truth.truth.at(2, y.data())) << truth.truth.source;
  for (std::size_t i = 0; i < y.size(); ++i)
    EXPECT_NEAR(y[i], exact[i], 1e-14 + truth.truth.floor) << i;  // rounding of the closed forms
  EXPECT_LE(truth.truth.floor, 1e-12);
}

}  // namespace
}  // namespace odeum::many_states_test
