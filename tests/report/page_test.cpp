// SPDX-License-Identifier: BSD-3-Clause
// A report's folder: page.json, manifest.json, index.html. How it looks is tested in tests/viewer.
#include "odeum/report/report.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>

#include "odeum/core/machine.hpp"
#include "support/full_disk.hpp"
#include "support/report_fixture.hpp"

namespace odeum::report::page_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::has;
using test::MadeUp;
using test::Report;

std::vector<std::string> names_of(const json& list, const char* key = "name") {
  std::vector<std::string> names;
  for (const json& entry : list) names.push_back(entry[key]);
  return names;
}

std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(Page, TellsOfEveryCaseSolverAndRow) {
  const MadeUp data = test::fabricate_report();
  Report report(data);
  const json page = report.write().json("page.json");
  ASSERT_EQ(data.facts.cases.size(), 15U);
  ASSERT_EQ(page["cases"].size(), 15U);
  ASSERT_EQ(page["solvers"].size(), data.facts.solvers.size());
  for (std::size_t i = 0; i < 15; ++i) EXPECT_EQ(page["cases"][i]["id"], data.facts.cases[i].id);
  for (std::size_t i = 0; i < data.facts.solvers.size(); ++i)
    EXPECT_EQ(page["solvers"][i]["method"], data.facts.solvers[i].method);
  EXPECT_EQ(names_of(page["tables"]),
            (std::vector<std::string>{"convergence", "convergence_times", "orders",
                                      "stability_limits", "stability_regions", "stability_steps"}));
  EXPECT_EQ(report.table("orders")["rows"], data.convergence.orders.size());
  EXPECT_EQ(report.table("orders")["columns"].size(), record::fields_of(study::OrderRow()).size());
  EXPECT_EQ(report.column("orders", "verdict").size(), data.convergence.orders.size());
}

// A page that shows one case does not load the rows of all.
TEST(Page, RowsOfALargeFileAreKeptCaseByCase) {
  const MadeUp data = test::fabricate_report();
  ASSERT_GT(data.convergence.rows.size(), 5000U);
  Report report(data);
  const json parts = report.write().table("convergence")["parts"];
  std::map<std::string, std::size_t> rows;
  for (const study::ConvergenceRow& row : data.convergence.rows) ++rows[row.case_id];
  ASSERT_EQ(parts.size(), rows.size());
  for (const json& part : parts) {
    const std::string id = part["case"];
    EXPECT_EQ(part["rows"], rows.at(id));
    const json columns =
        tests::unpacked(report.text("data/" + part["data"].get<std::string>() + ".js"));
    EXPECT_EQ(columns["case"]["words"], json::array({id}));
    EXPECT_EQ(columns["error_max"].size(), rows.at(id));
  }
  EXPECT_EQ(report.table("convergence")["cases"].size(), rows.size());
}

TEST(Page, StudiesStandInTheOrderOfTheirPlacesWithTheirTexts) {
  Report report{Facts()};
  report.report().study({.name = "late", .command = "late", .help = "<b>", .place = 20});
  report.report().study({.name = "mesh", .command = "mesh", .help = "", .place = 10});
  report.report().study({.name = "later", .command = "later", .help = "", .place = 20});
  const json studies = report.write().json("page.json")["studies"];
  EXPECT_EQ(names_of(studies), (std::vector<std::string>{"mesh", "late", "later"}));
  EXPECT_EQ(studies[1]["pages"].size(), 0U) << "it has no folder of texts";
  ASSERT_GE(studies[0]["pages"].size(), 1U);
  EXPECT_EQ(studies[0]["pages"][0]["id"], "mesh");
  EXPECT_EQ(studies[0]["pages"][0]["text"],
            tests::text_of(ODEUM_SOURCE_DIR "/src/odeum/studies/mesh/page.md"));
}

// The folder may be moved and is opened from a disk: each address in it leads to a file of it.
TEST(Page, StandsAlone) {
  const MadeUp data = test::fabricate_small_report();
  Report report(data);
  record::write(data.convergence, report.folder());
  record::write(data.stability, report.folder());
  const record::Records rows{{"a"}}, alone{{"b"}, {{1.0}}};
  report.report().table("convergence", "none.csv", rows);
  report.report().table("convergence", "alone", alone);
  report.write();
  const std::string index = report.text("index.html");
  std::size_t checked = 0;
  for (const std::string attribute : {" href=\"", " src=\""})
    for (std::size_t at = 0; (at = index.find(attribute, at)) != std::string::npos;) {
      at += attribute.size();
      const std::string address = index.substr(at, index.find_first_of("\"#", at) - at);
      if (address.empty()) continue;
      EXPECT_TRUE(fs::path(address).is_relative()) << address;
      EXPECT_TRUE(fs::exists(report.folder().path() / address)) << address;
      ++checked;
    }
  EXPECT_GT(checked, 20U);
  EXPECT_TRUE(has(index, "script-src 'self' file:;"));
  EXPECT_TRUE(has(index, "default-src 'none'"));
  EXPECT_FALSE(has(index, "{{"));
  for (const char* name : {"convergence.csv", "convergence_times.csv.gz", "orders.csv",
                           "stability_limits.csv", "manifest.json", "page.json"})
    EXPECT_TRUE(has(index, "<a href=\"" + std::string(name) + "\">" + name + "</a>")) << name;
  EXPECT_FALSE(has(index, "none.csv")) << "it has no rows, and was not written";
  EXPECT_FALSE(has(index, "alone")) << "rows for the page alone have no file";
  for (const char* name : {"viewer/d3.min.js", "viewer/markdown-it.js", "viewer/page.css"})
    EXPECT_TRUE(fs::exists(report.folder().path() / name)) << name;
}

TEST(Page, ATableWithoutRowsHasColumns) {
  Report report{Facts()};
  const record::Records none{{"time", "y"}};
  report.report().table("runs", "none", none);
  const json table = report.write().table("none");
  EXPECT_EQ(table["rows"], 0);
  EXPECT_EQ(table["parts"].size(), 0U) << "nothing to be loaded";
  EXPECT_EQ(table["columns"], json::array({"time", "y"}));
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
  for (CaseFacts& c : data.facts.cases) c.id = c.title = c.equation = c.source = c.truth = hostile;
  for (SolverInfo& s : data.facts.solvers)
    s.library = s.method = s.family = s.controller = s.needs = s.source = hostile;
  for (LibraryInfo& info : data.facts.libraries) info.name = info.option = info.version = hostile;

  Report report(data);
  report.report().study(
      {.name = "mesh", .command = "mesh", .help = "", .problem = hostile, .selection = hostile});
  report.write({.command_line = hostile});
  const json page = report.json("page.json");
  const std::string plain = page["cases"][0]["title"];
  EXPECT_TRUE(has(plain, "</script><img src=x")) << "the text itself is kept: " << plain;
  EXPECT_EQ(plain.find_first_of("\x1b\x01\x02\n\xff"), std::string::npos);
  EXPECT_EQ(report.column("orders", "solver").at(0), plain);
  EXPECT_EQ(page["solvers"][0]["source"], plain);
  EXPECT_EQ(page["studies"].back()["problem"], plain);
  EXPECT_TRUE(report.json("manifest.json")["command_line"].get<std::string>().starts_with("</scr"));
  // Nothing of it in what a browser reads as markup or as a script.
  EXPECT_FALSE(has(report.text("index.html"), "<img"));
  for (const auto& entry : fs::directory_iterator(report.folder().path() / "data")) {
    const std::string script = tests::text_of(entry.path());
    EXPECT_FALSE(has(script, "<")) << entry.path();
    EXPECT_TRUE(entry.path().filename().string().find_first_of("<>\"'&\n") == std::string::npos);
  }
}

// A command of a study measures into the folder of a report, whose other results stay.
TEST(Page, EarlierResultsStayBesideNewOnes) {
  const tests::TemporaryFolder root;
  const record::OutputFolder folder(root.path() / "out");
  const MadeUp data = test::fabricate_small_report();
  const auto page_of = [&](const StudyFacts& convergence, bool rows, bool keep_earlier) {
    Facts facts = data.facts;
    if (!rows) facts.cases.erase(facts.cases.begin());
    report::Report report(facts, folder);
    report.study(convergence);
    if (rows) report.rows("convergence", data.convergence.orders);
    if (rows) report.fact("kept", 7);
    report.study({.name = "stability", .command = "stability", .help = ""});
    if (!rows) report.rows("stability", data.stability.limits);
    report.write({}, keep_earlier);
    return tests::json_of(folder.path() / "page.json");
  };
  const StudyFacts measured{
      .name = "convergence", .command = "converge", .help = "", .selection = "of the first run"};
  StudyFacts read_back = measured;
  read_back.measured = false;
  read_back.selection = "";
  page_of(measured, true, false);
  json page = page_of(read_back, false, true);
  EXPECT_EQ(names_of(page["tables"]), (std::vector<std::string>{"stability_limits", "orders"}));
  EXPECT_EQ(page["cases"].size(), 2U) << "the case that the second run had not";
  EXPECT_EQ(page["kept"], 7);
  for (const json& study : page["studies"])
    if (study["name"] == "convergence") {
      EXPECT_EQ(study["selection"], "of the first run");
      EXPECT_EQ(study["measured"], true);
    }
  EXPECT_EQ(tests::column_in(folder.path(), "orders", "solver").size(),
            data.convergence.orders.size());
  page = page_of(read_back, false, false);
  EXPECT_EQ(names_of(page["tables"]), (std::vector<std::string>{"stability_limits"}));
  // A file that is not a page of this version is left aside.
  for (const char* damaged : {"", "{", "[1]", "{\"schema\": 0, \"tables\": [{\"name\": \"x\"}]}"}) {
    tests::write_text(folder.path() / "page.json", damaged);
    page = page_of(read_back, false, true);
    EXPECT_EQ(names_of(page["tables"]), (std::vector<std::string>{"stability_limits"})) << damaged;
  }
}

TEST(Page, AFullDiskLeavesWhatWasThereAndNoHalfFile) {
  const MadeUp data = test::fabricate_small_report();
  Report report(data);
  report.write({.command_line = "before"});
  const std::vector<std::string> files = files_in(report.folder().path());
  {
    const tests::FullDisk full(100);
    EXPECT_THROW(report.write({.command_line = "after"}), record::FileError);
  }
  EXPECT_EQ(files_in(report.folder().path()), files);
  EXPECT_EQ(report.json("page.json")["run"]["command"], "before");
  EXPECT_TRUE(has(report.text("index.html"), "</html>"));
}

TEST(Page, ToldOfNothingIsAPageAllTheSame) {
  Report report{MadeUp()};
  const json page = report.write().json("page.json");
  EXPECT_EQ(page["cases"].size(), 0U);
  for (const json& table : page["tables"]) EXPECT_EQ(table["rows"], 0) << table;
}

// A typed list of names passed over every adapter that was added later.
TEST(Page, NamesTheLibrariesThatAreLoaded) {
  Facts facts;
  for (const auto& [name, built] :
       {std::pair{"libm.", true}, {"no such library", true}, {"libc.", false}}) {
    LibraryInfo& info = facts.libraries.emplace_back();
    info.name = name, info.built = built;
  }
  const json loaded = Report{facts}.write().json("page.json")["run"]["loaded"];
#ifdef __linux__
  ASSERT_EQ(loaded.size(), 1U) << loaded;
  EXPECT_TRUE(has(loaded[0].get<std::string>(), "/libm."));
#else
  EXPECT_TRUE(loaded.empty());
#endif
}

TEST(Manifest, SaysWithWhatAndWhatWasSkipped) {
  const MadeUp data = test::fabricate_report();
  Report report(data);
  report.report().manifest("more", 5);
  const json m =
      report.write({.command_line = "odeum report", .seconds = 123.4}).json("manifest.json");
  EXPECT_EQ(m["schema"], 3);
  EXPECT_EQ(m["odeum"]["version"], "0.1.0");
  EXPECT_NE(m["build"]["compiler"], "");
  EXPECT_NE(m["cpu"], "");
  EXPECT_EQ(m["options"]["quick"], false);
  EXPECT_EQ(m["seconds"], 123.4);
  EXPECT_EQ(m["more"], 5);
  EXPECT_FALSE(m["words"].empty());
  EXPECT_EQ(m["folder"], std::filesystem::current_path().string());
  EXPECT_NE(m["loaded"].dump().find("/libm"), std::string::npos);
  EXPECT_EQ(m["loaded"][0]["sum"].get<std::string>().size(), 16U);
  ASSERT_EQ(m["libraries"].size(), 4U);
  EXPECT_EQ(m["libraries"][0]["version"], "6.4.1");
  EXPECT_EQ(m["libraries"][3]["version"], nullptr);
  EXPECT_EQ(m["libraries"][3]["option"], "ODEUM_WITH_BULLET");
  const std::string date = m["date"];
  EXPECT_EQ(date.size(), std::string("2025-01-01T00:00:00Z").size());
  const auto unfit = [](const auto& row) { return row.status == "not_applicable"; };
  const auto rows =
      std::count_if(data.convergence.rows.begin(), data.convergence.rows.end(), unfit);
  const auto limits =
      std::count_if(data.stability.limits.begin(), data.stability.limits.end(), unfit);
  const json& skipped = m["skipped"];
  ASSERT_EQ(skipped["not_applicable"].size(), 2U) << "reasons";
  for (const json& each : skipped["not_applicable"])
    EXPECT_EQ(each["rows"], each["reason"] == "needs a second-order problem" ? limits : rows);
  EXPECT_EQ(skipped["rows_by_status"]["convergence.csv"]["not_applicable"], rows);
  EXPECT_EQ(skipped["rows_by_status"]["stability_limits.csv"]["not_applicable"], limits);
  EXPECT_EQ(skipped["rows_by_status"]["convergence.csv"]["ok"],
            std::count_if(data.convergence.rows.begin(), data.convergence.rows.end(),
                          [](const auto& row) { return row.status == "ok"; }));
}

}  // namespace
}  // namespace odeum::report::page_test
