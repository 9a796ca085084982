// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/report/old_page.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <vector>

#include "odeum/report/gnuplot.hpp"
#include "support/report_fixture.hpp"

namespace odeum::report {
namespace {

namespace fs = std::filesystem;

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size())
    ++found;
  return found;
}

/// The first thing wrong with the nesting of a page's elements; empty where nothing is.
std::string broken_nesting(const std::string& html) {
  const std::vector<std::string> childless{"meta", "img", "br", "!DOCTYPE"};
  std::vector<std::string> open;
  std::size_t at = html.find("</style>");  // the style sheet is no markup
  open = {"html", "head", "style"};
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
      continue;
    }
    if (open.empty() || "/" + open.back() != tag) return "<" + tag + "> in the wrong place";
    open.pop_back();
  }
  return open.empty() ? "" : "<" + open.back() + "> stays open";
}

class Page : public testing::Test {
 protected:
  Page() {
    std::string name = (fs::temp_directory_path() / "odeum_page_test_XXXXXX").string();
    root_ = ::mkdtemp(name.data());
  }
  ~Page() override {
    if (!path_.empty()) ::setenv("PATH", path_.c_str(), 1);
    fs::remove_all(root_);
  }
  /// Until the end of the test the PATH is `folder` only.
  void search_only(const fs::path& folder) {
    path_ = ::getenv("PATH");
    ::setenv("PATH", folder.c_str(), 1);
  }
  std::string page_of(const ReportData& data) {
    const record::OutputFolder folder(root_ / "out");
    record::write(data.convergence, folder);
    write_page(data, folder);
    return read(folder.path() / "index.html");
  }
  /// The pages of the cases, one after the other.
  std::vector<std::string> case_pages() const {
    std::vector<std::string> pages;
    for (const auto& entry : fs::directory_iterator(root_ / "out" / "cases"))
      pages.push_back(read(entry.path()));
    return pages;
  }
  nlohmann::json manifest() const {
    return nlohmann::json::parse(read(root_ / "out" / "manifest.json"));
  }
  static bool gnuplot_is_there() {
    return !render({{.width = 100, .height = 100, .commands = "plot sin(x)"}}, 1).version.empty();
  }

  fs::path root_;

 private:
  std::string path_;
};

TEST_F(Page, TellsOfEveryCaseAndSolver) {
  search_only(root_);  // plots are another test's, and would take seconds
  const ReportData data = test::fabricate_report();
  const std::string html = page_of(data);
  EXPECT_EQ(broken_nesting(html), "");
  ASSERT_EQ(data.cases.size(), 15U);
  for (const CaseFacts& c : data.cases)
    EXPECT_NE(html.find("<code>" + c.id + "</code>"), std::string::npos) << c.id;
  for (const SolverInfo& solver : data.solvers)
    EXPECT_NE(html.find(">" + solver.method + "</th>"), std::string::npos) << solver.id();
  // Every pair is a cell with a title of the matrix: none is missing.
  EXPECT_EQ(
      count(html, "<td class=\"confirmed\" title=") + count(html, "<td class=\"higher\" title=") +
          count(html, "<td class=\"lower\" title=") + count(html, "<td class=\"floors\" title=") +
          count(html, "<td class=\"undetermined\" title=") +
          count(html, "<td class=\"failed\" title=") +
          count(html, "<td class=\"not_applicable\" title="),
      data.convergence.orders.size());
  EXPECT_NE(html.find("reference has a larger initial velocity field"), std::string::npos)
      << "findings";
}

TEST_F(Page, StandsAlone) {
  std::vector<std::string> pages{page_of(test::fabricate_small_report())};
  for (std::string& page : case_pages()) pages.push_back(std::move(page));
  ASSERT_EQ(pages.size(), 3U);
  for (const std::string& html : pages) {
    for (const char* external :
         {"<script", "<link", "<iframe", "src=\"http", "src=\"/", "url(http", "@import"})
      EXPECT_EQ(html.find(external), std::string::npos) << external;
    EXPECT_NE(html.find("prefers-color-scheme: dark"), std::string::npos);
  }
}

// The folder is opened from a disk: an address that does not lead to a file is a dead link.
TEST_F(Page, EveryAddressLeadsToAFile) {
  const std::string index = page_of(test::fabricate_small_report());
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
  check(index, root_ / "out");
  for (const std::string& html : case_pages()) check(html, root_ / "out" / "cases");
  EXPECT_GT(checked, 10U);
}

TEST_F(Page, CasesThatWouldShareAFileDoNot) {
  search_only(root_);
  ReportData data = test::fabricate_small_report();
  data.cases[0].id = "a/b";
  data.cases[1].id = "a?b";
  const std::string html = page_of(data);
  EXPECT_NE(html.find("href=\"cases/a_b.html\""), std::string::npos);
  EXPECT_NE(html.find("href=\"cases/a_b_2.html\""), std::string::npos);
  EXPECT_EQ(case_pages().size(), 2U);
}

TEST_F(Page, LinksToTheDataBesideIt) {
  const std::string html = page_of(test::fabricate_small_report());
  for (const char* name :
       {"convergence.csv", "convergence_times.csv", "orders.csv", "manifest.json"})
    EXPECT_NE(html.find("href=\"./" + std::string(name) + "\""), std::string::npos) << name;
}

TEST_F(Page, HasPlotsWhereGnuplotIsFound) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  const ReportData data = test::fabricate_small_report();
  const std::string html = page_of(data);
  EXPECT_EQ(broken_nesting(html), "");
  ASSERT_EQ(case_pages().size(), 2U);
  for (const std::string& page : case_pages()) {
    EXPECT_EQ(broken_nesting(page), "");
    EXPECT_GE(count(page, "<svg class=\"plot\""), 2U) << "by step and by cost at least";
    EXPECT_EQ(page.find("class=\"missing\""), std::string::npos);
  }
  EXPECT_EQ(count(html, " src=\"stability/"), data.stability.regions.size());
  EXPECT_EQ(html.find("class=\"missing\""), std::string::npos);
  EXPECT_TRUE(manifest()["plots"].get<std::string>().starts_with("drawn by gnuplot"));
}

TEST_F(Page, IsWrittenWithoutGnuplot) {
  search_only(root_);
  const std::string html = page_of(test::fabricate_small_report());
  EXPECT_EQ(broken_nesting(html), "");
  EXPECT_NE(html.find("no plots: gnuplot could not be run"), std::string::npos);
  EXPECT_EQ(count(html, "<svg class=\"plot\""), 0U);
  EXPECT_TRUE(manifest()["plots"].get<std::string>().starts_with("no plots: gnuplot could not"));
}

TEST_F(Page, SurvivesAGnuplotThatFails) {
  const fs::path program = root_ / "gnuplot";
  std::ofstream(program) << "#!/bin/sh\necho 'no \033[31mterminal' >&2\nexit 1\n";
  fs::permissions(program, fs::perms::owner_all);
  search_only(root_);
  const std::string html = page_of(test::fabricate_small_report());
  EXPECT_NE(html.find("gnuplot failed: no \xEF\xBF\xBD[31mterminal"), std::string::npos);
}

TEST_F(Page, PicturesBehindABadOneAreDrawn) {
  if (!gnuplot_is_there()) GTEST_SKIP() << "gnuplot is not installed";
  Picture good{.width = 100, .height = 100, .commands = "plot sin(x)"};
  Picture bad = good;
  bad.commands = "plot no_such_function(x)";
  const Rendering rendering = render({good, bad, good, bad, bad, good}, 2);
  for (const std::size_t i : {0, 2, 5})
    EXPECT_NE(rendering.images[i].find("</svg>"), std::string::npos);
  for (const std::size_t i : {1, 3, 4}) EXPECT_EQ(rendering.images[i], "");
  EXPECT_NE(rendering.problem, "");
}

TEST_F(Page, HostileTextStaysText) {
  const fs::path trap = root_ / "trap";
  const std::string hostile =
      "</script><img src=x onerror=alert(1)>\"'\x1b[31m\n\x01"
      "0\x02\xff`touch " +
      trap.string() + "`@{}";
  ReportData data = test::fabricate_small_report();
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
  for (CaseFacts& c : data.cases) c.id = c.title = c.equation = c.source = c.truth = hostile;
  for (SolverInfo& s : data.solvers)
    s.library = s.method = s.family = s.controller = s.needs = s.source = hostile;
  for (LibraryInfo& info : data.libraries) info.name = info.option = info.version = hostile;
  data.command_line = hostile;

  const std::string html = page_of(data);
  EXPECT_EQ(broken_nesting(html), "");
  EXPECT_GT(count(html, "&lt;/script&gt;&lt;img"), 20U) << "the text itself is shown";
  EXPECT_EQ(html.find("<img src=x"), std::string::npos);
  EXPECT_EQ(html.find_first_of("\x1b\x01\x02\xff"), std::string::npos);
  for (const std::string& page : case_pages()) {
    EXPECT_EQ(broken_nesting(page), "");
    EXPECT_EQ(page.find("<img src=x"), std::string::npos);
    EXPECT_EQ(page.find_first_of("\x1b\x01\x02\xff"), std::string::npos);
  }
  EXPECT_FALSE(fs::exists(trap)) << "gnuplot ran a command from a name";
  EXPECT_EQ(manifest()["command_line"].get<std::string>().find("</script>"), 0U);
}

TEST_F(Page, ToldOfNothingSaysSo) {
  const std::string html = page_of({});
  EXPECT_EQ(broken_nesting(html), "");
  EXPECT_NE(html.find("Not measured in this run."), std::string::npos);
  EXPECT_EQ(manifest()["plots"], "none to draw");
}

TEST_F(Page, RegionsWithoutResultsAreNotDrawn) {
  ReportData data = test::fabricate_small_report();
  ASSERT_GE(data.stability.regions.size(), 2U);
  std::fill(data.stability.regions[0].growth.begin(), data.stability.regions[0].growth.end(),
            std::numeric_limits<float>::quiet_NaN());
  data.stability.regions[0].detail = "every solve failed";
  data.stability.regions[1].growth.pop_back();
  data.stability.regions[1].detail = "the grid is not whole";
  const std::string html = page_of(data);
  EXPECT_NE(html.find("every solve failed"), std::string::npos);
  EXPECT_NE(html.find("the grid is not whole"), std::string::npos);
}

}  // namespace
}  // namespace odeum::report
