// SPDX-License-Identifier: BSD-3-Clause
// The parts of `odeum verify`: coefficients as text, the reader, the conditions, the interpreter.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "odeum/proof/verify.hpp"
#include "odeum/tableau/order_conditions.hpp"
#include "odeum_methods.hpp"

namespace odeum::tests::verify_test {
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
           Fault{"[1, 2]", "tableau: not a mapping; got a list of 2"},
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

/// Dormand and Prince's pair, with b_hat = b + share (b_hat - b).
std::string dormand_prince(const mpq_class& share) {
  const char* const b[] = {"35/384", "0", "500/1113", "125/192", "-2187/6784", "11/84", "0"};
  const char* const b_hat[] = {"5179/57600",    "0",        "7571/16695", "393/640",
                               "-92097/339200", "187/2100", "1/40"};
  std::string text =
      "order: 5\norder_embedded: 4\nA:\n  - []\n  - [1/5]\n  - [3/40, 9/40]\n"
      "  - [44/45, -56/15, 32/9]\n  - [19372/6561, -25360/2187, 64448/6561, -212/729]\n"
      "  - [9017/3168, -355/33, 46732/5247, 49/176, -5103/18656]\n"
      "  - [35/384, 0, 500/1113, 125/192, -2187/6784, 11/84]\n";
  std::string row = "b: [", row_hat = "b_hat: [";
  for (int i = 0; i < 7; ++i) {
    const mpq_class difference = mpq_class(b_hat[i]) - mpq_class(b[i]);
    const mpq_class scaled = mpq_class(b[i]) + share * difference;
    row += std::string(i ? ", " : "") + b[i];
    row_hat += std::string(i ? ", " : "") + scaled.get_str();
  }
  return text + row + "]\n" + row_hat + "]\n";
}

proof::Verification verified(const std::string& yaml, std::string& text) {
  const TableauFile file = tableau_of(yaml);
  proof::Verification v = proof::verify(file);
  text = v.text(file);
  return v;
}

TEST(Verify, SaysWhatTheAuthorsOfAPairLookAt) {
  std::string text;
  const proof::Verification v = verified(dormand_prince(1), text);
  EXPECT_TRUE(v.passed());
  // Dormand and Prince, J. Comput. Appl. Math. 6 (1980) 19-26: A = 3.99e-4.
  EXPECT_NEAR(v.quality.principal_error, 3.99e-4, 1e-6);
  EXPECT_NEAR(v.quality.embedded_principal_error, 1.18e-3, 1e-5);
  EXPECT_NEAR(v.quality.next_term_ratio, 1.54, 0.01);
  EXPECT_NEAR(v.quality.difference_ratio, 1.67, 0.01);
  EXPECT_NEAR(v.quality.largest_coefficient, 11.6, 0.01);
  EXPECT_NEAR(v.quality.rows_ratio, v.quality.principal_error / v.quality.embedded_principal_error,
              1e-12);
  EXPECT_TRUE(v.quality.remarks().empty());
  EXPECT_NE(text.find("B = 1.54, C = 1.67, E = 0.337"), std::string::npos) << text;
  // One and a half times the difference is not a fault, but it shows.
  const proof::Verification more = verified(dormand_prince(mpq_class(33, 20)), text);
  EXPECT_TRUE(more.passed());
  EXPECT_NEAR(more.quality.embedded_principal_error / v.quality.embedded_principal_error, 1.65,
              1e-9);
}

TEST(Verify, AnEstimateOfAnUnusualSizeIsRemarkedOn) {
  std::string text;
  const proof::Verification large = verified(dormand_prince(1'000'000), text);
  EXPECT_TRUE(large.passed());
  EXPECT_NE(text.find("passed, with 1 remark"), std::string::npos) << text;
  // The running row shows the next order: its leading term is too small to be seen.
  const proof::Verification small = verified(dormand_prince(mpq_class(1, 1000)), text);
  EXPECT_TRUE(small.passed());
  EXPECT_NE(text.find("too small to be seen"), std::string::npos) << text;
  EXPECT_GT(small.quality.rows_ratio, 100);
  EXPECT_FALSE(small.quality.remarks().empty());
}

TEST(Verify, APairThatIsBlindIsRemarkedOn) {
  // b and b_hat share the weights of the nodes 0 and 1: no difference where f depends on t alone.
  std::string text;
  const proof::Verification v = verified(
      "order: 2\norder_embedded: 1\nA: [[], [1], [0, 1]]\nb: [1/2, 1/2, 0]\nb_hat: [1/2, 0, "
      "1/2]\n",
      text);
  EXPECT_NE(text.find("no estimate on quadrature"), std::string::npos) << text;
  EXPECT_EQ(v.embedded.order, 2);
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
  EXPECT_EQ(all_rooted_trees.count, 1205U);
  EXPECT_EQ(bracket_notation(0), "τ");
  EXPECT_EQ(bracket_notation(1), "[τ]");
  std::set<std::string> names;
  for (std::size_t i = 0; i < all_rooted_trees.count; ++i) names.insert(bracket_notation(i));
  EXPECT_EQ(names.size(), 1205U);
}

}  // namespace
}  // namespace odeum::tests::verify_test
