// SPDX-License-Identifier: BSD-3-Clause
// A person's file is read once by a command, and makes one case.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/inotify.h>
#include <unistd.h>

#include <string>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/text_case.hpp"
#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::one_reading_test {
namespace {

const std::string text =
    "states: {x: 1, y: 0.5}\n"
    "parameters: {k: 0.1}\n"
    "equations: {x: -x*y + k, y: x - y}\n"
    "time: {end: 2}\n";

/// How often a file is opened while a shell command runs.
int openings_of(const std::string& file, const std::string& command) {
  const int watch = ::inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  EXPECT_GE(watch, 0);
  EXPECT_GE(::inotify_add_watch(watch, file.c_str(), IN_OPEN), 0);
  const Result result = shell(command);
  EXPECT_EQ(result.code, 0) << result.output;
  int count = 0;
  alignas(inotify_event) char events[1 << 14];
  for (ssize_t bytes = 0; (bytes = ::read(watch, events, sizeof events)) > 0;)
    for (ssize_t at = 0; at < bytes; ++count)
      at += static_cast<ssize_t>(sizeof(inotify_event) +
                                 reinterpret_cast<const inotify_event*>(events + at)->len);
  ::close(watch);
  return count;
}

TEST(OneReading, EachCommandOpensThePersonsFileOnce) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "my.yaml").string();
  write_text(file, text);
  for (const std::string command :
       {"run {} --solver rk4 --step 0.1", "run {}", "run {} --solver rk4 --step 0.1 --code",
        "list solvers {}", "verify {}", "why {} --solver rk4 --step 0.1 --seconds 600",
        "sweep {} --solver rk4 --step 0.1 --over k=0,1", "advise {} --error 1e-3 --seconds 600"})
    EXPECT_EQ(openings_of(file, fmt::format("export XDG_CACHE_HOME='{}' && odeum {}",
                                            folder.path().string(),
                                            fmt::format(fmt::runtime(command), file))),
              1)
        << command;
}

TEST(OneReading, TheTruthIsThatOfTheCaseThatRan) {
  const Statement statement = cases::text_statements("my.yaml", text, "my").front();
  Case c = case_before_truth(statement);
  std::vector<double> y(2);
  EXPECT_FALSE(c.truth.at(2, y.data()));
  const auto problem = c.problem.keep_alive;
  const auto start = c.problem.y0;
  complete(c);
  EXPECT_TRUE(c.truth.at(2, y.data()));
  EXPECT_EQ(c.problem.keep_alive, problem);
  EXPECT_EQ(c.problem.y0, start);
  EXPECT_FALSE(c.compute_truth);
}

}  // namespace
}  // namespace odeum::tests::one_reading_test
