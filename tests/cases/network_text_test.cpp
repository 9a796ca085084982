// SPDX-License-Identifier: BSD-3-Clause
// A network of BioNetGen becomes a text; scripts/networks compares trajectories.
#include "odeum/cases/network_text.hpp"

#include <gtest/gtest.h>

#include "odeum/formula/problem.hpp"

namespace odeum::network_text_test {
namespace {

std::string network(const std::string& reactions, const std::string& groups = "") {
  return R"(begin parameters
  1 k 2 # Constant
  2 A_tot 2*k
end parameters
begin functions
  1 f() k*B_tot/(1+exp(-time))
end functions
begin species
  1 A(b,c~U) A_tot
  2 $B() 1e1
  3 @cell::$C() 3
  4 D() 1
end species
begin reactions
)" + reactions +
         "\nend reactions\nbegin groups\n" + groups + "\nend groups\n";
}

std::string fault(const std::string& text) {
  try {
    formula::read_problem("text", cases::text_of_network("n.net", text, 1));
    return "";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Networks, SpeciesReactionsFunctionsAndGroups) {
  const formula::Problem p = formula::read_problem(
      "text", cases::text_of_network("n.net",
                                     network("  1 1,2 4,2 0.5*k #r\n  2 4 1,1 f() #s\n  3 0 1 3\n"
                                             "  4 4,1 1 Sat k 5 #t",
                                             "  1 A_tot 1,2*4\n  2 B_tot 2"),
                                     1));
  EXPECT_EQ(p.states, (std::vector<std::string>{"s1", "D"}));
  EXPECT_EQ(p.y0, (std::vector<long double>{4, 1}));
  const double y[] = {3, 2};
  double f[2], out[3];
  formula::Evaluator<double>(p.graph, p.equations)(0, y, f);
  // The group A_tot has the name of a parameter, which is meant in expressions.
  const double first = 0.5 * 2 * 3 * 10, second = 2 * 10 / 2. * 2, third = 2. / (5 + 2) * 2 * 3;
  EXPECT_DOUBLE_EQ(f[0], -first + 2 * second + 3);
  EXPECT_DOUBLE_EQ(f[1], first - second - third);
  ASSERT_EQ(p.outputs.size(), 3U);
  EXPECT_EQ(p.outputs[0].name, "A_tot");
  formula::Evaluator<double>(p.graph, {p.outputs[0].value, p.outputs[1].value, p.outputs[2].value})(
      0, y, out);
  EXPECT_EQ(out[0], 3 + 2 * 2);
  EXPECT_EQ(out[1], 10);
  EXPECT_EQ(out[2], 10);
}

TEST(Networks, ASpeciesWithoutAReactionStaysAsItIs) {
  const formula::Problem p = formula::read_problem(
      "text", cases::text_of_network("n.net", network("  1 1 0 k", "  1 B_tot 2"), 1));
  const double y[] = {3, 2};
  double f[2];
  formula::Evaluator<double>(p.graph, p.equations)(0, y, f);
  EXPECT_EQ(f[0], -6);
  EXPECT_EQ(f[1], 0);
}

TEST(Networks, FaultsHaveTheirLine) {
  EXPECT_EQ(fault(network("  1 1 4 k", "  1 B_tot 2")), "");
  const auto expect = [](const std::string& text, const std::string& begin,
                         const std::string& part) {
    const std::string got = fault(text);
    EXPECT_TRUE(got.starts_with(begin) && got.find(part) != std::string::npos)
        << "got       " << got << "\nexpected  " << begin << " ... " << part;
  };
  expect(network("  1 1 9 k", "  1 B_tot 2"), "n.net:15:1:", "not a species; got 9");
  expect(network("  1 1 4 Hill k 2 3", "  1 B_tot 2"),
         "n.net:15:1:", "the rate Hill is not supported");
  expect(network("  1 1 4", "  1 B_tot 2"), "n.net:15:1:", "got 2 words");
  expect(network("  1 1 4 mratio(1,2,3)", "  1 B_tot 2"), "n.net:15:1:", "mratio is not supported");
  expect(network("  1 1 4 k"), "text:", "unknown name; got B_tot");
  expect("begin species\nend species\n", "n.net:1:1:", "no block of reactions");
}

// A word that is not a name was given another ending for ever.
TEST(Networks, ANameThatIsNoneIsMadeOne) {
  std::string text = network("  1 1 4 k", "  1 B_tot 2");
  text.insert(text.find("begin parameters\n") + 17, "  ! 2 E0 10\n");
  EXPECT_NE(cases::text_of_network("n.net", text, 1).find("\"n2\": \"E010\""), std::string::npos);
}

}  // namespace
}  // namespace odeum::network_text_test
