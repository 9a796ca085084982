// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/truth/certificate.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "odeum/cases/text_case.hpp"
#include "support/catalogue.hpp"

namespace odeum::truth::certificate_test {
namespace {

using Said = Certificate::Said;
using Real = long double;

/// The certificate of the claim that the first state is `exact`, off by `off`, and the others as
/// the text has them.
Certificate certificate_of(const std::string& text, const std::function<Real(Real)>& exact,
                           double floor, double off = 0) {
  const formula::Problem problem = formula::read_problem("text.yaml", text);
  const formula::Evaluator<Real> closed(problem.graph, problem.exact);
  const auto at = [&](double t, double* y) {
    std::vector<Real> values(problem.states.size());
    if (!problem.exact.empty()) closed(t, nullptr, values.data());
    values[0] = exact(t) + off;
    std::copy(values.begin(), values.end(), y);
    return true;
  };
  const std::vector<double> floors(problem.states.size(), floor);
  return certify(problem, {problem.stops, at, floors, {}})
      .value_or(Certificate{.why = "without arb"});
}

class CertificateOf : public testing::Test {
 protected:
  void SetUp() override {
    const Certificate trivial = certificate_of(
        "{states: {y: 1}, equations: {y: 0*y}, time: {end: 1}}", [](Real) { return 1; }, 1e-9);
    if (trivial.why == "without arb") GTEST_SKIP() << trivial.why;
  }
};

const std::string oscillator =
    "parameters: {w: sqrt(0.99)}\n"
    "states: {q: 1, v: 0}\nequations: {q: v, v: -q - 0.2*v}\n"
    "exact:\n  q: exp(-0.1*t)*(cos(w*t) + 0.1/w*sin(w*t))\n  v: -exp(-0.1*t)*sin(w*t)/w\n"
    "time: {end: 20, stops: [5, 20]}\n";
Real swing(Real t) {
  const Real w = std::sqrt(1 - 0.1L * 0.1L);
  return std::exp(-0.1L * t) * (std::cos(w * t) + 0.1L / w * std::sin(w * t));
}

TEST_F(CertificateOf, ProvesARightTruthAndRefutesAWrongOne) {
  const Certificate right = certificate_of(oscillator, swing, 1e-16);
  EXPECT_EQ(right.said, Said::proved) << to_text(right);
  EXPECT_LT(right.width, 1e-16);
  // Off by little more than what is claimed: neither the radius nor the last place hides it.
  const Certificate wrong = certificate_of(oscillator, swing, 1e-16, 4e-16);
  EXPECT_EQ(wrong.said, Said::refuted) << to_text(wrong);
  EXPECT_EQ(wrong.time, 5);
  EXPECT_EQ(certificate_of(oscillator, swing, 1e-9, 1.001e-9).said, Said::refuted);
  EXPECT_EQ(certificate_of(oscillator, swing, 1e-9, 0.999e-9).said, Said::proved);
}

TEST_F(CertificateOf, HoldsTheValuesOfEveryOperation) {
  struct Function {
    const char* slope;
    Real (*exact)(Real);
  };
  for (const Function& f : std::initializer_list<Function>{
           {"cos(t)^2 - sin(t)^2", [](Real t) { return std::sin(t) * std::cos(t); }},
           {"0.5*(1 + tan(0.5*t)^2)", [](Real t) { return std::tan(t / 2); }},
           {"asin(0.5*t)", [](Real t) { return t * std::asin(t / 2) + std::sqrt(4 - t * t) - 2; }},
           {"acos(0.5*t)", [](Real t) { return t * std::acos(t / 2) - std::sqrt(4 - t * t) + 2; }},
           {"atan(t)", [](Real t) { return t * std::atan(t) - std::log1p(t * t) / 2; }},
           {"sinh(t) + cosh(t)", [](Real t) { return std::expm1(t); }},
           {"1 - tanh(t)^2", [](Real t) { return std::tanh(t); }},
           {"exp(-t)/2", [](Real t) { return -std::expm1(-t) / 2; }},
           {"log(1 + t)", [](Real t) { return (1 + t) * std::log1p(t) - t; }},
           {"log10(1 + t)",
            [](Real t) { return ((1 + t) * std::log1p(t) - t) / std::log(Real(10)); }},
           {"sqrt(1 + t)", [](Real t) { return 2 * (std::sqrt(1 + t) * (1 + t) - 1) / 3; }},
           {"(1 + t)^0.3", [](Real t) { return (std::pow(1 + t, 1.3L) - 1) / 1.3L; }},
           {"2^t", [](Real t) { return (std::pow(Real(2), t) - 1) / std::log(Real(2)); }},
           {"atan2(t, 1)", [](Real t) { return t * std::atan(t) - std::log1p(t * t) / 2; }},
           {"hypot(t, 1)",
            [](Real t) { return (t * std::sqrt(1 + t * t) + std::asinh(t)) / 2; }}}) {
    const std::string text = fmt::format(
        "{{states: {{y: 0}}, equations: {{y: '{} + 0*y'}}, time: {{end: 1}}}}", f.slope);
    EXPECT_EQ(certificate_of(text, f.exact, 1e-17).said, Said::proved) << f.slope;
    EXPECT_EQ(certificate_of(text, f.exact, 1e-15, 2e-15).said, Said::refuted) << f.slope;
  }
}

TEST_F(CertificateOf, GivesUpWhereTheSolutionIsChaoticStiffOrKinked) {
  const auto unknown = [](Real) { return 0; };
  const auto given_up = [&](const std::string& text, const char* why) {
    const Certificate c = certificate_of(text, unknown, 1e3);
    EXPECT_EQ(c.said, Said::agreed) << to_text(c);
    EXPECT_NE(to_text(c).find(why), std::string::npos) << to_text(c);
    return c;
  };
  const Certificate chaos = given_up(
      "{states: {x: 1, y: 1, z: 1}, time: {end: 200, stops: [10, 200]},\n"
      " equations: {x: 10*(y - x), y: x*(28 - z) - y, z: x*y - 8*z/3}}",
      "the enclosure is lost");
  EXPECT_EQ(chaos.proved, 1u) << "all is within 1000 of 0 at t = 10";
  given_up("{states: {y: 1}, equations: {y: 1e6*(cos(t) - y)}, time: {end: 1}}", "work is spent");
  given_up("{states: {y: 1}, equations: {y: -abs(y)}, time: {end: 1}}", "kinks");
  // A solution that ends before.
  given_up("{states: {y: 1}, equations: {y: y^2}, time: {end: 2}}", "");
}

TEST_F(CertificateOf, ProvesTheReferencesOfCases) {
  for (const char* id : {"lotka_volterra", "kepler_e06", "rigid_body_hlw", "freefall_drag"}) {
    const std::string words = cases::with_proof(tests::find_case(id));
    EXPECT_NE(words.find("; proved: "), std::string::npos) << id << ": " << words;
  }
  const Case& scene = tests::find_case("cloth11_two_way");
  EXPECT_EQ(cases::with_proof(scene), scene.truth.source) << "it is not a text";
}

TEST_F(CertificateOf, IsOfTheEquationsThatAUsersTextStates) {
  // Code of its own: the derivatives are in a graph that is not the one which was read.
  for (const char* equations : {"f2: 2*t^2*sin(f2 + f1) - f^2", "f2: -f1"}) {
    const std::string text = fmt::format(
        "states: {{f: 1, f1: 0, f2: 0.5}}\nequations: {{f: f1, f1: f2, {}}}\ntime: {{end: 1}}\n",
        equations);
    const Case c = case_of(cases::text_statements("third.yaml", text, "third").front());
    EXPECT_NE(c.truth.source.find("; proved: "), std::string::npos) << c.truth.source;
  }
}

}  // namespace
}  // namespace odeum::truth::certificate_test
