// SPDX-License-Identifier: BSD-3-Clause
// The commands of reports/docs/course.md.
#include <gtest/gtest.h>

#include <set>
#include <sstream>

#include "odeum/cases/scene_case.hpp"
#include "support/page_data.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::course_test {
namespace {

std::vector<std::string> course_commands() {
  std::istringstream lines(text_of(ODEUM_SOURCE_DIR "/reports/docs/course.md"));
  std::vector<std::string> commands;
  std::string line;
  while (std::getline(lines, line))
    if (line.starts_with("scripts/odeum ")) commands.push_back(line.substr(8));
  return commands;
}

class Course : public testing::TestWithParam<std::string> {};

TEST_P(Course, CommandRuns) {
  const TemporaryFolder folder;
  std::string command = GetParam();
  const std::string listed = "/tmp/course";
  const std::size_t out = command.find(listed);
  if (out != std::string::npos) command.replace(out, listed.size(), folder.path().string());
  // References of large scenes take up to half a minute each, and have tests of their own.
  for (const cases::SceneText& scene : cases::all_scenes())
    if (const std::string run = "odeum run " + std::string(scene.name);
        command.starts_with(run + " "))
      command.insert(run.size(), " --no-truth");
  const Result result = shell("cd " ODEUM_SOURCE_DIR " && " + command);
  EXPECT_EQ(result.code, 0) << result.output;
  if (!command.starts_with("odeum run ")) return;
  ASSERT_NE(out, std::string::npos) << "no --out";
  const std::filesystem::path path(command.substr(command.find("--out ") + 6));
  // A page with something to draw.
  const auto page = json_of(path / "page.json");
  EXPECT_TRUE(std::filesystem::exists(path / "index.html"));
  EXPECT_GE(table_in(path, page["runs"]["kind"] == "case" ? "trajectory" : "energies")["rows"], 2);
}

INSTANTIATE_TEST_SUITE_P(List, Course, testing::ValuesIn(course_commands()), [](const auto& test) {
  std::string name = "n" + std::to_string(test.index);
  for (const char c : test.param.substr(test.param.rfind('/') + 1))
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') name += c;
  return name;
});

TEST(CourseList, WritesEachCommandIntoAFolderOfItsOwn) {
  std::set<std::string> folders;
  for (const std::string& command : course_commands())
    if (const std::size_t out = command.find("--out "); out != std::string::npos) {
      EXPECT_TRUE(folders.insert(command.substr(out)).second) << command;
    }
  EXPECT_GE(folders.size(), 30U);
}

}  // namespace
}  // namespace odeum::tests::course_test
