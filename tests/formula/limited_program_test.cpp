// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/limited_program.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/temporary_folder.hpp"

namespace odeum::formula::limited_program_test {
namespace {

// A compiler that is ended leaves its temporary files: they stand beside the log, in the folder
// that is removed with all that is in it.
TEST(LimitedProgram, HasItsTemporaryFilesBesideTheLog) {
  const tests::TemporaryFolder folder;
  const std::filesystem::path log = folder.path() / "log";
  const std::vector<std::string> command{"/bin/sh", "-c", "echo > \"$TMPDIR/left\"; kill -9 $$"};
  EXPECT_EQ(run_limited(command, log, 10), "failed");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "left"));
  EXPECT_EQ(run_limited({"/bin/sh", "-c", "test \"$TMPDIR\" = '" + folder.path().string() + "'"},
                        log, 10),
            "");
}

}  // namespace
}  // namespace odeum::formula::limited_program_test
