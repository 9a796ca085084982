// SPDX-License-Identifier: BSD-3-Clause
// The decomposition of an error on schemes with known parts; and its files.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "odeum/studies/material/material.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::study {
namespace {

// Two particles; each part of the error moves the second along an axis of its own. RMS over two.
constexpr double model = 0.3, by_step = 5, by_iteration = 0.8;
const std::vector<double> truth{0, 0, 0, 1, 2, 3};

SplitPlan plan_of(double order) {
  SplitPlan plan;
  plan.steps = {10, 20, 40, 80};
  plan.tried = {{.sweeps = 1}, {.sweeps = 4}};
  plan.converged = {.sweeps = 1024};
  plan.half = {.sweeps = 512};
  plan.order = order;
  return plan;
}

RunCloth scheme(double order) {
  return [order](std::uint64_t steps, const Iterations& n, std::string&) {
    const double h = 0.25 / static_cast<double>(steps);
    std::vector<double> x = truth;
    x[3] += model;
    x[4] += by_step * std::pow(h, order);
    if (n.sweeps > 0) x[5] += by_iteration / std::pow(4.0, static_cast<double>(n.sweeps));
    return std::optional(x);
  };
}

TEST(ErrorParts, AreThoseOfAKnownScheme) {
  const double rms = 1 / std::sqrt(2.0), rounding = 1e-14;
  for (const double order : {1.0, 2.0}) {
    const auto rows = split_error(plan_of(order), scheme(order), truth);
    ASSERT_EQ(rows.size(), 8U);
    for (const ErrorPartsRow& row : rows) {
      const double step = by_step * std::pow(row.step, order),
                   iteration = by_iteration / std::pow(4.0, static_cast<double>(row.sweeps));
      EXPECT_EQ(row.status, "ok");
      EXPECT_NEAR(row.iteration, rms * iteration, rounding);
      EXPECT_NEAR(row.time_step, rms * step, rounding);
      EXPECT_NEAR(row.model, rms * model, rounding);
      EXPECT_NEAR(row.total, rms * std::hypot(model, step, iteration), rounding);
      EXPECT_NEAR(row.step_left, 0, rounding);
      EXPECT_NEAR(row.iteration_left, 0, rounding);
    }
  }
}

TEST(ErrorParts, TellHowFarALimitIsOff) {
  // Extrapolated as of order 1, a scheme of order 2 does not reach its limit.
  for (const ErrorPartsRow& row : split_error(plan_of(1), scheme(2), truth)) {
    EXPECT_GT(row.step_left, 1e-6);
    // At N/2, N, 2N the extrapolations miss by -2 and -1/2 of the finest error.
    const double finest = by_step * std::pow(0.25 / 80, 2) / std::sqrt(2.0);
    EXPECT_NEAR(row.step_left, 6 * finest, 1e-12);
  }
}

TEST(ErrorParts, HaveNoIterationsWhereNoneAreCounted) {
  SplitPlan plan = plan_of(1);
  plan.tried = {{}};
  plan.converged = plan.half = {};
  int runs = 0;
  const RunCloth counted = [&](std::uint64_t steps, const Iterations& n, std::string& reason) {
    ++runs;
    return scheme(1)(steps, n, reason);
  };
  for (const ErrorPartsRow& row : split_error(plan, counted, truth)) EXPECT_EQ(row.iteration, 0);
  EXPECT_EQ(runs, 4) << "one for each number of steps";
}

TEST(ErrorParts, SayWhereARunFailed) {
  const RunCloth coarse_fails = [](std::uint64_t steps, const Iterations& n, std::string& reason) {
    reason = "blew up";
    return steps == 10 ? std::nullopt : scheme(1)(steps, n, reason);
  };
  const auto rows = split_error(plan_of(1), coarse_fails, truth);
  EXPECT_EQ(rows[0].status, "unstable");
  EXPECT_EQ(rows[0].detail, "blew up");
  EXPECT_TRUE(std::isnan(rows[0].total));
  EXPECT_NEAR(rows[2].model, model / std::sqrt(2.0), 1e-14) << "its limit needs the finest three";
  const RunCloth fine_fails = [](std::uint64_t steps, const Iterations& n, std::string& reason) {
    reason = "blew up";
    return steps == 80 ? std::nullopt : scheme(1)(steps, n, reason);
  };
  const auto limitless = split_error(plan_of(1), fine_fails, truth);
  EXPECT_EQ(limitless[0].status, "ok");
  EXPECT_NE(limitless[0].detail.find("no limit"), std::string::npos);
  EXPECT_TRUE(std::isnan(limitless[0].model));
}

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

MaterialResult made_up() {
  MaterialResult result;
  MaterialRow row;
  row.scene = "one_mass";
  row.library = "bullet";
  row.solver = "soft_body_links";
  row.status = "unmeasured";
  row.detail = "gone, \"within\" a step";
  row.step = 1.0 / 60;
  row.sweeps = 4;
  row.vibrating = 0.1;
  result.material = {row};
  result.errors = split_error(plan_of(1), scheme(1), truth);
  for (ErrorPartsRow& each : result.errors) each.library = "odeum", each.solver = "scheme";
  LongRunRow course;
  course.status = "ok";
  course.value = 1e-300;
  result.long_run = {course};
  result.cost = {{.side = 512, .precision = "f32", .wall_ns_min = 7.5, .conditions = {}}};
  ImplicitWinsRow wins;
  wins.engine = "verlet_f32";
  wins.status = "ok";
  result.implicit_wins = {wins};
  return result;
}

TEST(MaterialCsv, HasTheColumnsAndReadsBackToTheSame) {
  const tests::TemporaryFolder root;
  const record::OutputFolder folder(root.path() / "out");
  const MaterialResult result = made_up();
  write_csv(result, folder);
  const auto starts = [&](const char* file, const char* header) {
    EXPECT_EQ(text_of(folder.path() / file).rfind(header, 0), 0U)
        << text_of(folder.path() / file).substr(0, 200);
  };
  starts("material.csv",
         "schema,scene,library,solver,status,step,sweeps,newton,phase,resting,vibrating,damping,"
         "added_damping_ratio,detail\n");
  starts("material_error.csv",
         "schema,library,solver,status,time,step,sweeps,newton,total,iteration,time_step,model,"
         "iteration_left,step_left,detail\n");
  starts("cloth_long.csv",
         "schema,scene,library,solver,status,setting_kind,setting,time,quantity,value,exact,"
         "detail\n");
  starts("cloth_cost.csv",
         "schema,side,precision,wall_ns_min,wall_ns_median,repetitions,drift,"
         "processor_share,measured\n");
  starts("implicit_wins.csv",
         "schema,stiffness,frame,engine,status,step,wall_ns_min,wall_ns_median,repetitions,error,"
         "truth_left,drift,processor_share,measured,detail\n");
  const MaterialResult back = read_material_csv(folder.path());
  EXPECT_EQ(back.problem, "");
  const record::OutputFolder again(root.path() / "again");
  write_csv(back, again);
  for (const char* file : {"material.csv", "material_error.csv", "cloth_long.csv", "cloth_cost.csv",
                           "implicit_wins.csv"})
    EXPECT_EQ(text_of(folder.path() / file), text_of(again.path() / file)) << file;
  ASSERT_EQ(back.material.size(), 1U);
  EXPECT_EQ(back.material[0].detail, result.material[0].detail);
  EXPECT_TRUE(std::isnan(back.material[0].resting));
}

TEST(MaterialCsv, ToleratesWhatItCannotUse) {
  const tests::TemporaryFolder root;
  const record::OutputFolder folder(root.path() / "out");
  EXPECT_TRUE(read_material_csv(folder.path()).empty());
  EXPECT_EQ(read_material_csv(folder.path()).problem, "") << "missing is no problem";
  write_csv(made_up(), folder);
  const std::string whole = text_of(folder.path() / "material.csv");
  struct Spoilt {
    std::string text;
    const char* problem;
  };
  for (const auto& [text, problem] :
       {Spoilt{whole.substr(0, whole.size() - 40), "truncated"},
        Spoilt{"schema,step\n1,2\n", "other columns"}, Spoilt{"x" + whole, "other columns"}}) {
    folder.write("material.csv", text);
    const MaterialResult back = read_material_csv(folder.path());
    EXPECT_TRUE(back.material.empty());
    EXPECT_NE(back.problem.find(problem), std::string::npos) << back.problem;
    EXPECT_FALSE(back.errors.empty()) << "the other files are as good as before";
  }
}

}  // namespace
}  // namespace odeum::study
