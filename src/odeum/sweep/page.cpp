// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "odeum/report/report.hpp"
#include "odeum/sweep/answer.hpp"
#include "odeum/trajectories/run_page.hpp"

namespace odeum::sweep {
namespace {

/// One side of the map: the first or second parameter that has several values, in cells. A grid has
/// a cell for each value, and others forty of equal width, by logarithms where they span decades.
class Side {
 public:
  Side(const Plan& plan, std::size_t name) : name_(name) {
    const auto& axes = plan.members.axes();
    const bool grid = !axes.empty() && axes[name].kind == Axis::Kind::grid &&
                      axes[name].values.size() <= most_values;
    std::vector<double> values{infinity, -infinity};  // of a grid, else the least and the greatest
    if (grid) {
      values = axes[name].values;
      std::ranges::sort(values);
    } else {
      for (std::uint64_t member = 0; member < plan.members.size(); ++member) {
        const double value = plan.members.values(member)[name];
        values = {std::min(values[0], value), std::max(values[1], value)};
      }
    }
    if (!(values.back() > values.front())) return;
    log_ = values.front() > 0 && values.back() >= 20 * values.front();
    for (double& value : values) value = scaled(value);
    if (!grid) {
      for (int k = 0; k <= bins; ++k)
        ends_.push_back(std::lerp(values[0], values[1], k * 1. / bins));
      return;
    }
    // Halfway to the neighbours.
    const std::size_t last = values.size() - 1;
    ends_.push_back(1.5 * values[0] - 0.5 * values[1]);
    for (std::size_t k = 0; k < last; ++k) ends_.push_back(0.5 * (values[k] + values[k + 1]));
    ends_.push_back(1.5 * values[last] - 0.5 * values[last - 1]);
  }
  bool varies() const { return !ends_.empty(); }
  bool log() const { return log_; }
  std::size_t cells() const { return ends_.size() - 1; }
  std::size_t cell_of(double value) const {
    const auto above = std::ranges::upper_bound(ends_.begin() + 1, ends_.end() - 1, scaled(value));
    return static_cast<std::size_t>(above - ends_.begin()) - 1;
  }
  std::pair<double, double> ends(std::size_t cell) const {
    const auto unscaled = [&](double end) { return log_ ? std::exp(end) : end; };
    return {unscaled(ends_[cell]), unscaled(ends_[cell + 1])};
  }
  std::size_t name() const { return name_; }

 private:
  static constexpr std::size_t most_values = 400;
  static constexpr int bins = 40;
  double scaled(double value) const { return log_ ? std::log(value) : value; }

  std::size_t name_;
  std::vector<double> ends_;  ///< of the cells, scaled; none where the parameter does not vary
  bool log_ = false;
};

/// The first two parameters that vary.
std::vector<Side> sides_of(const Plan& plan) {
  std::vector<Side> sides;
  for (std::size_t k = 0; k < plan.members.names().size() && sides.size() < 2; ++k)
    if (Side side(plan, k); side.varies()) sides.push_back(std::move(side));
  return sides;
}

/// The share that was solved, and the median of each quantity, in each cell of one side or two.
record::Records map_of(const Plan& plan, const Result& result, const std::vector<Side>& sides) {
  const bool flat = sides.size() < 2;
  const std::size_t wide = sides[0].cells(), high = flat ? 1 : sides[1].cells();
  std::vector<std::vector<std::uint64_t>> members(wide * high);
  for (std::uint64_t member = 0; member < result.size; ++member) {
    const std::vector<double> values = plan.members.values(member);
    members[sides[0].cell_of(values[sides[0].name()]) +
            wide * (flat ? 0 : sides[1].cell_of(values[sides[1].name()]))]
        .push_back(member);
  }
  constexpr std::size_t most_quantities = 6;
  const std::size_t all = plan.quantities.size(), shown = std::min(all, most_quantities);
  record::Records map{{"x0", "x1", "y0", "y1", "members", "solved"}};
  for (std::size_t q = 0; q < shown; ++q) map.columns.push_back("q" + std::to_string(q));
  for (std::size_t cell = 0; cell < members.size(); ++cell) {
    if (members[cell].empty()) continue;
    const auto [x0, x1] = sides[0].ends(cell % wide);
    const auto [y0, y1] = flat ? std::pair(0., 1.) : sides[1].ends(cell / wide);
    std::vector<record::Cell> row{x0, x1, y0, y1, std::uint64_t{members[cell].size()}};
    std::vector<std::vector<double>> values(shown);
    std::uint64_t solved = 0;
    for (const std::uint64_t member : members[cell]) {
      const double* const first = result.results.data() + member * all;
      bool ended = true;
      for (std::size_t q = 0; q < all; ++q)
        ended = ended && (std::isfinite(first[q]) ||
                          plan.quantities[q].kind == Quantity::Kind::error);  // may not be known
      solved += ended;
      for (std::size_t q = 0; q < shown; ++q) values[q].push_back(result.results[member * all + q]);
    }
    row.emplace_back(static_cast<double>(solved) / static_cast<double>(members[cell].size()));
    for (std::size_t q = 0; q < shown; ++q) row.emplace_back(quantiles(std::move(values[q]))[2]);
    map.rows.push_back(std::move(row));
  }
  return map;
}

}  // namespace

bool write_page(const record::OutputFolder& folder, const Joined& all, const std::string& text,
                const nlohmann::ordered_json& answers, const Asked& asked) {
  const Plan& plan = all.plan;
  const Result& result = all.result;
  folder.write("members.csv", result.csv);
  folder.write("sweep.json", answers.dump(2) + "\n");
  report::Report page({.cases = {}, .solvers = {}, .libraries = all_libraries()}, folder);
  trajectories::RunTexts texts{.title = plan.base->title,
                               .lead = plan.base->id,
                               .facts = {{"Equation", plan.base->equation}},
                               .command = "odeum sweep"};
  trajectories::add_lines(texts, text);
  nlohmann::ordered_json json = trajectories::page_facts("sweep", texts);
  json["quantities"] = nlohmann::ordered_json::array();
  for (const Quantity& quantity : plan.quantities) json["quantities"].push_back(quantity.name);
  json["over_time_members"] = result.over_time_members;
  const std::vector<Side> sides = sides_of(plan);
  json["sides"] = nlohmann::ordered_json::array();
  for (const Side& side : sides)
    json["sides"].push_back({{"name", plan.members.names()[side.name()]}, {"log", side.log()}});
  if (!sides.empty()) page.table("runs", "map", map_of(plan, result, sides));
  page.table("runs", "over_time", result.over_time);
  page.fact("runs", json);
  return page.write({.command_line = "odeum sweep " + asked.what});
}

}  // namespace odeum::sweep
