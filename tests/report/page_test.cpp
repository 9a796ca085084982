// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/page.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>
#include <vector>

#include "support/report_fixture.hpp"

namespace odeum::report {
namespace {

namespace fs = std::filesystem;
using test::count;
using test::has;
using test::MadeUp;
using test::Report;

/// The first thing wrong with the nesting of the elements of pages; empty where nothing is.
std::string broken_nesting(const std::string& html) {
  const std::vector<std::string> childless{"meta", "img", "br", "!DOCTYPE"};
  std::vector<std::string> open;
  std::size_t at = 0;
  while ((at = html.find('<', at)) != std::string::npos) {
    const auto end = html.find('>', at);
    if (end == std::string::npos) return "a tag that does not end";
    const std::string tag = html.substr(at + 1, end - at - 1);
    const std::string name = tag.substr(0, tag.find_first_of(" \t\n/", 1));
    at = end;
    if (tag.back() == '/' || std::find(childless.begin(), childless.end(), name) != childless.end())
      continue;
    if (tag.front() != '/') {
      open.push_back(name);
      if (name == "style") at = html.find("</style>", at) - 1;  // the style sheet is no markup
      continue;
    }
    if (open.empty() || "/" + open.back() != tag) return "<" + tag + "> in the wrong place";
    open.pop_back();
  }
  return open.empty() ? "" : "<" + open.back() + "> stays open";
}

nlohmann::json manifest_of(const Report& report) {
  return nlohmann::json::parse(tests::text_of(report.folder().path() / "manifest.json"));
}

/// index.html and the pages of all cases.
std::vector<std::string> pages_of(Report& report, const MadeUp& data) {
  std::vector<std::string> pages{report.index()};
  for (std::size_t i = 0; i < data.facts.cases.size(); ++i) pages.push_back(report.case_page(i));
  return pages;
}

TEST(Page, TellsOfEveryCaseAndSolver) {
  const MadeUp data = test::fabricate_report();
  const std::string html = Report(data).index();
  EXPECT_EQ(broken_nesting(html), "");
  ASSERT_EQ(data.facts.cases.size(), 15U);
  for (const CaseFacts& c : data.facts.cases)
    EXPECT_TRUE(has(html, "<code>" + c.id + "</code>")) << c.id;
  for (const SolverInfo& solver : data.facts.solvers)
    EXPECT_TRUE(has(html, ">" + solver.method + "</th>")) << solver.id();
  // Every pair is a cell with a title of the matrix: none is silently absent.
  std::size_t cells = 0;
  for (const auto& style : verdict_styles)
    cells += count(html, std::string("<td class=\"") + to_string(style.verdict) + "\" title=");
  EXPECT_EQ(cells, data.convergence.orders.size());
  EXPECT_TRUE(has(html, "<section id=\"findings\""));
}

TEST(Page, HasSectionsInTheOrderOfTheirPlaces) {
  const tests::TemporaryFolder root;
  const record::OutputFolder folder(root.path() / "out");
  Page page(Facts(), folder);
  page.section({.id = "late", .title = "Late <b>", .place = 20, .html = "<p>2</p>"});
  page.section({.id = "early", .title = "Early", .place = 10, .html = "<p>1</p>"});
  page.section({.id = "later", .title = "Later", .place = 20, .html = "", .short_title = "Short"});
  page.write({});
  EXPECT_TRUE(has(tests::text_of(folder.path() / "index.html"),
                  "<a href=\"early.html\">Early</a><a href=\"late.html\">Late &lt;b&gt;</a>"
                  "<a href=\"later.html\">Short</a>"));
  const std::string late = tests::text_of(folder.path() / "late.html");
  EXPECT_TRUE(has(late, "<section id=\"late\">\n<h2>Late &lt;b&gt;</h2>\n<p>2</p>"));
  EXPECT_TRUE(has(late, "<a href=\"late.html\" aria-current=\"page\">"));
}

TEST(Page, StandsAlone) {
  const MadeUp data = test::fabricate_small_report();
  Report report(data);
  for (const std::string& html : pages_of(report, data)) {
    for (const char* external : {"<script>", "<link", "<iframe", "src=\"http", "src=\"/",
                                 "url(http", "@import", " onclick="})
      EXPECT_FALSE(has(html, external)) << external;
    EXPECT_EQ(count(html, "<script"),
              count(html, "<script src=\"data/") + count(html, "<script src=\"viewer/"));
    EXPECT_EQ(count(html, "<html"), count(html, "script-src 'self' file:; base-uri 'none'"));
    EXPECT_TRUE(has(html, "prefers-color-scheme: dark"));
  }
}

// The folder is opened from a disk: an address that does not lead to a file is a dead link.
TEST(Page, EveryAddressLeadsToAFile) {
  const MadeUp data = test::fabricate_small_report();
  Report report(data);
  record::write(data.convergence, report.folder());
  std::size_t checked = 0;
  const auto check = [&](const std::string& html, const fs::path& folder) {
    for (const std::string attribute : {" href=\"", " src=\""})
      for (std::size_t at = 0; (at = html.find(attribute, at)) != std::string::npos;) {
        at += attribute.size();
        const std::string address = html.substr(at, html.find_first_of("\"#", at) - at);
        if (address.empty() || address.starts_with("http")) continue;
        EXPECT_TRUE(fs::exists(folder / address)) << address;
        ++checked;
      }
  };
  const fs::path root = report.folder().path();
  const std::string index = report.index();
  check(index, root);
  for (std::size_t i = 0; i < data.facts.cases.size(); ++i)
    check(report.case_page(i), root / "cases");
  EXPECT_GT(checked, 10U);
  for (const char* name :
       {"convergence.csv", "convergence_times.csv.gz", "orders.csv", "manifest.json"})
    EXPECT_TRUE(has(index, "href=\"./" + std::string(name) + "\"")) << name;
}

TEST(Page, CasesThatWouldShareAFileDoNot) {
  MadeUp data = test::fabricate_small_report();
  data.facts.cases[0].id = "a/b";
  data.facts.cases[1].id = "a?b";
  Report report(data);
  const std::string html = report.index();
  EXPECT_TRUE(has(html, "href=\"cases/a_b.html\""));
  EXPECT_TRUE(has(html, "href=\"cases/a_b_2.html\""));
  EXPECT_TRUE(has(report.case_page(1), "<code>a?b</code>"));
}

TEST(Page, HasChartsAndPictures) {
  const MadeUp data = test::fabricate_small_report();
  Report report(data);
  const std::vector<std::string> pages = pages_of(report, data);
  for (const std::string& page : pages) {
    EXPECT_EQ(broken_nesting(page), "");
    EXPECT_FALSE(has(page, "class=\"missing\"") && !has(page, "Not measured in this run"));
  }
  for (std::size_t i = 1; i < pages.size(); ++i)
    EXPECT_GE(count(pages[i], "<svg class=\"plot\""), 2U) << "by step and by cost at least";
  EXPECT_EQ(count(pages[0], " src=\"stability/"), data.stability.regions.size());
}

TEST(Page, HostileTextStaysText) {
  const std::string hostile =
      "</script><img src=x onerror=alert(1)>\"'\x1b[31m\n\x01"
      "0\x02\xff@{}";
  MadeUp data = test::fabricate_small_report();
  const auto rename = [&](auto& rows) {
    for (auto& row : rows) row.library = row.solver = row.case_id = hostile;
  };
  rename(data.convergence.rows);
  rename(data.convergence.times);
  rename(data.convergence.orders);
  for (auto& row : data.convergence.rows) row.detail = row.status = hostile;
  for (auto& row : data.convergence.orders) row.fit.reason = hostile;
  for (auto& limit : data.stability.limits)
    limit.library = limit.solver = limit.status = limit.detail = hostile;
  for (auto& region : data.stability.regions) region.library = region.solver = hostile;
  for (CaseFacts& c : data.facts.cases) c.id = c.title = c.equation = c.source = c.truth = hostile;
  for (SolverInfo& s : data.facts.solvers)
    s.library = s.method = s.family = s.controller = s.needs = s.source = hostile;
  for (LibraryInfo& info : data.facts.libraries) info.name = info.option = info.version = hostile;

  Report report(data);
  const std::string html = report.index({.command_line = hostile});
  EXPECT_GT(count(html, "&lt;/script&gt;&lt;img"), 20U) << "the text itself is shown";
  for (const std::string& page : {html, report.case_page(0), report.case_page(1)}) {
    EXPECT_EQ(broken_nesting(page), "");
    EXPECT_FALSE(has(page, "<img src=x"));
    EXPECT_EQ(page.find_first_of("\x1b\x01\x02\xff"), std::string::npos);
  }
  report.index({.command_line = hostile});
  EXPECT_EQ(manifest_of(report)["command_line"].get<std::string>().find("</script>"), 0U);
}

TEST(Page, ToldOfNothingSaysSo) {
  const std::string html = Report(MadeUp()).index();
  EXPECT_EQ(broken_nesting(html), "");
  EXPECT_TRUE(has(html, "Not measured in this run"));
}

TEST(Page, RegionsWithoutResultsAreNotDrawn) {
  MadeUp data = test::fabricate_small_report();
  ASSERT_GE(data.stability.regions.size(), 2U);
  std::fill(data.stability.regions[0].growth.begin(), data.stability.regions[0].growth.end(),
            std::numeric_limits<float>::quiet_NaN());
  data.stability.regions[0].detail = "every solve failed";
  data.stability.regions[1].growth.pop_back();
  data.stability.regions[1].detail = "the grid is not whole";
  const std::string html = Report(data).index();
  EXPECT_TRUE(has(html, "every solve failed"));
  EXPECT_TRUE(has(html, "the grid is not whole"));
}

TEST(Manifest, SaysWithWhatAndWhatWasSkipped) {
  const MadeUp data = test::fabricate_report();
  Report report(data);
  report.index({.command_line = "odeum report", .seconds = 123.4});
  const auto m = manifest_of(report);
  EXPECT_EQ(m["schema"], 2);
  EXPECT_EQ(m["odeum"]["version"], "0.1.0");
  EXPECT_NE(m["build"]["compiler"], "");
  EXPECT_NE(m["cpu"], "");
  EXPECT_EQ(m["options"]["quick"], false);
  EXPECT_EQ(m["seconds"], 123.4);
  ASSERT_EQ(m["libraries"].size(), 4U);
  EXPECT_EQ(m["libraries"][0]["version"], "6.4.1");
  EXPECT_EQ(m["libraries"][3]["version"], nullptr);
  EXPECT_EQ(m["libraries"][3]["option"], "ODEUM_WITH_BULLET");
  const std::string date = m["date"];
  EXPECT_EQ(date.size(), std::string("2025-01-01T00:00:00Z").size());
  const auto unfit = [](const auto& row) { return row.status == "not_applicable"; };
  const auto pairs =
      std::count_if(data.convergence.rows.begin(), data.convergence.rows.end(), unfit);
  const auto limits =
      std::count_if(data.stability.limits.begin(), data.stability.limits.end(), unfit);
  ASSERT_EQ(m["skipped"]["not_applicable"].size(), 1U);
  EXPECT_EQ(m["skipped"]["not_applicable"][0]["pairs"], pairs);
  EXPECT_EQ(m["skipped"]["rows_by_status"]["not_applicable"], pairs + limits);
  EXPECT_EQ(m["verdicts"].back()["pairs"], data.convergence.orders.size());
}

}  // namespace
}  // namespace odeum::report
