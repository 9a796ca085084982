// SPDX-License-Identifier: BSD-3-Clause
// The parts of `odeum verify`: coefficients as text, the reader, the conditions, the interpreter.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "odeum/proof/verify.hpp"
#include "odeum/tableau/order_conditions.hpp"
#include "odeum_methods.hpp"

namespace odeum::tests {
namespace {

double value_of(const std::string& text) { return parse_coefficient(text).value.get_d(); }

TEST(Coefficient, ReadsWhatPeopleWrite) {
  EXPECT_EQ(parse_coefficient("2/9").exact, mpq_class(2, 9));
  EXPECT_EQ(parse_coefficient("-3/4").exact, mpq_class(-3, 4));
  EXPECT_EQ(parse_coefficient("0.25").exact, mpq_class(1, 4));
  EXPECT_EQ(parse_coefficient("1e-3").exact, mpq_class(1, 1000));
  EXPECT_EQ(parse_coefficient("sqrt(4/9)").exact, mpq_class(2, 3));
  EXPECT_FALSE(parse_coefficient("sqrt(2)").rational);
  EXPECT_DOUBLE_EQ(value_of("(2 - sqrt(2))/2"), (2 - std::sqrt(2.)) / 2);
  EXPECT_EQ(parse_coefficient("0.25").uncertainty, 0);  // short decimals are meant as they stand
  EXPECT_DOUBLE_EQ(parse_coefficient("0.333333333333333").uncertainty,
                   0.5e-15);  // 15 digits: rounded
}

TEST(Coefficient, RefusesWhatIsNoNumber) {
  for (const char* text : {"", ".", ".nan", "nan", "inf", "1,5", "010", "1/0", "sqrt(-1)", "1e999",
                           "1e", "2 3", "(1", "0x10", "1e-999", "--1", "1e10"})
    EXPECT_THROW(parse_coefficient(text), CoefficientError) << text;
}

std::string error_of(const std::string& yaml) {
  try {
    read_tableau("t.yaml", yaml);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(TableauReader, NamesThePlaceOfAFault) {
  struct Fault {
    const char *yaml, *says;
  };
  for (const auto& [yaml, says] : {
           Fault{"A: [[]]\nb: [x]\n", "t.yaml:2:5: b[1]: not a number; got x, expected a number"},
           Fault{"A: [[]]\nb: [1]\nb: [1]\n",
                 "t.yaml:3:1: b: duplicate key; the first is in line 2"},
           Fault{"A: [[]]\nb: [.nan]\n", "t.yaml:2:5: b[1]: not a number"},
           Fault{"A: [[]]\nb: [010]\n", "a leading zero"},
           Fault{"A: [[]]\nb: [1]\n---\nA: [[]]\n", "a second document"},
           Fault{"a: &x [*x]\n", "an anchor"},
           Fault{"A: [[]]\nb: [1, 2]\n", "got a list of 2, expected a list of 1"},
           Fault{"A: [[1, 2]]\nb: [1]\n", "t.yaml:1:5: A[1]: got a list of 2"},
           Fault{"A: [[]]\nb: [1]\nordre: 1\n", "did you mean order?"},
           Fault{"A: [[]]\nb: [1]\norder: 1.5\n", "got 1.5, expected a whole number from 1 to 10"},
           Fault{"A: [[]]\nb: [1]\norder_embedded: 1\n", "claim without the row"},
           Fault{"b: [1]\n", "A: missing"},
           Fault{"[1, 2]", "got a list of 2, expected a mapping with A and b"},
           Fault{"", "t.yaml:1:1: tableau: empty"},
           Fault{"A: [\n", "not YAML"},
           Fault{"A: \x01\n", "t.yaml:1:4: tableau: a binary file or a control character"},
           Fault{"A: [[[[[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]]]]]", "nested too deeply"},
       })
    EXPECT_NE(error_of(yaml).find(says), std::string::npos) << yaml << "\n-> " << error_of(yaml);
  EXPECT_THROW(read_tableau_file("/nonexistent.yaml"), InputError);
  EXPECT_THROW(read_tableau_file("/"), InputError);
}

TableauFile tableau_of(const std::string& yaml) { return read_tableau("t.yaml", yaml); }

const char* const heun_euler =
    "order: 2\norder_embedded: 1\nc: [0, 1]\nA: [[], [1]]\nb: [1/2, 1/2]\nb_hat: [1, 0]\n";

TEST(Verify, ProvesAndMeasuresBothRows) {
  const proof::Verification v = proof::verify(tableau_of(heun_euler));
  EXPECT_TRUE(v.passed());
  EXPECT_EQ(v.main.order, 2);
  EXPECT_EQ(v.main.tree, "[[τ]]");
  EXPECT_EQ(v.main.residual, "-1/6");  // sum b_i a_ij c_j = 0 where 1/6 is due, exactly
  EXPECT_EQ(v.embedded.order, 1);
  EXPECT_EQ(v.embedded.residual, "-1/2");
  EXPECT_NEAR(v.real_limit, 2, 1e-9);  // |1 + z + z^2/2| = 1 at z = -2
  EXPECT_EQ(v.imaginary_limit, 0);
  EXPECT_EQ(v.measured.size(), 6U);
}

TEST(Verify, FailsWhatIsNotReached) {
  EXPECT_FALSE(proof::verify(tableau_of("order: 3\nA: [[], [1]]\nb: [1/2, 1/2]\n")).passed());
  // A coefficient off by 1e-12 is off: fractions have no rounding.
  const proof::Verification off = proof::verify(
      tableau_of("order: 2\nA: [[], [1000000000001/1000000000000]]\nb: [1/2, 1/2]\n"));
  EXPECT_EQ(off.main.order, 1);
  EXPECT_FALSE(off.passed());
  // Nodes that contradict the row sums: the conditions hold, the non-autonomous run shows it.
  const proof::Verification nodes =
      proof::verify(tableau_of("order: 2\nc: [0, 1/2]\nA: [[], [1]]\nb: [1/2, 1/2]\n"));
  EXPECT_EQ(nodes.main.order, 2);
  ASSERT_EQ(nodes.nodes.size(), 1U);
  EXPECT_EQ(nodes.nodes[0].stage, 2U);
  EXPECT_TRUE(nodes.measured[1].agrees);
  EXPECT_FALSE(nodes.measured[2].agrees);
  EXPECT_FALSE(nodes.passed());
}

TEST(Verify, RootsAndRoundedDecimalsAreNotTakenForFaults) {
  const TableauFile sdirk2 = tableau_of(
      "order: 2\nA: [[1 - sqrt(1/2)], [sqrt(1/2), 1 - sqrt(1/2)]]\n"
      "b: [sqrt(1/2), 1 - sqrt(1/2)]\n");
  EXPECT_FALSE(sdirk2.exact());
  const proof::Verification v = proof::verify(sdirk2);
  EXPECT_TRUE(v.passed());
  EXPECT_TRUE(v.stability.l_stable());
  const proof::Verification rounded = proof::verify(
      tableau_of("order: 3\nA: [[], [0.5], [-1, 2]]\n"
                 "b: [0.1666666666666667, 0.6666666666666667, 0.1666666666666667]\n"));
  EXPECT_EQ(rounded.main.order, 3);
}

TEST(RowOrder, AgreesWithTheConditionsAtCompileTime) {
  int rows = 0;
  methods::All::for_each([&]<class M>() {
    if constexpr (requires { dynamic_tableau(M::tableau); }) {
      const auto t = dynamic_tableau(M::tableau);
      // The order that static_assert(proven(...)) in the method's file holds each row to.
      EXPECT_EQ(order_of_row(t, t.b, double_rounding).order, t.order) << M::info.id;
      if (t.embedded()) {
        EXPECT_EQ(order_of_row(t, t.b_hat, double_rounding).order, t.order_hat) << M::info.id;
      }
      ++rows;
    }
  });
  EXPECT_GE(rows, 9);
}

TEST(RootedTreesAtRunTime, AreAsManyAsThereAre) {
  // A000081: 1, 1, 2, 4, 9, 20, 48, 115, 286, 719 trees with 1 to 10 nodes.
  EXPECT_EQ(all_rooted_trees().size(), 1205U);
  EXPECT_EQ(bracket_notation(0), "τ");
  EXPECT_EQ(bracket_notation(1), "[τ]");
  std::set<std::string> names;
  for (std::size_t i = 0; i < all_rooted_trees().size(); ++i) names.insert(bracket_notation(i));
  EXPECT_EQ(names.size(), 1205U);
}

}  // namespace
}  // namespace odeum::tests
