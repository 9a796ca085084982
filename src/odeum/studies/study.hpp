// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "odeum/record/table.hpp"
#include "odeum/report/report.hpp"
#include "odeum/studies/runner.hpp"

/// A study is a folder, studies/<name>/: its rows, their measurement, its page as text (page.md,
/// see reports/viewer/blocks.js), and `std::unique_ptr<Study> make_<name>()` in study.cpp, which
/// CMake finds. Its command, its files, their data in a report and the keeping of its results
/// follow from that.

namespace odeum::study {

/// An option of one study: a word out of a list, or a number between bounds.
struct Option {
  std::string name, help;               ///< the name without its dashes
  std::vector<std::string> words = {};  ///< empty: a number
  double least = 0, most = 1e9;
  bool whole = false;                    ///< the number has to be an integer
  std::optional<double> otherwise = {};  ///< where it is not given, if always the same
};

/// An option whose value is a whole number.
inline Option whole_number(std::string name, double least, double most, std::string help,
                           std::optional<double> otherwise = {}) {
  return {.name = std::move(name),
          .help = std::move(help),
          .least = least,
          .most = most,
          .whole = true,
          .otherwise = otherwise};
}

/// The options of a run of a study.
struct Options {
  std::vector<std::string> cases = {};    ///< globs on case ids; empty: all
  std::vector<std::string> solvers = {};  ///< globs on library/method; empty: all
  bool quick = false;
  std::map<std::string, std::string> own = {};  ///< by Option::name; only those given

  double number(const std::string& name, double otherwise) const;
  double number(const Option& option) const;
  std::string word(const std::string& name) const;  ///< empty where not given
  /// A text that identifies the options, by which results are kept.
  std::string text() const;
};

/// A study as the command line needs it.
struct Declaration {
  std::string name;         ///< of the command
  std::string help;         ///< one line
  int place = 0;            ///< position on the page and in the list of commands, ascending
  std::string folder = {};  ///< of its texts; empty: the name
  std::string cases_help = "cases, with * and ?; !GLOB excludes";  ///< of --case; empty: takes none
  /// Without a choice of cases it is on all of them, else on none: a choice then asks for more.
  bool on_cases = true;
  std::string quick_help = {};  ///< of --quick; empty: takes none
  std::string no_resume = {};   ///< why its results are not kept; empty: they are
  std::vector<Option> options = {};
  /// Numbers of its measurement and limits of its verdicts that its texts name:
  /// figure('study.name').
  std::map<std::string, double> figures = {};
  /// The runs of a report; none: it shows the files of earlier runs in its folder.
  std::vector<Options> report = {Options()};
  std::vector<Options> quick_report = {};  ///< of a quick one
};

class Study {
 public:
  explicit Study(Declaration declaration) : declaration_(std::move(declaration)) {}
  virtual ~Study() = default;
  const Declaration& declaration() const { return declaration_; }
  const std::vector<Options>& report_runs(bool quick) const {
    return quick ? declaration_.quick_report : declaration_.report;
  }
  /// Measures and appends the rows. Throws Interrupted.
  virtual void measure(const Options& options, const Runner& runner) = 0;
  /// Adds the rows of earlier runs that were not measured now, of cases and solvers that still
  /// exist.
  virtual void add_earlier(const std::filesystem::path& folder) = 0;
  virtual void write(const record::OutputFolder& folder, unsigned jobs) const = 0;
  /// The files that write() writes.
  virtual record::Files files() const = 0;
  /// The result for a terminal.
  virtual std::string table() const = 0;
  /// The same for a program, see record::json_of.
  virtual std::string json() const = 0;
  /// The text of its first file.
  virtual std::string csv() const = 0;
  /// Hands its rows to a report, and what else its texts refer to.
  virtual void show(report::Report& report) const = 0;
  /// What a report says of it beside its texts.
  report::StudyFacts facts() const;
  /// Why files of an earlier run could not be used; empty: they could.
  const std::string& problem() const { return problem_; }
  /// The folder of its texts, by which a report names it.
  const std::string& folder() const {
    return declaration_.folder.empty() ? declaration_.name : declaration_.folder;
  }
  /// Whether this run measured rows, or only read them.
  bool measured() const { return !ran_.empty(); }

 protected:
  std::string problem_;
  std::vector<Options> ran_;  ///< what was measured

 private:
  Declaration declaration_;
};

/// Whether a case (empty: none) and a solver (likewise) exist.
bool is_known(const std::string& case_id, const std::string& solver);

/// What is particular to a study beside its declaration.
template <class Result>
struct StudyFunctions {
  Result (*measure)(const Options& options, const Runner& runner);
  /// The result for a terminal; null: record::tables_of.
  std::string (*table)(const Result& result) = nullptr;
  /// Hands a report more than the rows; null: there is no more.
  void (*show_more)(report::Report& report, const Result& result) = nullptr;
  /// Writes files beside those of the rows; null: there are none.
  void (*write_more)(const Result& result, const record::OutputFolder& folder,
                     unsigned jobs) = nullptr;
};

/// A study whose result is a struct of lists of rows, see record/rows.hpp.
template <class Result>
class StudyOf final : public Study {
 public:
  StudyOf(Declaration declaration, const StudyFunctions<Result>& functions)
      : Study(std::move(declaration)), functions_(functions) {}
  void measure(const Options& options, const Runner& runner) override {
    record::append(result_, functions_.measure(options, runner));
    ran_.push_back(options);
  }
  void add_earlier(const std::filesystem::path& folder) override {
    record::add_earlier(result_, record::read<Result>(folder, problem_), is_known);
  }
  void write(const record::OutputFolder& folder, unsigned jobs) const override {
    record::write(result_, folder);
    if (functions_.write_more) functions_.write_more(result_, folder, jobs);
  }
  record::Files files() const override { return record::files_of<Result>(); }
  std::string table() const override {
    return functions_.table ? functions_.table(result_) : record::tables_of(result_);
  }
  std::string json() const override { return record::json_of(result_); }
  std::string csv() const override { return record::csv_text(std::get<0>(Result::lists(result_))); }
  void show(report::Report& report) const override {
    record::for_each_list(result_, [&]<class Row>(const std::vector<Row>& rows) {
      if (!record::is_compressed<Row>()) report.rows(folder(), rows);
    });
    if (functions_.show_more) functions_.show_more(report, result_);
  }
  const Result& result() const { return result_; }

 private:
  StudyFunctions<Result> functions_;
  Result result_;
};

template <class Result>
std::unique_ptr<Study> make_study(Declaration declaration,
                                  const StudyFunctions<Result>& functions) {
  return std::make_unique<StudyOf<Result>>(std::move(declaration), functions);
}

using Studies = std::vector<std::unique_ptr<Study>>;
/// Every study, ordered by `place`, without results.
Studies make_studies();

/// The result of the study with this type of result; an empty one where there is none.
template <class Result>
const Result& result_of(const Studies& studies) {
  for (const auto& study : studies)
    if (const auto* found = dynamic_cast<const StudyOf<Result>*>(study.get()))
      return found->result();
  static const Result none;
  return none;
}

}  // namespace odeum::study
