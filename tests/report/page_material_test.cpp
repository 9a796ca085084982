// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/material/section.hpp"

#include <gtest/gtest.h>

#include "support/report_fixture.hpp"

namespace odeum::study {
namespace {

using test::has;

study::MaterialRow links(double step, std::uint64_t sweeps, double ratio) {
  study::MaterialRow row;
  row.scene = "hanging_chain";
  row.library = "bullet";
  row.solver = "soft_body_links";
  row.status = "ok";
  row.step = step;
  row.sweeps = sweeps;
  row.static_stiffness_ratio = row.dynamic_stiffness_ratio = ratio;
  row.added_damping_ratio = 0.25;
  return row;
}

TEST(PageMaterial, SaysWhereNothingWasMeasured) {
  const std::string page =
      test::Report(test::fabricate_small_report().facts)
          .add(MaterialResult(),
               {.command = "material", .problem = "the material.csv that was there is <cut> off"})
          .index();
  EXPECT_TRUE(has(page, "<section id=\"material\">"));
  EXPECT_TRUE(has(page, "href=\"material.html\""));
  EXPECT_TRUE(has(page, "is &lt;cut&gt; off"));
  EXPECT_TRUE(has(page, "<code>odeum material</code> with this folder"));
}

TEST(PageMaterial, ShowsStiffnessByStepAndIterations) {
  std::vector<study::MaterialRow> rows{links(1.0 / 30, 0, 0.2), links(1.0 / 60, 0, 1.01),
                                       links(1.0 / 30, 4, 1340), links(1.0 / 60, 4, 1)};
  rows[3].static_stiffness_ratio = study::not_measured;
  rows[3].detail = "gone <within> a step";
  const std::string html = response_tables(rows);
  EXPECT_TRUE(has(html, "<th>1/30 s</th><th>1/60 s</th>"));
  EXPECT_TRUE(has(html, "bullet/soft_body_links, 4 iterations"));
  EXPECT_TRUE(has(html, ">0.2×</td>"));
  EXPECT_TRUE(has(html, "class=\"t-3\"")) << "five times too soft";
  EXPECT_TRUE(has(html, ">1340×</td>"));
  EXPECT_TRUE(has(html, ">+0.25</td>"));
  EXPECT_TRUE(has(html, "gone &lt;within&gt; a step"));
  EXPECT_TRUE(response_tables({}).empty());
}

TEST(PageMaterial, MarksALimitThatIsNotReached) {
  study::ErrorPartsRow row;
  row.library = "bullet";
  row.solver = "soft_body_links_stock";
  row.status = "ok";
  row.time = 0.25;
  row.step = 0.0125;
  row.total = 0.4;
  row.iteration = 0.1;
  row.time_step = 0.02;
  row.model = 0.5;
  row.iteration_left = 0.001;
  row.step_left = 0.05;
  const std::string html = error_parts_table({row});
  EXPECT_TRUE(has(html, "<b>0.4</b>"));
  EXPECT_TRUE(has(html, ">0.1</td>"));
  EXPECT_TRUE(has(html, ">≲ 0.05</td>"));
  EXPECT_TRUE(has(html, "<td class=\"t2\" title=\"its limit is known to 0.05 m\">0.5</td>"));
}

TEST(PageMaterial, ColoursImplicitBySpeedAndTellsItsError) {
  const auto row = [](double frame, const char* engine, double ns, double error) {
    study::ImplicitWinsRow made;
    made.stiffness = 1e4;
    made.frame = frame;
    made.engine = engine;
    made.status = "ok";
    made.step = 1e-4;
    made.wall_ns_min = ns;
    made.wall_ns_median = 1.1 * ns;
    made.rk4_distance = error;
    made.rk4_left = 1e-6;
    made.conditions = {.drift = 0.4, .processor_share = 1, .measured = "2026-01-01T00:00:00Z"};
    return made;
  };
  const std::string html = implicit_wins_table({row(study::not_measured, "verlet_f32", 6e7, 4e-4),
                                                row(study::not_measured, "imex_f32", 3e7, 2e-4),
                                                row(1.0 / 60, "implicit_f64", 6e6, 0.25),
                                                row(1.0 / 240, "implicit_f64", 9e7, 0.125)});
  EXPECT_TRUE(has(html, "imex_f32, h = ")) << "the fastest explicit one";
  EXPECT_TRUE(has(html, "<td class=\"confirmed\""));
  EXPECT_TRUE(has(html, ">5×, 0.25 m</td>"));
  EXPECT_TRUE(has(html, "<td class=\"lower\""));
  EXPECT_TRUE(has(html, "⚠ disturbed"));
}

TEST(PageMaterial, ShowsTheLongRunBesideItsReference) {
  std::vector<study::LongRunRow> rows;
  for (const char* quantity : {"energy", "drape", "lowest"}) {
    study::LongRunRow row;
    row.scene = "hanging";
    row.library = "bullet";
    row.solver = "soft_body_links";
    row.status = "ok";
    row.setting_kind = "step";
    row.setting = 1.0 / 240;
    row.time = 10;
    row.quantity = quantity;
    row.value = 12.5;
    row.reference = 10.25;
    rows.push_back(row);
  }
  study::LongRunRow ended = rows.front();
  ended.scene = "free";
  ended.status = "newton_failed";
  ended.detail = "at <once>";
  rows.push_back(ended);
  const std::string html = long_run_table(rows);
  EXPECT_TRUE(has(html, "bullet/soft_body_links, h = 1/240 s"));
  EXPECT_TRUE(has(html, "<td>10.25</td>"));
  EXPECT_TRUE(has(html, "<td class=\"t2\">12.5</td>")) << "a fifth too much";
  EXPECT_TRUE(has(html, "at &lt;once&gt;"));
}

TEST(PageMaterial, ShowsCostAgainstTheCheapestSize) {
  const std::string html = cloth_cost_table({{.side = 64,
                                              .precision = "f64",
                                              .wall_ns_min = 15,
                                              .wall_ns_median = 16,
                                              .repetitions = 3,
                                              .conditions = {0.01, 0.99, "2026-01-01T00:00:00Z"}},
                                             {.side = 512,
                                              .precision = "f64",
                                              .wall_ns_min = 30,
                                              .wall_ns_median = 31,
                                              .repetitions = 3,
                                              .conditions = {0.01, 0.99, "2026-01-01T00:00:00Z"}}});
  EXPECT_TRUE(has(html, "<td>30.0 ns (31.0)</td>"));
  EXPECT_TRUE(has(html, ">2.00×</td>"));
  EXPECT_TRUE(has(html, "undisturbed"));
}

}  // namespace
}  // namespace odeum::study
