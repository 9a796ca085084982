// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/core/machine.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <utility>

#include "support/temporary_folder.hpp"

namespace odeum::tests::machine_test {
namespace {

#if defined(__linux__) && defined(__x86_64__)
// Debian's SUNDIALS was timed against optimised methods without a word.
TEST(Machine, TellsByItsCodeWhetherALibraryWasOptimised) {
  const TemporaryFolder folder;
  const std::string source = (folder.path() / "some.c").string();
  std::ofstream(source) << "double f(double *x, int n) { double s = 0;\n"
                           "for (int i = 0; i < n; ++i) s += x[i]; return s; }\n"
                           "int g(int a, int b) { return a * b; }\n"
                           "double h(double a) { return f(&a, g(1, 1)); }\n";
  for (const auto& [option, expected] : {std::pair{"-O0", "without optimisation"},
                                         {"-O2", "with optimisation"},
                                         {"-O3 -fno-omit-frame-pointer", "with optimisation"}}) {
    const std::string library = (folder.path() / "some.so").string();
    std::string command = "cc -shared -fPIC ";
    command.append(option).append(" -o ").append(library).append(" ").append(source);
    if (std::system(command.c_str()) != 0) GTEST_SKIP() << "needs a C compiler";
    EXPECT_EQ(how_compiled(library), expected) << option;
  }
  EXPECT_EQ(how_compiled(source), "");
  EXPECT_EQ(how_compiled((folder.path() / "missing.so").string()), "");
}
#endif

}  // namespace
}  // namespace odeum::tests::machine_test
