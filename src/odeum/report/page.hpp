// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <chrono>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "odeum/record/output_folder.hpp"
#include "odeum/report/facts.hpp"
#include "odeum/report/table.hpp"

namespace odeum::report {

/// A part of a page: a heading and what follows it.
struct Section {
  std::string id;                ///< what a link goes to: letters, digits and -
  std::string title;             ///< a text
  int place = 500;               ///< sections stand in rising order of it
  std::string html;              ///< escaped by whoever made it
  std::string short_title = {};  ///< in the navigation; empty: the title
};

/// What the page and the manifest say about the run as a whole.
struct RunFacts {
  std::string command_line;
  bool quick = false;
  double seconds = 0;  ///< how long the studies took
  std::chrono::system_clock::time_point finished = std::chrono::system_clock::now();
};

/// The report: index.html with the interactive views (reports/viewer/page), a page for each
/// section, a page for each case in cases/, data for the views in data/, and manifest.json, beside
/// the CSV files that are there already. Studies hand in their parts, in any order; `write` puts
/// them together. The folder stands alone: nothing from elsewhere, addresses relative, so that it
/// may be moved and opened from a disk.
class Page {
 public:
  Page(Facts facts, const record::OutputFolder& folder);

  const Facts& facts() const { return facts_; }
  void section(Section section) { sections_.push_back(std::move(section)); }
  /// A section of the page of case number `index`.
  void case_part(std::size_t index, Section part);
  /// A line among the facts that begin the page of a case.
  void case_fact(std::size_t index, std::string_view name, std::string_view markup);
  /// Data for the views under a name, as JSON (report/columns.hpp): in data/<file>.js, of which
  /// `index` is loaded with index.html and others when a view asks for them; or of case number
  /// `index`, loaded when the case is looked at.
  void data(const std::string& file, const std::string& name, std::string json) {
    data_[file][name] = std::move(json);
  }
  void case_data(std::size_t index, const std::string& name, std::string json);
  /// Markup under the title of data.html, and under "How to read it".
  void headline(std::string_view markup) { headline_ += markup; }
  void guide(std::string_view markup) { guide_ += markup; }
  /// Writes a picture that lies in a file, `stem` and a number where that is taken; its <img>.
  std::string picture(const std::string& stem, std::string_view png, std::string_view description,
                      std::string_view attributes = {});
  /// Counts a row of data by its status; of rows that do not apply, by `reason` too where given.
  void count_row(const std::string& status, const std::string& reason = {});
  /// An entry of manifest.json.
  void manifest(const std::string& key, const nlohmann::ordered_json& value);

  /// Throws FileError.
  void write(const RunFacts& run);

 private:
  using Data = std::map<std::string, std::string>;  // JSON by name
  /// A whole page of the report. `top` and `main` are markup; `scripts` holds addresses. Scripts
  /// and pictures may come from the folder itself and nowhere else.
  static std::string document(const std::string& title, const std::string& top,
                              const std::string& main,
                              const std::vector<std::string>& scripts = {});
  std::string case_page(std::size_t index) const;
  std::string index_page(const RunFacts& run) const;
  std::string data_page(const RunFacts& run) const;
  std::string navigation(const std::string& root, const std::string& here) const;
  void write_all_data(const RunFacts& run) const;
  void write_data(const std::string& file, const Data& data) const;
  std::string manifest_text(const RunFacts& run) const;

  Facts facts_;
  const record::OutputFolder& folder_;
  std::vector<Section> sections_;
  std::vector<std::vector<Section>> case_parts_;
  std::vector<std::string> case_facts_;
  std::string headline_, guide_;
  std::map<std::string, std::size_t> statuses_, reasons_;
  std::map<std::string, std::string> manifest_;  // JSON by key
  std::map<std::string, Data> data_;             // by file
  std::vector<Data> case_data_;
  std::set<std::string> pictures_;  // names of their files
};

/// The name of the file in data/ with a case's data for the views, without its ending.
std::string data_name(const CaseFacts& c);

/// A link from index.html to the page of a case, or to a section of it.
std::string case_link(const CaseFacts& c, std::string_view section = {});

}  // namespace odeum::report
