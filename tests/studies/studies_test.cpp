// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <algorithm>

#include "odeum/cases/catalogue.hpp"
#include "odeum/core/glob.hpp"
#include "odeum/studies/convergence/convergence.hpp"
#include "odeum/studies/study.hpp"
#include "support/temporary_folder.hpp"

namespace odeum::study::studies_test {
namespace {

using tests::text_of;

/// Little work for each study: those without an entry take what any study takes.
Options little_of(const std::string& name) {
  Options options{.cases = {"dahlquist_real", "lotka_volterra"},
                  .solvers = {"odeum/rk4", "odeum/velocity_verlet"},
                  .quick = true};
  if (name == "limits") options.cases = {"stiff_chain2_k1e4"};
  if (name == "drift") options.cases = {"osc_undamped", "lorenz_kehlet_logg"};
  if (name == "stability") options.cases = {}, options.own = {{"grid", "8"}};
  if (name == "precision") options.own = {{"seconds", "0.01"}};
  if (name == "mesh") options.own = {{"most", "6"}};
  if (name == "cost") options.solvers = {}, options.own = {{"most", "11"}};
  if (name == "elements" || name == "evolution") options.own = {{"most", "16"}};
  return options;
}

TEST(Studies, ReadTheirFilesBackToTheSameBytes) {
  const tests::TemporaryFolder root;
  const record::OutputFolder folder(root.path() / "out"), again(root.path() / "again");
  for (const auto& study : make_studies()) {
    study->measure(little_of(study->declaration().name), Runner(2));
    study->write(folder, 1);
    EXPECT_NE(study->table(), "") << study->declaration().name;
  }
  for (const auto& study : make_studies()) {
    study->add_earlier(folder.path());
    EXPECT_EQ(study->problem(), "") << study->declaration().name;
    study->write(again, 1);
    for (const auto& [file, columns] : study->files()) {
      // Growth of stability has files of its own, and a study that was not asked may have none.
      if (file == "stability_regions.csv" || !std::filesystem::exists(folder.path() / file))
        continue;
      EXPECT_EQ(text_of(folder.path() / file), text_of(again.path() / file)) << file;
    }
  }
}

// It said "wrong answers: 2".
TEST(Studies, WrongAnswersAreNamed) {
  ConvergenceRow row;
  row.case_id = "lotka_volterra", row.library = "odeum", row.solver = "rk4", row.status = "ok";
  row.mode = Mode::adaptive;
  row.judged.answer = judge::Answer::wrong;
  ConvergenceResult result;
  result.rows = {row, row};
  row.solver = "heun";
  row.judged.answer = judge::Answer::explained;
  result.rows.push_back(row);
  const tests::TemporaryFolder root;
  record::write(result, record::OutputFolder(root.path()));
  for (const auto& study : make_studies()) {
    if (study->declaration().name != "converge") continue;
    study->add_earlier(root.path());
    const std::string table = study->table();
    EXPECT_NE(table.find("2 runs ended ok with a wrong answer, column answer of convergence.csv:\n"
                         "  2 of odeum/rk4 on lotka_volterra\n"),
              std::string::npos)
        << table << study->problem();
    EXPECT_EQ(table.find("heun on"), std::string::npos) << table;
  }
}

TEST(Studies, ResultsThatWereKeptMakeTheSameFiles) {
  for (const std::string name : {"converge", "stability", "limits", "drift", "proof"}) {
    const tests::TemporaryFolder root;
    const record::OutputFolder folder(root.path());
    const auto files_of = [&](const Options& options, record::Store* store) {
      for (const auto& study : make_studies()) {
        if (study->declaration().name != name) continue;
        study->measure(options, Runner(1, {.store = store, .dependencies = "same"}));
        study->write(folder, 1);
        std::string texts;
        for (const auto& [file, columns] : study->files()) texts += text_of(folder.path() / file);
        return texts;
      }
      return std::string();
    };
    const Options whole = little_of(name);
    Options part = whole;
    part.solvers = {"odeum/rk4"};
    record::Store before(root.path() / "store");
    files_of(part, &before);
    EXPECT_GT(before.added(), 0U) << name;
    record::Store store(root.path() / "store");
    EXPECT_EQ(files_of(whole, &store), files_of(whole, nullptr)) << name;
    EXPECT_EQ(store.taken(), before.added()) << name;
  }
}

TEST(Studies, WhatAReportRunsIsThere) {
  const std::vector<std::string> ids = known_ids();
  for (const auto& study : make_studies())
    for (const bool quick : {false, true})
      for (const Options& options : study->report_runs(quick)) {
        for (const std::string& glob : options.cases)
          EXPECT_TRUE(std::any_of(ids.begin(), ids.end(),
                                  [&](const std::string& id) { return glob_matches(glob, id); }))
              << study->declaration().name << ": " << glob;
        for (const auto& [name, value] : options.own)
          EXPECT_TRUE(
              std::any_of(study->declaration().options.begin(), study->declaration().options.end(),
                          [&, name = name](const Option& option) { return option.name == name; }))
              << study->declaration().name << ": " << name;
      }
}

TEST(Studies, HaveNamesAndPlacesOfTheirOwn) {
  std::vector<std::string> names;
  std::vector<int> places;
  for (const auto& study : make_studies()) {
    EXPECT_NE(study->declaration().help, "");
    names.push_back(study->declaration().name);
    places.push_back(study->declaration().place);
  }
  EXPECT_TRUE(std::is_sorted(places.begin(), places.end()));
  std::sort(names.begin(), names.end());
  EXPECT_EQ(std::adjacent_find(names.begin(), names.end()), names.end());
}

}  // namespace
}  // namespace odeum::study::studies_test
