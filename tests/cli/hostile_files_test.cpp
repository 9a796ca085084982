// SPDX-License-Identifier: BSD-3-Clause
// Files that are made to do harm, of every kind that a command reads: each is refused with a
// sentence that names its place, with the exit code 2, and nothing of it is left in the working
// folder, the cache or the temporary folder.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::hostile_files_test {
namespace {

namespace fs = std::filesystem;

struct Hostile {
  std::string file, text, sentence;
  std::string command = "run";
};

const std::string rest = "equations: {x: -x}\ntime: {end: 1}\n";

std::string repeated(const std::string& text, int times) {
  std::string all;
  for (int k = 0; k < times; ++k) all += text;
  return all;
}

/// Aliases of aliases: a billion values if they were followed.
std::string alias_bomb() {
  std::string text = "a: &a [x, x, x, x, x, x, x, x, x]\n";
  for (char name = 'b'; name < 'k'; ++name)
    text += std::string(1, name) + ": &" + name + " [" +
            repeated("*" + std::string(1, static_cast<char>(name - 1)) + ", ", 9) + "]\n";
  return text + "states: {x: 1}\n" + rest;
}

std::vector<Hostile> hostile_files() {
  return {
      {"empty.yaml", "", ":1:1: scene: empty"},
      {"binary.yaml", std::string("\x00\x01\x02\xff", 4), ":1:1: scene: a binary file"},
      {"utf8.yaml", "states: {x: 1}\nname: \xff\xfe\n", ":2:7: problem: not UTF-8 text"},
      {"cut.yaml", "states: {x: 1", ":1:1: problem: not YAML"},
      {"itself.yaml", "a: &a [*a]\nstates: {x: 1}\n" + rest, ":1:4: problem: an anchor"},
      {"bomb.yaml", alias_bomb(), ":1:4: problem: an anchor"},
      {"deep.yaml", "states: " + repeated("[", 5000) + repeated("]", 5000), "nested too deeply"},
      {"brackets.yaml",
       "states: {x: 1}\nequations: {x: \"" + repeated("(", 20000) + "x" + repeated(")", 20000) +
           "\"}\ntime: {end: 1}\n",
       ": equations: x: nested too deeply"},
      {"long.yaml",
       "states: {x: 1}\nequations: {x: \"x" + repeated("*(1+x)", 20000) + "\"}\ntime: {end: 1}\n",
       ":2:17: equations: x: too long"},
      {"second.yaml", "states: {x: 1}\n" + rest + "---\nstates: {x: 2}\n",
       ":4:1: problem: a second document"},
      {"twice.yaml", "states: {x: 1}\nstates: {x: 2}\n" + rest, ":2:1: states: duplicate key"},
      {"nan.yaml", "states: {x: .nan}\n" + rest, ":1:13: states: x: not a number"},
      {"large.yaml", "states: {x: 1e999}\n" + rest, ":1:13: states: x: a number out of range"},
      {"end.yaml", "states: {x: 1}\nequations: {x: -x}\ntime: {end: .inf}\n", ":3:13: time: end"},
      {"timed.yaml", "states: {x: 1}\n" + rest + "case: {timed_stops: 0}\n",
       ":4:21: timed_stops: got 0, expected a time after 0"},
      {"scene.yaml",
       "particles: [{mass: 1, pos: [.nan, 0, 0]}]\nsolver: {type: rk4, timestep: 0.1}\n",
       ":1:29: particles[0].pos[0]: not finite"},
      {"folder.yaml", "", "got a directory, expected a file"},
      {"pipe.yaml", "", "got a FIFO, expected a file"},
      {"text.fmu", "hello", "is not a whole ZIP archive"},
      {"cut.fmu", "PK\x03\x04" + std::string(100, '\0'), "is not a whole ZIP archive"},
      {"tableau.yaml", "name: t\nA: [[0, .nan]]\nb: [1]\n", ":2:5: A[1]: got a list", "verify"},
      {"mesh.msh", "$MeshFormat\n4.1 0 8\n", ":3:1: the section: not understood", "poisson"},
  };
}

TEST(HostileFiles, AreRefusedWithTheirPlaceAndLeaveNothing) {
  const TemporaryFolder folder;
  const fs::path files = folder.path() / "files", place = folder.path() / "place";
  fs::create_directories(files / "folder.yaml");
  fs::create_directories(place);
  ASSERT_EQ(::mkfifo((files / "pipe.yaml").c_str(), 0600), 0);
  for (const Hostile& each : hostile_files()) {
    const fs::path file = files / each.file;
    if (!fs::exists(file)) write_text(file, each.text);
    const Result result = shell(fmt::format(
        "cd '{0}' && export HOME='{0}' TMPDIR='{0}' XDG_CACHE_HOME='{0}' && odeum {1} '{2}'",
        place.string(), each.command, file.string()));
    EXPECT_EQ(result.code, 2) << each.file << ": " << result.output;
    if (result.output.find("without FMI") != std::string::npos) continue;
    EXPECT_NE(result.output.find(each.file + ":"), std::string::npos) << result.output;
    EXPECT_NE(result.output.find(each.sentence), std::string::npos)
        << each.file << ": " << result.output;
    for (const auto& left : fs::recursive_directory_iterator(place))
      EXPECT_TRUE(left.is_directory()) << each.file << " left " << left.path();
  }
}

// A scene that could not be read was taken for a failed solver where only its solvers were asked
// for.
TEST(HostileFiles, OneThatCannotBeReadIsTwoForEveryCommand) {
  for (const std::string command : {"list solvers", "run", "why --solver rk4 --step 1", "verify"}) {
    const Result result = shell("odeum " + command + " nosuch.yaml");
    EXPECT_EQ(result.code, 2) << result.output;
    EXPECT_NE(result.output.find("cannot be read"), std::string::npos) << result.output;
  }
}

}  // namespace
}  // namespace odeum::tests::hostile_files_test
