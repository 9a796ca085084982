// SPDX-License-Identifier: BSD-3-Clause
// The forms in which programs write trajectories, and the place of what is wrong in them.
#include <gtest/gtest.h>

#include "odeum/brought/trajectory.hpp"
#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/text_case.hpp"
#include "odeum/input/yaml_tree.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::tests::table_file_test {
namespace {

Case case_of_text(const std::string& text) {
  return case_of(cases::text_statements("my.yaml", text, "oscillator", {}).front());
}

class Files : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    write_text(folder_.path() / name, text);
    return (folder_.path() / name).string();
  }
  brought::Trajectory read(const std::string& name, const std::string& text,
                           const std::vector<std::string>& columns = {}) const {
    brought::Reading reading;
    for (const std::string& column : columns) reading.columns.push_back(brought::column_of(column));
    return brought::read_trajectory(c_, file(name, text), reading, 0);
  }
  /// What is wrong, without the folder.
  std::string fault_of(const std::string& text,
                       const std::vector<std::string>& columns = {}) const {
    try {
      read("f", text, columns);
      return "";
    } catch (const InputError& error) {
      const std::string what = error.what(), path = (folder_.path() / "f").string();
      return what.starts_with(path) ? what.substr(path.size()) : what;
    }
  }

  const Case c_ = case_of_text("states: {q: 1, v: 0}\nequations: {q: v, v: -q}\ntime: {end: 4}\n");
  const TemporaryFolder folder_;
};

// Three rows each, of q = 1, 0.5, 0.25 and v = 0, -1, -2 at t = 0, 1, 2.
TEST_F(Files, AreReadInEveryFormThatProgramsWrite) {
  const std::vector<std::string> texts{
      "t,q,v\n0,1,0\n1,0.5,-1\n2,0.25,-2\n",
      "\xEF\xBB\xBFTime [s],Q,V\r\n0,1,0\r\n1,0.5,-1\r\n2,0.25,-2\r\n",
      "# made by hand\n# t q v\n0 1 0\n 1  0.5 -1\n2\t0.25 -2",
      "\"time (s)\";\"v(t)\";\"q(t)\"\n0;0;1\n1,0;-1,0;0,5\n2,0;-2,0;0,25\n",
      "0\t1\t0\n1\t+5e-1\t-1\n2\t2.5E-1\t-2\n",
      "% comment\nstep,time,q,v,energy\n0,0,1,0,9\n1,1,.5,-1,9\n2,2,.25,-2,9\n",
      // An event: the state after it stands for its time.
      "t,q,v\n0,1,0\n1,7,7\n1,0.5,-1\n2,0.25,-2\n"};
  for (const std::string& text : texts) {
    const brought::Trajectory run = read("f", text);
    ASSERT_EQ(run.times, (std::vector<double>{0, 1, 2})) << text;
    EXPECT_EQ(run.states, (std::vector<double>{1, 0, 0.5, -1, 0.25, -2})) << text;
    EXPECT_TRUE(run.is_whole(c_));
    EXPECT_EQ(run.step, 1);
  }
  const brought::Trajectory mapped =
      read("f", "a,b,c\n0,1000,0\n1000,500,-1\n2000,250,-2\n", {"t=a*0.001", "q=2*1e-3", "v=c"});
  EXPECT_EQ(mapped.times, (std::vector<double>{0, 1, 2}));
  EXPECT_EQ(mapped.states[2], 0.5);
  const brought::Trajectory part = read("f", "t,q\n0,1\n1,0.5\n");
  EXPECT_EQ(part.components, std::vector<std::size_t>{0});
  EXPECT_FALSE(part.is_whole(c_));
}

TEST_F(Files, HaveTheStepThatTheirNamesSay) {
  const std::string rows = "t,q,v\n0,1,0\n1,0.5,-1\n2,0.25,-2\n";
  EXPECT_EQ(read("euler_h0.5.csv", rows).step, 0.5);
  EXPECT_EQ(read("euler_h0.5.csv", rows).steps_a_row, 2U);
  EXPECT_EQ(read("euler_h0.5.csv", rows).series, "euler");
  EXPECT_EQ(read("dt=1e-1.csv", rows).steps_a_row, 10U);
  EXPECT_EQ(read("rk4_n8.csv", rows).step, 0.25);
  // A name that is not a step.
  EXPECT_EQ(read("hydrogen2.csv", rows).step, 1);
  EXPECT_EQ(read("euler_h0.7.csv", rows).remarks.size(), 1U);
}

TEST_F(Files, SayHowManyDigitsAreWritten) {
  const brought::TableFile fixed =
      brought::read_table(file("f", "t,x,y\n0,1.000,123.456\n1,0.125,0.001\n"));
  EXPECT_DOUBLE_EQ(fixed.columns[1].half_place(1), 0.0005);
  EXPECT_DOUBLE_EQ(fixed.columns[2].half_place(123.456), 0.0005);
  const brought::TableFile significant =
      brought::read_table(file("f", "t,x\n0,1.23457e+03\n1,1.5\n"));
  EXPECT_DOUBLE_EQ(significant.columns[1].half_place(1234.57), 0.005);
  EXPECT_DOUBLE_EQ(significant.columns[1].half_place(1.5), 5e-6);
  // Doubles as Python prints them: a short one is exact, too.
  const brought::TableFile doubles =
      brought::read_table(file("f", "t,x\n0,0.5\n1,0.30000000000000004\n"));
  EXPECT_LT(doubles.columns[1].half_place(0.5), 1e-16);
}

/// What NumPy's save() writes of doubles.
std::string npy(std::size_t rows, std::size_t columns, const std::vector<double>& numbers,
                const std::string& descr = "<f8") {
  std::string header = "{'descr': '" + descr + "', 'fortran_order': False, 'shape': (" +
                       std::to_string(rows) + ", " + std::to_string(columns) + "), }";
  header.resize(118 - 1, ' ');
  header += '\n';
  return std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size()) + '\0' + header +
         std::string(reinterpret_cast<const char*>(numbers.data()), 8 * numbers.size());
}

TEST_F(Files, MayBeArraysOfNumPyAndTheirTransposes) {
  EXPECT_EQ(read("f.npy", npy(3, 3, {0, 1, 0, 1, 0.5, -1, 2, 0.25, -2})).states,
            (std::vector<double>{1, 0, 0.5, -1, 0.25, -2}));
  const brought::Trajectory turned =
      read("f.npy", npy(3, 4, {0, 1, 2, 3, 1, 0.5, 0.25, 0, 0, -1, -2, -3}));
  EXPECT_EQ(turned.times, (std::vector<double>{0, 1, 2, 3}));
  EXPECT_EQ(turned.states, (std::vector<double>{1, 0, 0.5, -1, 0.25, -2, 0, -3}));
  EXPECT_NE(fault_of(npy(3, 3, {0, 1, 0})).find("24 bytes for 3 x 3 numbers"), std::string::npos);
  EXPECT_NE(fault_of(npy(3, 3, {}, "<c16")).find("expected real numbers"), std::string::npos);
  EXPECT_NE(fault_of(npy(1'000'000'000'000, 3, {})).find("larger than the file"),
            std::string::npos);
  EXPECT_NE(fault_of("\x93NUMPY").find("cut short"), std::string::npos);
}

TEST_F(Files, NameTheLineAndTheColumnOfAFault) {
  EXPECT_EQ(fault_of("t,q,v\n0,1,0\n1,a,0\n"), ":3:3: got a, expected a number");
  EXPECT_EQ(fault_of("t,q,v\n0,1,0\n1,,0\n"), ":3:3: got an empty cell, expected a number");
  EXPECT_EQ(fault_of("t,q,v\n0,1,0\n1,2\n"),
            ":3:1: got 2 numbers, expected 3, as in the lines before");
  EXPECT_EQ(fault_of("t,q,v\n0,1,0\n2,1,0\n1,1,0\n"),
            ":4:1: got the time 1 after 2, expected times that ascend");
  EXPECT_EQ(fault_of("t,q,v\n0,1,0\nnan,1,0\n"),
            ":3:1: got the time nan after 0, expected times that ascend");
  EXPECT_NE(fault_of("").find("got 0 rows of numbers"), std::string::npos);
  EXPECT_NE(fault_of("t,q,v\n0,1,0\n0,1,0\n").find("got one time in all rows"), std::string::npos);
  EXPECT_NE(fault_of("a,b\n0,1\n1,2\n").find("the components of oscillator are q, v"),
            std::string::npos);
  EXPECT_NE(fault_of("t,q,v\n0,1,0\n1,1,0\n", {"q=z"}).find("has no column z; expected t, q, v"),
            std::string::npos);
  EXPECT_NE(fault_of("t,q,v\n0,1,0\n1,1,0\n", {"x=q"}).find("has no component x"),
            std::string::npos);
  for (const char* wrong : {"q", "=q", "q=", "q=v*", "q=v*0", "q=v*x"})
    EXPECT_THROW(brought::column_of(wrong), InputError) << wrong;
}

}  // namespace
}  // namespace odeum::tests::table_file_test
