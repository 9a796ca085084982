// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "odeum/report/gnuplot.hpp"
#include "odeum/report/output_folder.hpp"
#include "odeum/report/panels.hpp"
#include "odeum/report/plots.hpp"
#include "odeum/report/report_data.hpp"

/// The parts of the page, each a piece of HTML. They share results looked up by pair, and a book of
/// pictures that are drawn together once every part is written.
namespace odeum::report {

/// Collects pictures. `add` gives a mark to put into the page (control characters, which no escaped
/// text can hold); `fill` puts the drawn pictures in the places of their marks.
class PictureBook {
 public:
  /// The mark of a picture; `description` is its text for those who cannot see it.
  std::string add(Picture picture, std::string description);
  void draw(unsigned processes) { rendering_ = render(pictures_, processes); }
  std::string fill(const std::string& html) const;
  const Rendering& rendering() const { return rendering_; }

 private:
  std::vector<Picture> pictures_;
  std::vector<std::string> descriptions_;
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
  const OutputFolder& folder;
  Lookup lookup;
  std::vector<Panel> panels;
  PictureBook pictures;
};

std::string head_section(const PageContext& page, const std::string& plots);
std::string overview_section(const PageContext& page);
std::string cases_section(PageContext& page);
std::string cloth_section(PageContext& page);
std::string stability_section(PageContext& page);
std::string proofs_section(const PageContext& page);
/// What did not come out as claimed, what failed, what was skipped, and the findings.
std::string verdicts_section(const PageContext& page);
std::string skipped_section(const PageContext& page);
std::string findings_section();

/// The address within the page of the case of that number.
std::string case_anchor(std::size_t index);
/// "✓ confirmed" as a coloured chip.
std::string verdict_chip(study::Verdict verdict);
/// The legend of a panel: marker, colour and name of the solvers for which `shown` holds.
std::string legend(const Panel& panel, const std::vector<bool>& shown);

}  // namespace odeum::report
