// SPDX-License-Identifier: BSD-3-Clause
// --format means the same for every command: rows as CSV, all of it as JSON, a table for people.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::formats_test {
namespace {

class Formats : public testing::TestWithParam<const char*> {};

TEST_P(Formats, AreTheSameForEveryCommand) {
  const TemporaryFolder folder;
  write_text(folder.path() / "my.yaml",
             "states: {x: 1}\nparameters: {k: 1}\nequations: {x: -k*x}\ntime: {end: 1}\n");
  const auto printed = [&](const char* format) {
    const Result result =
        shell(fmt::format("cd '{0}' && XDG_CACHE_HOME='{0}' odeum {1} --format {2} "
                          "2>remarks",
                          folder.path().string(), GetParam(), format));
    EXPECT_EQ(result.code, 0) << result.output << text_of(folder.path() / "remarks");
    return result.output;
  };
  const std::string csv = printed("csv");
  EXPECT_TRUE(csv.starts_with("schema,")) << csv;
  EXPECT_NE(csv.find('\n'), csv.size() - 1) << "no row";
  const std::string json = printed("json");
  EXPECT_TRUE(nlohmann::json::accept(json)) << json;
  // A count has one name, that of the CSV files.
  for (const char* const other : {"\"evaluations\"", "\"jacobians\"", "\"rejected\""})
    EXPECT_EQ(json.find(other), std::string::npos) << json;
  for (const char* const table : {"table", "text"}) {
    const std::string text = printed(table);
    EXPECT_FALSE(text.starts_with("schema,") || nlohmann::json::accept(text)) << text;
  }
}

INSTANTIATE_TEST_SUITE_P(, Formats,
                         testing::Values("list scenes", "run my.yaml --solver rk4 --step 0.1",
                                         "advise my.yaml --error 1e-3 --seconds 600",
                                         "why my.yaml --solver rk4 --step 0.1 --seconds 600",
                                         "sweep my.yaml --over k=1,2 --solver rk4 --step 0.1",
                                         "converge osc_under --solver rk4 --quick --out out"));

}  // namespace
}  // namespace odeum::tests::formats_test
