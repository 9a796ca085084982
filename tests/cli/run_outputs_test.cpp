// SPDX-License-Identifier: BSD-3-Clause
// odeum run with outputs and without.
#include <gtest/gtest.h>

#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests {
namespace {

// The amplification of errors was measured up to each of 500 outputs, for a hundred times as long
// as the run took, and the answer was another one than without outputs.
TEST(RunOutputs, AreNotJudged) {
  const TemporaryFolder folder;
  const auto answer = [&](const std::string& more) {
    const std::string text =
        shell("odeum run fput_alpha --solver dormand_prince853 --tol 1e-6 --no-truth" + more)
            .output;
    const std::size_t at = text.find("answer  ");
    return at == std::string::npos ? text : text.substr(at, text.find('\n', at) - at);
  };
  const std::string alone = answer("");
  EXPECT_EQ(alone.find("answer  explained"), 0U) << alone;
  EXPECT_EQ(answer(" --out " + folder.path().string()), alone);
}

}  // namespace
}  // namespace odeum::tests
