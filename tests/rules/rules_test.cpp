// SPDX-License-Identifier: BSD-3-Clause
// The rules of CONTRIBUTING.md that a program can check: no include points upwards, files and
// functions are short. What broke them when the test was written stands in known.txt, which only
// shrinks.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "source_tree.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::rules::rules_test {
namespace {

namespace fs = std::filesystem;
using tests::text_of;

const fs::path root = ODEUM_SOURCE_DIR;

/// The lines of known.txt of one kind (`include`, `file`, `function`), without that word.
std::set<std::string> known(const std::string& kind) {
  std::set<std::string> keys;
  std::ifstream in(root / "tests/rules/known.txt");
  for (std::string line; std::getline(in, line);)
    if (line.starts_with(kind + " ")) keys.insert(line.substr(kind.size() + 1));
  return keys;
}

void expect_only_known(const std::vector<Violation>& violations, const std::string& kind) {
  std::set<std::string> missing = known(kind);
  const std::set<std::string> allowed = missing;
  for (const Violation& each : violations) {
    missing.erase(each.key);
    EXPECT_TRUE(allowed.contains(each.key))
        << each.file << ":" << each.line << ": " << each.key << ": " << each.rule;
  }
  for (const std::string& key : missing)
    ADD_FAILURE() << "mended, remove from tests/rules/known.txt: " << kind << " " << key;
}

TEST(Rules, IncludesPointDown) {
  const std::vector<std::string> rooms = rooms_of(root / "CONTRIBUTING.md");
  ASSERT_GE(rooms.size(), 20U) << "the table of rooms in CONTRIBUTING.md was not found";
  for (const std::string& room : rooms) {
    const std::size_t name = room.find("/<name>");
    EXPECT_TRUE(fs::is_directory(root / room.substr(0, name))) << room << " is not a folder";
  }
  expect_only_known(upward_includes(root, rooms), "include");
}

TEST(Rules, FilesAreShort) { expect_only_known(long_files(root), "file"); }

TEST(Rules, FunctionsAreShort) { expect_only_known(long_functions(root), "function"); }

// Several are compiled together.
TEST(Rules, TestsHaveANamespaceOfTheirFile) {
  for (const fs::directory_entry& each : fs::recursive_directory_iterator(root / "tests")) {
    const std::string stem = each.path().stem(), room = each.path().parent_path().filename();
    if (!each.path().string().ends_with("_test.cpp") || room == "rules" || room == "package")
      continue;
    EXPECT_NE(text_of(each.path()).find("::" + stem + " {\n"), std::string::npos) << each.path();
  }
}

/// The first groups of all matches in a file.
std::vector<std::string> matches_in(const std::string& file, const std::regex& pattern) {
  const std::string text = text_of(root / file);
  std::vector<std::string> found;
  for (std::sregex_iterator each(text.begin(), text.end(), pattern), end; each != end; ++each)
    found.push_back((*each)[1]);
  return found;
}

bool is_own_method(const std::string& name) {
  return fs::exists(root / "src/odeum/methods" / (name + ".hpp"));
}

/// The words of a list in cases/inlined/lists.cmake.
std::set<std::string> inlined_list(const std::string& name) {
  const std::string text = text_of(root / "cases/inlined/lists.cmake");
  const std::size_t begin = text.find("set(" + name + "\n"),
                    one_line = text.find("set(" + name + " ");
  const std::size_t at = std::min(begin, one_line);
  if (at == std::string::npos) return {};
  std::istringstream words(
      text.substr(at + name.size() + 4, text.find(')', at) - at - name.size() - 4));
  return {std::istream_iterator<std::string>(words), {}};
}

// CMake reads no C++: the lists say again what these files say.
TEST(Inlined, ListsAreComplete) {
  std::set<std::string> methods, with_odeint;
  for (const auto& file : fs::directory_iterator(root / "src/odeum/methods"))
    if (text_of(file.path()).find("inlined = Inlined::") != std::string::npos)
      methods.insert(file.path().stem().string());
  EXPECT_EQ(inlined_list("ODEUM_INLINED_METHODS"), methods);
  const std::string rosenbrock4 = text_of(root / "cases/inlined/rosenbrock4.cpp"),
                    runs = text_of(root / "cases/inlined/rosenbrock4_runs.cpp");
  const std::regex problem("#include \"(problems/[a-z0-9_]+\\.hpp)\""),
      stiff_only("has_nonstiff_cases<\\w+> = false"),
      nonstiff_only("has_stiff_cases<\\w+> = false");
  for (const auto& file : fs::directory_iterator(root / "cases/inlined")) {
    if (file.path().extension() != ".hpp") continue;
    const std::string name = file.path().stem().string(), text = text_of(file.path());
    EXPECT_NE(text.find("using " + name + " = "), std::string::npos) << name;
    if (!std::regex_search(text, stiff_only)) with_odeint.insert(name);
    if (std::regex_search(text, nonstiff_only)) continue;
    for (const std::string& header : matches_in("cases/inlined/" + name + ".hpp", problem)) {
      // A header that stands in the tree says so; those that are printed from texts are plain
      // C++17.
      if (fs::exists(root / "cases" / header) &&
          text_of(root / "cases" / header).find("for odeint's rosenbrock4") == std::string::npos)
        continue;
      EXPECT_NE(rosenbrock4.find('"' + header + '"'), std::string::npos) << header;
      EXPECT_NE(runs.find('"' + header + '"'), std::string::npos) << header;
    }
  }
  EXPECT_EQ(inlined_list("ODEUM_INLINED_ODEINT"), with_odeint);
  EXPECT_GE(methods.size(), 10U);
  EXPECT_GE(with_odeint.size(), 3U);
}

// What runs in parallel takes the number of jobs that the user gave.
TEST(Rules, TheCommandLineAloneAsksForTheNumberOfCores) {
  std::vector<std::string> found;
  for (const std::string& file : sources_of(root, {"src/odeum", "adapters"}))
    if (text_of(root / file).find("hardware_concurrency") != std::string::npos)
      found.push_back(file);
  EXPECT_EQ(found, std::vector<std::string>{"src/odeum/cli/session.cpp"});
}

// What a study runs follows from what solvers say of themselves (SolverInfo), so that one that is
// added or taken away changes its own file alone.
TEST(Rules, NoStudyNamesASolverButForAReason) {
  const std::map<std::string, std::string> reasons{
      {"src/odeum/studies/spectrum.cpp", "measures with it, and compares it with nothing"},
      {"src/odeum/studies/evolution/measure.cpp", "each has its limit on both equations beside it"},
      {"src/odeum/studies/evolution/modes.cpp", "each has a closed form of what is predicted"},
      {"src/odeum/trajectories/report_replays.cpp", "each replay has a sentence on what it shows"}};
  const std::regex id("\"((?:odeum|gsl|odeint|cvode|arkode|bullet)/[a-z][a-z0-9_]*)\"");
  std::set<std::string> unused;
  for (const auto& [file, reason] : reasons) unused.insert(file);
  std::size_t read = 0;
  for (const std::string& file : sources_of(
           root, {"src/odeum/solvers", "src/odeum/judge", "src/odeum/scene", "src/odeum/report",
                  "src/odeum/studies", "src/odeum/trajectories", "src/odeum/cli"})) {
    ++read;
    for (const std::string& solver : matches_in(file, id)) {
      // The solvers of linear systems of a study, and of scenes without steps, are theirs alone.
      if (solver.starts_with("odeum/") && !is_own_method(solver.substr(6))) continue;
      unused.erase(file);
      EXPECT_TRUE(reasons.contains(file)) << file << " names " << solver;
    }
  }
  EXPECT_GE(read, 100U) << "the sources were not read";
  for (const std::string& file : unused)
    ADD_FAILURE() << file << " names no solver any more: take its reason out";
}

/// A checkout of a few files in a folder of its own.
class Checkout : public testing::Test {
 protected:
  void SetUp() override { fs::remove_all(folder_); }
  void TearDown() override { fs::remove_all(folder_); }
  void write(const std::string& file, const std::string& text) {
    fs::create_directories((folder_ / file).parent_path());
    std::ofstream(folder_ / file) << text;
  }
  std::vector<std::string> faults() {
    for (const char* folder : {"src", "adapters", "cases", "tests"})
      fs::create_directories(folder_ / folder);
    write(
        "CONTRIBUTING.md",
        "| `not/a/room` | x |\n## Rooms\n| folder | holds |\n|---|---|\n| `src/odeum/core` | x |\n"
        "| `cases` | x |\n| `src/odeum/studies/<name>` | x |\n## Other\n| `no/room` | x "
        "|\n");
    std::vector<std::string> lines;
    for (const Violation& each : upward_includes(folder_, rooms_of(folder_ / "CONTRIBUTING.md")))
      lines.push_back(each.file + ":" + std::to_string(each.line) + ": " + each.rule);
    return lines;
  }
  fs::path folder_ =
      fs::temp_directory_path() /
      (std::string("odeum_rules_") + testing::UnitTest::GetInstance()->current_test_info()->name());
};

TEST_F(Checkout, AnUpwardIncludeIsNamedWithFileLineAndRule) {
  write("src/odeum/core/low.hpp", "#pragma once\n#include \"odeum/studies/drift/rows.hpp\"\n");
  write("src/odeum/studies/drift/rows.hpp", "#include \"odeum/core/low.hpp\"\n#include <vector>\n");
  EXPECT_EQ(faults(),
            std::vector<std::string>{"src/odeum/core/low.hpp:2: src/odeum/core stands below "
                                     "src/odeum/studies/drift"});
}

TEST_F(Checkout, SiblingsDoNotIncludeOneAnother) {
  write("src/odeum/studies/drift/rows.hpp", "#include \"rows_too.hpp\"\n");
  write("src/odeum/studies/drift/rows_too.hpp", "");
  write("src/odeum/studies/limits/rows.hpp", "#include \"odeum/studies/drift/rows.hpp\"\n");
  EXPECT_EQ(faults(), std::vector<std::string>{
                          "src/odeum/studies/limits/rows.hpp:1: src/odeum/studies/limits and "
                          "src/odeum/studies/drift stand side by side"});
}

TEST_F(Checkout, SourcesIncludeNoCases) {
  write("cases/orbit.hpp", "");
  write("cases/orbit.cpp", "#include \"orbit.hpp\"\n");
  EXPECT_EQ(faults(), std::vector<std::string>{});
  write("src/odeum/studies/drift/rows.hpp", "#include \"orbit.hpp\"\n");
  EXPECT_EQ(faults(), std::vector<std::string>{
                          "src/odeum/studies/drift/rows.hpp:1: src includes from itself only"});
}

TEST_F(Checkout, AFolderOutsideOfTheTableIsNamed) {
  write("src/odeum/attic/old.hpp", "");
  ASSERT_EQ(faults().size(), 1U);
  EXPECT_TRUE(faults().front().starts_with("src/odeum/attic/old.hpp:1: lies in no room"));
}

TEST_F(Checkout, ALongFileIsFoundUnlessItHasAReason) {
  std::string text;
  for (int i = 0; i < 151; ++i) text += "int x;\n";
  faults();
  write("src/odeum/kernel/long.hpp", text);
  write("src/odeum/core/not_long.hpp", text);
  ASSERT_EQ(long_files(folder_).size(), 1U);
  write("src/odeum/kernel/long.hpp", "// long: a table\n" + text);
  EXPECT_TRUE(long_files(folder_).empty());
}

/// The names of the functions that are too long.
std::vector<std::string> long_names(const std::string& text) {
  std::vector<std::string> names;
  for (const Violation& each : long_functions_of("f", text)) names.push_back(each.key);
  return names;
}

TEST(LongFunctions, AreFoundWhateverStandsAround) {
  std::string body = "{\n";
  for (int i = 0; i < 59; ++i) body += "  if (x) { f('{', \"}\", R\"(}})\"); }  // }\n";
  body += "}\n";  // 61 lines
  const std::string shorter = "{\n" + body.substr(body.find('\n', 2) + 1);
  const std::string names = "namespace a {\nstruct B {\n";
  EXPECT_EQ(long_names("int g(int x = 1'000) " + body), std::vector<std::string>{"f g"});
  EXPECT_EQ(long_names("int g() " + shorter), std::vector<std::string>{});
  EXPECT_EQ(
      long_names(names + "#if X(1)\ntemplate <class T>\nint g(int x) const " + body + "};\n}"),
      std::vector<std::string>{"f g"});
  EXPECT_EQ(long_names("const auto g = [](int x) " + body), std::vector<std::string>{"f g"});
  EXPECT_EQ(long_names("struct alignas(8) B " + body), std::vector<std::string>{});
  EXPECT_EQ(long_names("int table[f(3)] = " + body), std::vector<std::string>{});
  EXPECT_EQ(long_names("int g() {\n// long: a list\n" + body + "}"), std::vector<std::string>{});
}

}  // namespace
}  // namespace odeum::rules::rules_test
