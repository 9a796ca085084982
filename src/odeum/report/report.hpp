// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "odeum/record/csv.hpp"
#include "odeum/record/output_folder.hpp"
#include "odeum/record/row.hpp"
#include "odeum/report/facts.hpp"

namespace odeum::report {

/// What the page and the manifest say about the run as a whole.
struct RunFacts {
  std::string command_line;
  bool quick = false;
  double seconds = 0;  ///< how long the studies took
  std::chrono::system_clock::time_point finished = std::chrono::system_clock::now();
};

/// What the page says about a study; its texts are those of pages/<name> in the shared folder:
/// page.md and other *.md, a page each; case.md, its part of the page of a case; summary.md, its
/// part of the view of the data; view.js, blocks of its own.
struct StudyFacts {
  std::string name, command, help;
  int place = 500;
  std::map<std::string, double> figures = {};  ///< numbers that its texts name
  std::string problem = {};    ///< why files of an earlier run could not be used; empty: they could
  std::string selection = {};  ///< what of it was measured, as text; empty: all
  bool measured = true;        ///< by this run, and not only read back
};

/// Rows of one file, and of one case where the file is large. `fields` makes them when they are
/// written, so that not all are held at once.
struct TablePart {
  std::string case_id;
  std::size_t rows = 0;
  std::function<std::vector<record::Fields>()> fields;
};

/// The data of a report beside its CSV files: page.json with the facts, the rows again as scripts
/// in data/, which a page that is opened from a disk can load, the page's own code in viewer/, and
/// manifest.json. The folder stands alone: nothing from elsewhere, addresses relative, so that it
/// may be moved. It holds nothing of how a thing looks: see reports/viewer.
class Report {
 public:
  /// `jobs`: parts of tables that are written at a time.
  Report(Facts facts, const record::OutputFolder& folder, unsigned jobs = 1);

  const Facts& facts() const { return facts_; }
  unsigned jobs() const { return jobs_; }
  void study(StudyFacts study) { studies_.push_back(std::move(study)); }
  /// The rows of a study's file. Those of a file with many rows of several cases are loaded case by
  /// case.
  template <class Row>
  void rows(const std::string& study, const std::vector<Row>& rows) {
    const auto case_of = [&](const Row& row) {
      if constexpr (requires { row.case_id; })
        if (rows.size() > most_rows_together) return row.case_id;
      return std::string();
    };
    std::vector<TablePart> parts;
    for (std::size_t begin = 0, end = 0; begin < rows.size(); begin = end) {
      const std::string id = case_of(rows[begin]);
      while (end < rows.size() && case_of(rows[end]) == id) ++end;
      parts.push_back({id, end - begin, [&rows, begin, end] {
                         std::vector<record::Fields> fields;
                         for (std::size_t i = begin; i < end; ++i)
                           fields.push_back(record::fields_of(rows[i]));
                         return fields;
                       }});
    }
    table(study, Row::file, record::fields_of(Row()), parts);
  }
  /// The same of rows that are made elsewhere; `blank` names the columns. A `file` without an
  /// ending is the name of rows for the page alone.
  void table(const std::string& study, const std::string& file, const record::Fields& blank,
             const std::vector<TablePart>& parts);
  void table(const std::string& study, const std::string& file, const record::Records& rows);
  /// Further data for the views, a JSON text, as a script of its own: data/<name>.js.
  void data(const std::string& name, const std::string& json);
  /// An entry of page.json, of manifest.json.
  void fact(const std::string& key, const nlohmann::ordered_json& value);
  void manifest(const std::string& key, const nlohmann::ordered_json& value);

  /// Writes what was handed in; with `keep_earlier` beside what an earlier page.json in the folder
  /// names of other studies, cases and solvers. False where the page's own code is not beside the
  /// program (report/shared_files.hpp), so that there are data and no page. Throws FileError.
  bool write(const RunFacts& run, bool keep_earlier = false);

 private:
  static constexpr std::size_t most_rows_together = 5000;

  nlohmann::ordered_json page_json(const RunFacts& run, bool keep_earlier) const;
  std::string manifest_text(const RunFacts& run) const;

  Facts facts_;
  const record::OutputFolder& folder_;
  unsigned jobs_;
  std::vector<StudyFacts> studies_;
  std::map<std::string, std::string> facts_more_, manifest_;            // JSON by key
  std::vector<std::string> tables_;                                     // JSON of an entry each
  std::map<std::string, std::map<std::string, std::size_t>> statuses_;  // counts, by file
  std::map<std::string, std::size_t> reasons_;                          // of rows that do not apply
};

}  // namespace odeum::report
