// SPDX-License-Identifier: BSD-3-Clause
// Archives and descriptions that are damaged or made to do harm.
#include <cstdint>

#include "fmi/archive.hpp"
#include "fmi_stage.hpp"
#include "odeum/formula/cache.hpp"

namespace odeum::fmi_tests::fmi_damage_test {
namespace {

class DamagedFmus : public Fmus {};

TEST_P(DamagedFmus, DamagedArchivesAreRefused) {
  expect_refused((folder_ / "none.fmu").string(), "is not a file");
  const std::string file = fmu();
  const std::string whole = read(file);
  for (const double part : {0.0, 0.3, 0.99}) {
    std::ofstream(file, std::ios::binary)
        << whole.substr(0, static_cast<std::size_t>(part * static_cast<double>(whole.size())));
    expect_refused(file, "is not a whole ZIP archive");
  }
  std::string flipped = whole;
  flipped[whole.size() / 2] = static_cast<char>(flipped[whole.size() / 2] ^ 0x55);
  std::ofstream(file, std::ios::binary) << flipped;
  expect_refused(file, "is damaged");
  expect_refused(archive({{"readme", "nothing"}}), "has no modelDescription.xml");
}

TEST_P(DamagedFmus, ArchivesThatPointOutOfTheirFolderAreRefused) {
  const fs::path outside = folder_.parent_path() / "odeum_fmi_escaped";
  for (const char* name : {"../odeum_fmi_escaped", "resources/../../odeum_fmi_escaped",
                           "/odeum_fmi_escaped", "resources\\..\\..\\odeum_fmi_escaped", "C:/x"}) {
    Entries all = entries();
    all.emplace_back(name, "x");
    expect_refused(archive(all), "would be written outside of its folder");
  }
  EXPECT_FALSE(fs::exists(outside));
}

// They were left in /tmp by a run that was killed, for good.
TEST(UnpackedFmus, StandWhereTheNextRunRemovesThem) {
  const adapters::fmi::TemporaryFolder folder;
  ASSERT_FALSE(formula::cache_folder().empty());
  EXPECT_EQ(folder.path().parent_path(), formula::cache_folder());
  EXPECT_TRUE(folder.path().filename().string().starts_with("work-"));
}

// What they say of their size is enough: nothing was unpacked.
TEST_P(DamagedFmus, ArchivesThatUnpackToTooMuchAreRefusedBefore) {
  Entries all = entries();
  all.insert(all.begin(), {"resources/zeros", std::string(1'000'000, 0)});
  const std::string file = archive(all);
  std::string bytes = read(file);
  // The size in the central directory, 1.8 GB instead.
  const std::string size{0x40, 0x42, 0x0f, 0};
  const std::size_t at = bytes.rfind(size, bytes.rfind("resources/zeros"));
  ASSERT_NE(at, std::string::npos);
  bytes.replace(at, size.size(), std::string{0x40, 0x42, 0x0f, 0x70});
  std::ofstream(file, std::ios::binary) << bytes;
  expect_refused(file, "at most 1000000000 are unpacked");
}

TEST_P(DamagedFmus, BrokenDescriptionsAreRefused) {
  expect_refused_xml("</ModelVariables>", "", "modelDescription.xml: byte");
  expect_refused_xml("<fmiModelDescription", "<!DOCTYPE x [<!ENTITY a \"b\">]><fmiModelDescription",
                     "document type declaration");
  expect_refused_xml(three() ? "fmiVersion=\"3.0\"" : "fmiVersion=\"2.0\"", "fmiVersion=\"1.0\"",
                     "fmiVersion is \"1.0\"");
  expect_refused_xml("ModelExchange", "CoSimulation", "co-simulation only");
  expect_refused_xml("modelIdentifier=\"oscillator\"", "modelIdentifier=\"../oscillator\"",
                     "modelIdentifier");
  expect_refused_xml("stopTime=\"8\"", "stopTime=\"-8\"", "is not an interval");
  expect_refused_xml("stopTime=\"8\"", "stopTime=\"soon\"", "expected a number");
  expect_refused_xml("name=\"mu\"", "name=\"a\"", "variable a: there are two of that name");
  expect_refused_xml("name=\"mu\"", "name=\"\"",
                     "line 12: the variable of value reference 5 has no name");
  for (const char* start : {"nan", "-inf", "1e999"})
    expect_refused_xml("start=\"2\"", "start=\"" + std::string(start) + "\"",
                       "start: got \"" + std::string(start) + "\", expected a finite number");
  if (three()) {
    expect_refused_xml("derivative=\"3\"", "derivative=\"99\"", "no variable has the reference 99");
    expect_refused_xml("<ModelStructure>", "<ModelStructure><EventIndicator valueReference=\"1\"/>",
                       "exports no function fmi3GetEventIndicators");
    expect_refused_xml("</ModelVariables>",
                       "<Clock name=\"c\" valueReference=\"9\"/></ModelVariables>",
                       "the model has the clock c; clocks are not followed");
    expect_refused_xml("ModelExchange", "ScheduledExecution", "scheduled execution only");
  } else {
    expect_refused_xml("index=\"5\"", "index=\"99\"", "index 99: there are 8 variables");
    expect_refused_xml("index=\"5\"", "index=\"1\"", "but of no state");
    expect_refused_xml("numberOfEventIndicators=\"0\"", "numberOfEventIndicators=\"2\"",
                       "exports no function fmi2GetEventIndicators");
  }
}

/// Opens a file, which may be refused and nothing else; whether it was.
bool is_refused(const std::string& file) {
  try {
    open_fmu(file);
    return false;
  } catch (const LoadError&) {
    return true;
  }
}

TEST_P(DamagedFmus, DamagedBytesAreRefusedOrHarmless) {
  std::uint64_t state = 12345;
  const auto random = [&](std::size_t below) {
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<std::size_t>(state >> 33) % below;
  };
  int refused = 0;
  const std::string file = fmu();
  const std::string whole = read(file);
  for (int i = 0; i < 60; ++i) {
    // Its table of contents is at the end.
    std::string bytes = whole;
    bytes[bytes.size() - 1 - random(300)] = static_cast<char>(random(256));
    std::ofstream(file, std::ios::binary) << bytes;
    refused += is_refused(file);
  }
  for (int i = 0; i < 60; ++i)
    refused += is_refused(fmu([&](std::string& xml) {
      for (int k = 0; k < 3; ++k) xml[random(xml.size())] = static_cast<char>(32 + random(95));
    }));
  // Most damage matters; a comment or a description may have another letter.
  EXPECT_GT(refused, 30);
  std::string deep;
  for (int i = 0; i < 1'000'000; ++i) deep += "<a>";
  expect_refused(archive({{"modelDescription.xml", deep}}), "modelDescription.xml:");
}

INSTANTIATE_TEST_SUITE_P(Versions, DamagedFmus, testing::Values(2, 3));

}  // namespace
}  // namespace odeum::fmi_tests::fmi_damage_test
