// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <array>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/record/output_folder.hpp"
#include "odeum/report/gnuplot.hpp"
#include "odeum/report/panels.hpp"
#include "odeum/report/plots.hpp"
#include "odeum/report/report_data.hpp"
#include "odeum/report/summary.hpp"

/// The parts of the pages, each a piece of HTML. They share results looked up by pair, and a book
/// of pictures that are drawn together once every part is written.
namespace odeum::report {

/// Collects pictures. `add` gives a mark to put into the page (control characters, which no escaped
/// text can hold); `fill` puts the drawn pictures in the places of their marks.
class PictureBook {
 public:
  /// The mark of a picture; `description` is its text for those who cannot see it. A PNG lies in a
  /// file of the name `stem` and a number where it is taken, beside index.html; an SVG is part of
  /// the page.
  std::string add(Picture picture, std::string description, const std::string& stem = {});
  void draw(unsigned processes) { rendering_ = render(pictures_, processes); }
  std::string fill(const std::string& html) const;
  void write_files(const record::OutputFolder& folder) const;
  const Rendering& rendering() const { return rendering_; }

 private:
  std::vector<Picture> pictures_;
  std::vector<std::string> descriptions_, files_;
  std::set<std::string> taken_;
  Rendering rendering_;
};

/// Rows by who they are of. Points into the data.
class Lookup {
 public:
  explicit Lookup(const ReportData& data);

  template <class Row>
  using Rows = std::vector<const Row*>;

  /// Null where the pair was not run.
  const study::OrderRow* order(const std::string& case_id, const SolverInfo& solver,
                               Mode mode) const;
  const Rows<study::ConvergenceRow>& rows(const std::string& case_id, const SolverInfo& solver,
                                          Mode mode) const;
  const Rows<study::TimeRow>& times(const std::string& case_id, const SolverInfo& solver,
                                    Mode mode) const;

 private:
  using Key = std::tuple<std::string, std::string, Mode>;
  std::map<Key, const study::OrderRow*> orders_;
  std::map<Key, Rows<study::ConvergenceRow>> rows_;
  std::map<Key, Rows<study::TimeRow>> times_;
};

struct PageContext {
  const ReportData& data;
  const record::OutputFolder& folder;
  Lookup lookup;
  std::vector<Panel> panels;
  std::vector<std::string> case_files;  ///< `cases/<id>.html` and its like, for each case
  PictureBook pictures;

  /// The page of a case as seen from index.html.
  std::string case_address(std::size_t index) const;
};

/// Counts by Verdict.
using VerdictCounts = std::array<std::size_t, verdict_styles.size()>;
/// A bar with a length for each verdict but "not applicable".
std::string verdict_bar(const VerdictCounts& counts);
/// "3 confirmed, 1 lower".
std::string verdict_words(const VerdictCounts& counts);

std::string head_section(const PageContext& page, const std::string& plots);
std::string overview_section(const PageContext& page);
std::string orders_section(const PageContext& page);
/// Time against error: of all cases on index.html, and of one on its own page (empty where it was
/// not measured).
std::string precision_section(const PageContext& page);
std::string precision_part(const PageContext& page, const CaseFacts& c);
/// What adaptive solvers achieve of a tolerance, by group; with `each_solver`, by solver as well.
std::string tolerance_table(const PageContext& page, const std::vector<study::PrecisionRow>& rows,
                            bool each_solver);
/// What engines do to stiffness and damping, and cloths beside one another (page_material.hpp).
std::string material_section(const PageContext& page);
/// The body of the page of one case, which lies in a folder beside index.html.
std::string case_body(PageContext& page, std::size_t index);
/// Its part on a cloth in the course of time; empty where the case is none.
std::string cloth_part(PageContext& page, const CaseFacts& c);
std::string stability_section(PageContext& page);
/// Order reduction, largest stable steps, drift and horizons.
std::string hard_cases_section(const PageContext& page);
std::string proofs_section(const PageContext& page);
/// What did not come out as claimed, what failed, what was skipped, and the findings.
std::string verdicts_section(const PageContext& page);
std::string skipped_section(const PageContext& page);
std::string findings_section();

/// The legend of a panel: marker, colour and name of the solvers for which `shown` holds.
std::string legend(const Panel& panel, const std::vector<bool>& shown);

}  // namespace odeum::report
