// SPDX-License-Identifier: BSD-3-Clause
// FMUs that the build makes of tests/package/fmi: what runs, and what is refused with which reason.
#include <gtest/gtest.h>
#include <unistd.h>
#include <zip.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <utility>
#include <vector>

#include "odeum/contest/late.hpp"
#include "support/foreign_case.hpp"

namespace odeum {
namespace {

namespace fs = std::filesystem;
using Values = std::map<std::string, std::string>;
using Entries = std::vector<std::pair<std::string, std::string>>;
using Edit = std::function<void(std::string& xml)>;

std::string read(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  return {std::istreambuf_iterator<char>(in), {}};
}

void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
}

class Fmus : public testing::TestWithParam<int> {
 protected:
  Fmus() { fs::create_directories(folder_); }
  ~Fmus() override { fs::remove_all(folder_); }

  /// A ZIP archive with these entries.
  std::string archive(const Entries& entries) {
    const std::string file = (folder_ / "model.fmu").string();
    zip_t* const zip = zip_open(file.c_str(), ZIP_CREATE | ZIP_TRUNCATE, nullptr);
    EXPECT_TRUE(zip);
    for (const auto& [name, text] : entries)
      EXPECT_GE(zip_file_add(zip, name.c_str(), zip_source_buffer(zip, text.data(), text.size(), 0),
                             ZIP_FL_ENC_UTF_8),
                0);
    EXPECT_EQ(zip_close(zip), 0) << zip_strerror(zip);
    return file;
  }
  static bool three() { return GetParam() == 3; }
  static std::string binary_name() {
    return three() ? "binaries/" ODEUM_PROCESSOR "-linux/oscillator.so"
                   : "binaries/linux64/oscillator.so";
  }
  static Entries entries(const Edit& edit = {}, const std::string& binary = {}) {
    std::string xml = read(std::string(ODEUM_SOURCE_DIR "/tests/package/fmi/fmi") +
                           (three() ? "3.xml" : "2.xml"));
    if (edit) edit(xml);
    return {{"modelDescription.xml", xml},
            {binary_name(), read(!binary.empty() ? binary
                                 : three()       ? ODEUM_FMI3
                                                 : ODEUM_FMI2)}};
  }
  std::string fmu(const Edit& edit = {}) { return archive(entries(edit)); }

  static std::string refusal(const std::string& file, const Values& values = {}) {
    try {
      open_fmu(file, values);
    } catch (const LateError& error) {
      return error.what();
    }
    return "it was not refused";
  }
  void expect_refused(const std::string& file, const std::string& why, const Values& values = {}) {
    const std::string said = refusal(file, values);
    EXPECT_NE(said.find(why), std::string::npos) << said << "\nexpected: " << why;
    EXPECT_TRUE(said.starts_with(file)) << said;
  }
  void expect_refused_xml(const std::string& from, const std::string& to, const std::string& why) {
    expect_refused(fmu([&](std::string& xml) { replace(xml, from, to); }), why);
  }
  Case made(const Values& values = {}) {
    foreign::Given given = open_fmu(fmu(), values);
    given.id = "model";
    return cases::foreign_case(std::move(given)).c;
  }

  fs::path folder_ = fs::temp_directory_path() / ("odeum_fmi_test_" + std::to_string(getpid()) +
                                                  "_" + std::to_string(GetParam()));
};

const Entrant& entrant(const Case& c, const std::string& id) {
  for (const Entrant& e : c.entrants)
    if (e.info.id() == id) return e;
  throw std::runtime_error("no solver " + id);
}

Outcome solve(const Case& c, const std::string& id, double tolerance = 1e-9) {
  Request request{.mode = Mode::adaptive, .tolerance = tolerance, .stops = c.stops};
  return entrant(c, id).solve(request);
}

TEST_P(Fmus, ALinearModelHasTheClosedFormForTruthAndIsSolved) {
  const Case c = made({{"mu", "0"}, {"x", "1"}});
  EXPECT_EQ(c.components, (std::vector<std::string>{"x", "v"}));
  EXPECT_EQ(c.stops, (std::vector<double>{2, 4, 6, 8}));
  EXPECT_EQ(c.y0, (std::vector<double>{1, 0}));
  EXPECT_TRUE(c.has_tag("autonomous"));
  EXPECT_LT(c.truth.floor, 1e-11);
  double y[2];
  for (const double t : c.stops) {
    ASSERT_TRUE(c.truth.at(t, y)) << c.truth.source;
    EXPECT_NEAR(y[0], std::cos(t), c.truth.floor);
    EXPECT_NEAR(y[1], -std::sin(t), c.truth.floor);
  }
  for (const char* id : {"odeum/dormand_prince54", "odeum/rodas4", "odeum/radau_iia5"}) {
    const Outcome outcome = solve(c, id);
    ASSERT_EQ(outcome.status, Status::ok) << id << ": " << outcome.detail;
    // A tolerance of 1e-9 a step, on a problem that magnifies no error.
    EXPECT_NEAR(outcome.states[6], std::cos(8.0), 1e-6) << id;
  }
}

TEST_P(Fmus, TheJacobianIsThatOfDirectionalDerivatives) {
  const Case c = made();
  ASSERT_TRUE(c.problem.view.jacobian);
  double j[4];
  const double y[2] = {0.5, 3};
  c.problem.view.jacobian(c.problem.view.problem, 1, y, j);
  EXPECT_DOUBLE_EQ(j[0], 0);
  EXPECT_DOUBLE_EQ(j[1], 1);
  EXPECT_DOUBLE_EQ(j[2], -2 * 0.5 * 3 - 1);
  EXPECT_DOUBLE_EQ(j[3], 1 - 0.25);
  const std::string provides = three() ? "providesDirectionalDerivatives=\"true\""
                                       : "providesDirectionalDerivative=\"true\"";
  const foreign::Given without =
      open_fmu(fmu([&](std::string& xml) { replace(xml, provides, ""); }));
  EXPECT_EQ(without.functions.jacobian, nullptr);
}

TEST_P(Fmus, AModelThatDependsOnTimeHasItsTimeDerivative) {
  const Case c = made({{"a", "3"}});
  EXPECT_TRUE(c.has_tag("non_autonomous"));
  ASSERT_TRUE(c.problem.view.time_derivative);
  for (const double t : {0.0, 1.0, 8.0}) {
    double d[2];
    c.problem.view.time_derivative(c.problem.view.problem, t, c.y0.data(), d);
    EXPECT_EQ(d[0], 0);
    // Differences over 8e-6 of numbers near 3: a rounding of 1e-10.
    EXPECT_NEAR(d[1], 3 * std::cos(t), 1e-8) << t;
  }
  // What a Rosenbrock method would miss without it.
  const Outcome a = solve(c, "odeum/rodas4"), b = solve(c, "odeum/dormand_prince853");
  ASSERT_EQ(a.status, Status::ok) << a.detail;
  EXPECT_NEAR(a.states[6], b.states[6], 1e-6);
}

TEST_P(Fmus, ValuesThatCannotBeSetAreRefused) {
  const std::string file = fmu();
  expect_refused(file, "no variable nu; it has x, v, mu, a, fault", {{"nu", "1"}});
  expect_refused(file, "der(x) is computed or constant", {{"der(x)", "1"}});
  expect_refused(file, "got \"one\", expected a number", {{"mu", "one"}});
  expect_refused(file, "expected a whole number", {{"fault", "1.5"}});
}

TEST_P(Fmus, DamagedArchivesAreRefused) {
  expect_refused((folder_ / "none.fmu").string(), "is no file");
  const std::string file = fmu();
  const std::string whole = read(file);
  for (const double part : {0.0, 0.3, 0.99}) {
    std::ofstream(file, std::ios::binary)
        << whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size())));
    expect_refused(file, "is no whole ZIP archive");
  }
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 0x55);
  std::ofstream(file, std::ios::binary) << flipped;
  expect_refused(file, "is damaged");
  expect_refused(archive({{"readme", "nothing"}}), "has no modelDescription.xml");
}

TEST_P(Fmus, ArchivesThatPointOutOfTheirFolderAreRefused) {
  const fs::path outside = folder_.parent_path() / "odeum_fmi_escaped";
  for (const char* name : {"../odeum_fmi_escaped", "resources/../../odeum_fmi_escaped",
                           "/odeum_fmi_escaped", "resources\\..\\..\\odeum_fmi_escaped", "C:/x"}) {
    Entries all = entries();
    all.emplace_back(name, "x");
    expect_refused(archive(all), "would be written outside of its folder");
  }
  EXPECT_FALSE(fs::exists(outside));
}

TEST_P(Fmus, BrokenDescriptionsAreRefused) {
  expect_refused_xml("</ModelVariables>", "", "modelDescription.xml: byte");
  expect_refused_xml("<fmiModelDescription", "<!DOCTYPE x [<!ENTITY a \"b\">]><fmiModelDescription",
                     "document type declaration");
  expect_refused_xml(three() ? "fmiVersion=\"3.0\"" : "fmiVersion=\"2.0\"", "fmiVersion=\"1.0\"",
                     "fmiVersion is \"1.0\"");
  expect_refused_xml("ModelExchange", "CoSimulation", "co-simulation only");
  expect_refused_xml("modelIdentifier=\"oscillator\"", "modelIdentifier=\"../oscillator\"",
                     "modelIdentifier");
  expect_refused_xml("stopTime=\"8\"", "stopTime=\"-8\"", "is no interval");
  expect_refused_xml("stopTime=\"8\"", "stopTime=\"soon\"", "expected a number");
  if (three()) {
    expect_refused_xml("derivative=\"3\"", "derivative=\"99\"", "no variable has the reference 99");
    expect_refused_xml("<ModelStructure>", "<ModelStructure><EventIndicator valueReference=\"1\"/>",
                       "state events (1 event indicators)");
    expect_refused_xml("modelIdentifier=", "needsCompletedIntegratorStep=\"true\" modelIdentifier=",
                       "acts at the end of steps");
    expect_refused_xml("</ModelVariables>",
                       "<Clock name=\"c\" valueReference=\"9\"/></ModelVariables>", "clocks");
  } else {
    expect_refused_xml("index=\"5\"", "index=\"99\"", "index 99: there are 8 variables");
    expect_refused_xml("index=\"5\"", "index=\"1\"", "but of no state");
    expect_refused_xml("numberOfEventIndicators=\"0\"", "numberOfEventIndicators=\"2\"",
                       "state events (2 event indicators)");
  }
}

TEST_P(Fmus, OtherBinariesAreRefused) {
  Entries other = entries();
  other[1].first = "binaries/win64/oscillator.dll";
  expect_refused(archive(other), "it has those for win64");
  expect_refused(archive({entries()[0]}), "it has none at all");
  Entries text = entries();
  text[1].second = "no shared object";
  expect_refused(archive(text), "cannot be loaded");
  // The binary of the other version has none of the functions; one lacks a single one.
  expect_refused(archive(entries({}, three() ? ODEUM_FMI2 : ODEUM_FMI3)),
                 "exports no function fmi");
  if (!three())
    expect_refused(archive(entries({}, ODEUM_FMI2_WITHOUT)),
                   "exports no function fmi2GetDerivatives");
  expect_refused_xml("{oscillator}", "{another}", "is another");
}

TEST_P(Fmus, WhatFailsOrHasEventsAtTheStartIsRefused) {
  const std::string file = fmu();
  expect_refused(file, "rhs fails or is not finite at t = 0", {{"fault", "1"}});
  expect_refused(file, "has time events (the first at t = 1)", {{"fault", "6"}});
  expect_refused(file, "EnterInitializationMode returned error", {{"fault", "7"}});
  expect_refused(file, "events at the end of steps", {{"fault", "8"}});
  expect_refused(file, "foreign code crashed: Aborted", {{"fault", "9"}});
}

// From x = 2 the model fails once x < 1, near t = 1.7.
TEST_P(Fmus, WhatFailsLaterCostsItsSolvesOnly) {
  const std::pair<const char*, const char*> faults[] = {{"3", "crashed: Aborted"},
                                                        {"5", "exit code 0"}};
  for (const auto& [fault, why] : faults) {
    const Case c = made({{"fault", fault}});
    double y[2];
    EXPECT_FALSE(c.truth.at(8, y)) << fault;
    EXPECT_NE(c.settings.no_convergence.find(why), std::string::npos) << c.settings.no_convergence;
    const Outcome outcome = solve(c, "odeum/dormand_prince54");
    EXPECT_EQ(outcome.status, Status::refused) << fault;
    EXPECT_NE(outcome.detail.find(why), std::string::npos) << fault << ": " << outcome.detail;
  }
}

TEST_P(Fmus, ATruthEndsWhereTheModelDoes) {
  for (const char* fault : {"2", "10"}) {
    Case c = made({{"fault", fault}});
    ASSERT_EQ(c.stops.size(), 1U);
    EXPECT_GT(c.stops[0], 1);
    EXPECT_LT(c.stops[0], 2);
    c.stops = {8};
    const Outcome outcome = solve(c, "odeum/dormand_prince54");
    EXPECT_TRUE(outcome.status == Status::non_finite || outcome.status == Status::step_too_small)
        << to_string(outcome.status) << outcome.detail;
  }
}

TEST_P(Fmus, AModelThatHangsIsEnded) {
  const Case c = made({{"fault", "4"}});
  EXPECT_NE(c.settings.no_convergence.find("was ended"), std::string::npos)
      << c.settings.no_convergence;
  const Outcome outcome = solve(c, "odeum/dormand_prince54");
  EXPECT_EQ(outcome.status, Status::over_budget) << outcome.detail;
}

INSTANTIATE_TEST_SUITE_P(Versions, Fmus, testing::Values(2, 3));

}  // namespace
}  // namespace odeum
