// SPDX-License-Identifier: BSD-3-Clause
// Results that are kept between runs: by the program, not by its name or place.
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>
#include <string>

#include "support/program.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::kept_results_test {
namespace {

namespace fs = std::filesystem;

class Kept : public testing::Test {
 protected:
  /// How many results a program took from the store, and how many it has.
  struct Count {
    std::size_t taken = 0, all = 0;
    bool operator==(const Count&) const = default;
  };

  Count run(const fs::path& program, const std::string& arguments) const {
    const Result result = shell("XDG_CACHE_HOME='" + (folder_.path() / "cache").string() + "' '" +
                                program.string() + "' converge free_fall --quick --jobs 1 " +
                                arguments + " --out '" + (folder_.path() / "out").string() + "'");
    EXPECT_EQ(result.code, 0) << result.output;
    std::smatch found;
    const std::regex sentence("reused ([0-9]+) of ([0-9]+) results from");
    if (!std::regex_search(result.output, found, sentence)) return {};
    return {std::stoul(found[1]), std::stoul(found[2])};
  }
  /// The program with these bytes after its own, which change nothing that it does.
  fs::path copy_with(const std::string& more) const {
    // The program looks for libraries beside its folder, and results are kept by these, too.
    const fs::path copy = folder_.path() / "bin" / ("odeum" + more);
    fs::create_directories(copy.parent_path());
    std::error_code there;
    fs::create_directory_symlink(fs::path(ODEUM_BINARY).parent_path().parent_path() / "lib",
                                 folder_.path() / "lib", there);
    write_text(copy, text_of(ODEUM_BINARY) + more);
    fs::permissions(copy, fs::perms::owner_all);
    return copy;
  }

  TemporaryFolder folder_;
};

TEST_F(Kept, ByTheBytesOfTheProgram) {
  EXPECT_EQ(run(ODEUM_BINARY, "--solver rk4"), (Count{0, 0}));
  EXPECT_EQ(run(copy_with(""), "--solver rk4"), (Count{2, 2})) << "the same program elsewhere";
  EXPECT_EQ(run(copy_with("!"), "--solver rk4"), (Count{0, 0})) << "another program";
}

TEST_F(Kept, ByPairWhateverElseIsAskedFor) {
  EXPECT_EQ(run(ODEUM_BINARY, "--solver rk4"), (Count{0, 0}));
  EXPECT_EQ(run(ODEUM_BINARY, "--solver rk4 heun"), (Count{2, 4}));
}

}  // namespace
}  // namespace odeum::tests::kept_results_test
