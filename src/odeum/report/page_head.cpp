// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "odeum/report/html.hpp"
#include "odeum/report/manifest.hpp"
#include "odeum/report/page_sections.hpp"
#include "odeum/report/summary.hpp"
#include "odeum_build_info.hpp"

namespace odeum::report {
namespace {

std::string fact(const char* name, const std::string& value) {
  return fmt::format("<dt>{}</dt><dd>{}</dd>\n", name, escape(value));
}

std::string libraries_text(const ReportData& data, bool built) {
  std::string text;
  for (const LibraryInfo& info : data.libraries) {
    if (info.built != built) continue;
    text += text.empty() ? "" : ", ";
    text += built ? info.name + " " + info.version : info.name + " (" + info.option + ")";
  }
  return text;
}

std::string facts(const ReportData& data, const std::string& plots) {
  std::string html = "<dl class=\"facts\">\n";
  html += fact("Written", utc_text(data.finished));
  html += fact("Command", fmt::format("{}{}", data.command_line,
                                      data.quick ? "  (quick: fewer settings a solver)" : ""));
  html += fact("Took", fmt::format("{:.0f} s", data.seconds));
  html += fact("Odeum", fmt::format("{} {}", build::version, build::revision));
  html += fact("Libraries", libraries_text(data, true));
  if (const std::string missing = libraries_text(data, false); !missing.empty())
    html += fact("Not built in", missing);
  html += fact("Compiler", fmt::format("{}, {}, {}", build::compiler, build::type, build::flags));
  html += fact("Processor", cpu_model());
  html += fact("Plots", plots);
  return html + "</dl>\n";
}

std::string verdict_key() {
  std::string html = "<ul class=\"key\">\n";
  for (const VerdictStyle& style : verdict_styles)
    html += fmt::format("<li>{} {}</li>\n", verdict_chip(style.verdict), style.meaning);
  return html + "</ul>\n";
}

std::string summary_html(const ReportData& data) {
  std::string html =
      "<div class=\"wide\"><table class=\"numbers\"><thead><tr><th>library</th><th>solvers</th>"
      "<th>pairs</th>";
  for (const VerdictStyle& style : verdict_styles)
    html += fmt::format("<th>{}</th>", verdict_chip(style.verdict));
  html += "</tr></thead><tbody>\n";
  for (const LibrarySummary& entry : summarise(data)) {
    html += fmt::format("<tr><th>{}</th><td>{}</td><td>{}</td>", escape(entry.library),
                        entry.solvers, entry.pairs);
    for (const std::size_t count : entry.verdicts)
      html +=
          count == 0 ? std::string("<td class=\"zero\">0</td>") : fmt::format("<td>{}</td>", count);
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string statuses(const ReportData& data) {
  std::string text;
  for (const auto& [status, count] : status_counts(data))
    text += fmt::format("{}{} <code>{}</code>", text.empty() ? "" : ", ", count, escape(status));
  return fmt::format("<p>{}: {}.</p>\n",
                     show_count(data.convergence.rows.size() + data.stability.limits.size(), "row"),
                     text);
}

// The data files of a folder, as links relative to the page.
std::string links(const std::filesystem::path& folder, const std::string& prefix) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
    if (const auto name = entry.path().filename().string();
        entry.path().extension() == ".csv" || name == "manifest.json")
      names.push_back(name);
  std::sort(names.begin(), names.end());
  std::string html;
  for (const std::string& name : names)
    html +=
        fmt::format("<li><a href=\"{}\">{}</a></li>\n", as_address(prefix + name), escape(name));
  return html;
}

std::string data_files(const record::OutputFolder& folder) {
  std::string html =
      "<h3>The data</h3>\n<p>Everything on this page comes from the files beside it, one "
      "observation a row:</p>\n<ul class=\"files\">\n" +
      links(folder.path(), "./") + "</ul>\n";
  if (const std::string regions = links(folder.path() / "stability", "stability/");
      !regions.empty())
    html += "<details><summary>Data of the stability regions</summary><ul class=\"files\">\n" +
            regions + "</ul></details>\n";
  return html;
}

}  // namespace

std::string head_section(const PageContext& page, const std::string& plots) {
  const ReportData& data = page.data;
  return fmt::format(
             "<header>\n<h1>Odeum</h1>\n<p class=\"lead\">{} from {} on {}: each solver runs the "
             "same problems, and is judged by the same independent truth.</p>\n"
             "<nav><a href=\"#overview\">Overview and cases</a>"
             "<a href=\"#precision\">Speed</a>"
             "<a href=\"#orders\">Orders</a><a href=\"#stability\">Stability</a>"
             "<a href=\"#hard\">Hard cases</a><a href=\"#material\">Material</a>"
             "<a href=\"#proofs\">Proofs</a>"
             "<a href=\"#verdicts\">What did not confirm</a><a href=\"#skipped\">Skipped</a>"
             "<a href=\"#findings\">Findings</a></nav>\n",
             show_count(data.solvers.size(), "solver"),
             library_names(data).size() == 1
                 ? "1 library"
                 : fmt::format("{} libraries", library_names(data).size()),
             show_count(data.cases.size(), "case")) +
         summary_html(data) + statuses(data) +
         "<section class=\"columns\">\n<div><h3>How to read it</h3>\n<p>A solver is run on a case "
         "with smaller and smaller steps. Where its error falls as a power of the step, the power "
         "is its measured order: the slope of a line through the points of the asymptotic window, "
         "with a 95 % interval. An order claimed and an order measured give a verdict; a pair is a "
         "solver on a case in one mode (fixed step, or the solver's own choice of it).</p>\n" +
         verdict_key() + "</div>\n<div><h3>This run</h3>\n" + facts(data, plots) +
         data_files(page.folder) + "</div>\n</section>\n</header>\n";
}

}  // namespace odeum::report
