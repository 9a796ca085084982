// SPDX-License-Identifier: BSD-3-Clause
// Commands on texts with constraints: what they say, and states that jump.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::constraint_commands_test {
namespace {

class ConstrainedText {
 public:
  explicit ConstrainedText(const std::string& text) { write_text(folder_.path() / "c.yaml", text); }
  Result run(const std::string& words) const {
    return shell("cd '" + folder_.path().string() +
                 "' && export XDG_CACHE_HOME=$PWD && odeum run c.yaml " + words);
  }
  nlohmann::json row(const std::string& words) const {
    const Result result = run("--format json --no-truth " + words + " 2>/dev/null");
    return nlohmann::json::parse(result.output).at("runs").at(0);
  }

 private:
  TemporaryFolder folder_;
};

TEST(ConstraintCommands, SayIndexAndDrift) {
  const ConstrainedText text(
      "states: {x: 1, y: 0, u: 0, v: 0, lambda: ~}\n"
      "equations: {x: u, y: v, u: -lambda*x, v: -lambda*y - 9.81}\n"
      "constraints: [x^2 + y^2 - 1]\ntime: {end: 1}\n");
  const std::string words = "--solver rk4 --step 0.01 ";
  const nlohmann::json alone = text.row(words), kept = text.row(words + "--option projection=1");
  EXPECT_GT(alone.at("constraint_drift"), 1e-9);
  EXPECT_GT(alone.at("hidden_drift"), 1e-9);
  EXPECT_LT(kept.at("constraint_drift"), 1e-14);
  const std::string said = alone.at("remarks");
  EXPECT_NE(said.find("constraints of index 3: the run is at most "), std::string::npos) << said;
  EXPECT_NE(said.find("--option projection=1 keeps both"), std::string::npos) << said;
  EXPECT_NE(text.run("").output.find("index      3: 1 constraint"), std::string::npos);
  const Result code = text.run(words + "--option projection=1 --code");
  EXPECT_EQ(code.code, 2) << code.output;
  EXPECT_EQ(text.run("--solver cvode/bdf --tol 1e-6 --option projection=1").code, 2);
}

// x = t, and z jumps from 0 to 1 at t = 1/2; its rate is zero on both sides. A run along rates left
// it at 0 with status ok, and so did the truth.
TEST(ConstraintCommands, StatesThatJumpAreNotLeftBehind) {
  for (const char* condition : {"x > 0.5", "t > 0.5"}) {
    const ConstrainedText text(
        std::string("states: {x: 0, z: ~}\nequations: {x: 1}\nconstraints: ['z - if(") + condition +
        ", 1, 0)']\ntime: {end: 1}\n");
    const nlohmann::json alone = text.row("--solver dormand_prince54 --tol 1e-6");
    EXPECT_EQ(alone.at("status"), "refused");
    for (const char* words : {"--solver dormand_prince54 --tol 1e-6 --option projection=1",
                              "--solver rk4 --step 0.01 --option projection=1",
                              "--solver radau_iia5_residual --tol 1e-6"}) {
      const nlohmann::json kept = text.row(words);
      EXPECT_EQ(kept.at("status"), "ok") << words << kept;
      EXPECT_NEAR(kept.at("states").back().at("y").at("z"), 1, 1e-12) << words;
    }
    const std::string said = text.run("--solver rk4 --step 0.01 --option projection=1").output;
    EXPECT_NE(said.find("jumps where 0.5 - "), std::string::npos) << said;
    EXPECT_NE(said.find("error   unknown: no truth at t = 1"), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace odeum::tests::constraint_commands_test
