// SPDX-License-Identifier: BSD-3-Clause
// The data of cases agree with the index of the independent references.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "odeum/cases/reference.hpp"
#include "support/catalogue.hpp"

namespace odeum::case_references_test {
namespace {

/// The index of the references: problem, parameters, floors.
nlohmann::json index() {
  std::ifstream file(ODEUM_SOURCE_DIR "/cases/reference/index.json");
  return nlohmann::json::parse(file);
}

/// A number of the index, or one of the few formulas used in place of one.
double number(const std::string& text, double eccentricity) {
  if (text == "1-e") return 1 - eccentricity;
  if (text == "sqrt((1+e)/(1-e))") return std::sqrt((1 + eccentricity) / (1 - eccentricity));
  if (text == "cos(1.1)") return std::cos(1.1);
  if (text == "sin(1.1)") return std::sin(1.1);
  return std::stod(text);
}

bool spelt_out(const nlohmann::json& state) {
  return std::none_of(state.begin(), state.end(), [](const auto& entry) {
    const auto text = entry.template get<std::string>();
    return text.find(':') != std::string::npos || text.find('j') != std::string::npos ||
           text.find('=') != std::string::npos;
  });
}

/// Whether a case takes its truth from a longer version of a reference, which agrees with it.
bool is_continued(const std::string& source, double digits) {
  const std::string stem = source.substr(0, source.size() - std::string(".csv").size());
  for (const Case& c : all_cases()) {
    if (c.truth.source != stem + "_long.csv") continue;
    const Truth shorter = cases::reference_truth(stem.substr(stem.rfind('/') + 1), digits);
    for (const double t : c.stops) {
      std::vector<double> y(c.y0.size()), expected(c.y0.size());
      EXPECT_TRUE(c.truth.at(t, y.data()));
      EXPECT_TRUE(shorter.at(t, expected.data()));
      for (const std::size_t i : c.measured) EXPECT_NEAR(y[i], expected[i], digits) << t;
    }
    return true;
  }
  return false;
}

/// Every reference is the truth of a case, which has the reference's initial state and claims no
/// more digits than the index states.
TEST(Reference, IsTheTruthOfACase) {
  for (const auto& entry : index()) {
    const auto name = entry["problem"].get<std::string>();
    const std::string source = "cases/reference/" + entry["csv"].get<std::string>();
    const Case* found = nullptr;
    for (const Case& c : all_cases())
      if (c.truth.source == source) found = &c;
    if (!found) {
      const auto digits = entry["correct_digits"].get<int>();
      EXPECT_TRUE(is_continued(source, std::pow(10.0, -digits))) << name << " is not a case";
      continue;
    }
    const auto& state = entry["initial_state"];
    if (state.size() != found->y0.size() || !spelt_out(state)) continue;
    const double e = entry["parameters"].contains("e")
                         ? std::stod(entry["parameters"]["e"].get<std::string>())
                         : 0;
    for (std::size_t i = 0; i < state.size(); ++i)
      EXPECT_DOUBLE_EQ(found->y0[i], number(state[i].get<std::string>(), e)) << name << ", " << i;
    if (!entry["double_input_floor_rel_normwise"].is_object()) continue;
    for (const auto& [time, floor] : entry["double_input_floor_rel_normwise"].items()) {
      const double t = std::stod(time);
      const auto granted = [&, floor = floor](const std::vector<double>& stops, double claimed) {
        if (std::find(stops.begin(), stops.end(), t) == stops.end()) return;
        std::vector<double> y(found->y0.size());
        ASSERT_TRUE(found->truth.at(t, y.data()));
        double squares = 0;
        for (const double component : y) squares += component * component;
        const double absolute = std::stod(floor.get<std::string>()) * std::sqrt(squares);
        // What lies below 1e-25 is beyond the digits of the reference; 5 %: the index rounds.
        EXPECT_GE(1.05 * claimed, absolute > 1e-25 ? absolute : 0) << name << " at t = " << t;
      };
      granted(found->stops, found->truth.floor);
      granted(found->timed_stops(), found->timed_floor());
    }
  }
}

}  // namespace
}  // namespace odeum::case_references_test
