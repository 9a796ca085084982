// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>
#include <zip.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "odeum/cases/foreign_case.hpp"
#include "odeum/solvers/runtime_library.hpp"

/// FMUs that the build makes of tests/package/fmi, as they are and with changes.
namespace odeum::fmi_tests {

namespace fs = std::filesystem;
using Values = std::map<std::string, std::string>;
using Entries = std::vector<std::pair<std::string, std::string>>;
using Edit = std::function<void(std::string& xml)>;

inline std::string read(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  EXPECT_TRUE(in) << file;
  return {std::istreambuf_iterator<char>(in), {}};
}

inline void replace(std::string& text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  ASSERT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
}

/// The parameter is the version of FMI.
class Fmus : public testing::TestWithParam<int> {
 public:
  ~Fmus() override { fs::remove_all(folder_); }

 protected:
  Fmus() { fs::create_directories(folder_); }

  /// A ZIP archive with these entries.
  std::string archive(const Entries& entries) {
    std::string file = (folder_ / "model.fmu").string();
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
    } catch (const LoadError& error) {
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
    foreign::ProblemCallbacks given = open_fmu(fmu(), values);
    given.id = "model";
    return case_of(cases::foreign_statement(std::move(given)));
  }

  fs::path folder_ = fs::temp_directory_path() / ("odeum_fmi_test_" + std::to_string(getpid()) +
                                                  "_" + std::to_string(GetParam()));
};

}  // namespace odeum::fmi_tests
