// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/sweep/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <mutex>
#include <stdexcept>

#include "odeum/core/clocks.hpp"
#include "odeum/core/parallel.hpp"
#include "odeum/core/progress.hpp"
#include "odeum/input/near_words.hpp"
#include "odeum/sweep/part.hpp"
#include "odeum/sweep/runner.hpp"

namespace odeum::sweep {
namespace {

class Sweep {
 public:
  explicit Sweep(const Plan& plan) : plan_(plan), runners_(plan) {}

  Result run() {
    const auto start = std::chrono::steady_clock::now();
    // The same on every machine: a shard has some of these parts.
    // Members of a part run in lanes, several registers of them at a time.
    constexpr std::uint64_t most_parts = 512, most_together = 512, block = 64;
    const std::uint64_t size = plan_.members.size(),
                        share_of_all = (size + most_parts - 1) / most_parts;
    const std::uint64_t together =
        share_of_all <= block / 4
            ? std::max<std::uint64_t>(share_of_all, 1)
            : std::min(most_together, (share_of_all + block - 1) / block * block);
    const auto parts = static_cast<std::size_t>((size + together - 1) / together);
    result_.size = size;
    const study::Share& share = plan_.kept.share;
    result_.one_code = runners_.in_place();
    result_.results.assign(size * plan_.quantities.size(), nan);
    const auto ends_of = [&](std::size_t part) {
      return std::pair(part * together, std::min(size, (part + 1) * together));
    };
    if (share.plan) {
      foresee(parts, together);
      return std::move(result_);
    }
    const std::uint64_t begun = share.begin(parts);
    result_.csv = header();
    Progress progress("sweep", static_cast<double>(size));
    std::vector<Part> done(parts);
    std::vector<bool> ready(parts, false);
    std::size_t written = 0;
    std::mutex mutex;
    parallel_for(parts, plan_.study && plan_.study->timed ? 1 : plan_.jobs, [&](std::size_t k) {
      const auto [first, last] = ends_of(k);
      Part part = share.has(begun + k) ? kept_or_run(first, last) : Part();
      progress.advance(static_cast<double>(last - first));
      const std::lock_guard lock(mutex);
      done[k] = std::move(part);
      ready[k] = true;
      for (; written < parts && ready[written]; ++written) take(std::exchange(done[written], {}));
    });
    for (std::size_t q = 0; q < plan_.quantities.size(); ++q) {
      std::vector<double> values;
      for (std::uint64_t member = 0; member < size; ++member)
        values.push_back(result_.results[member * plan_.quantities.size() + q]);
      result_.quantiles.push_back(quantiles(std::move(values)));
    }
    result_.seconds = seconds_since(start);
    return std::move(result_);
  }

 private:
  /// Adds the parts to the plan. Of one that is timed some members stand for all.
  void foresee(std::size_t parts, std::uint64_t together) {
    study::PlannedTasks& planned = *plan_.kept.share.plan;
    const auto none = [](std::size_t) { return nan; };
    if (plan_.study && plan_.study->timed) return planned.add(parts, none, {});
    const std::uint64_t some = std::max<std::uint64_t>(together / 4, 1);
    const auto before = static_cast<std::ptrdiff_t>(planned.seconds.size());
    planned.add(parts, none, [&](std::size_t k) {
      run_part(k * together, std::min(k * together + some, plan_.members.size()));
    });
    std::for_each(planned.seconds.begin() + before, planned.seconds.end(), [&](double& each) {
      each *= static_cast<double>(together) / static_cast<double>(some);
    });
  }

  std::string header() const {
    std::string text = "schema,member,solver";
    for (const std::string& name : plan_.members.names()) text += ',' + record::format_text(name);
    text += ",status,detail";
    for (const Quantity& quantity : plan_.quantities)
      text += ',' + record::format_text(quantity.name);
    return text + ",rhs_evaluations\n";
  }

  void take(const Part& part) {
    result_.csv += part.lines;
    result_.solved += part.solved;
    result_.evaluations += part.evaluations;
    for (const auto& [status, ending] : part.endings) add_ending(result_.endings, status, ending);
  }

  Part kept_or_run(std::uint64_t first, std::uint64_t last) {
    const study::ResultCache& kept = plan_.kept;
    if (!kept.store) return run_part(first, last);
    const std::string key = fmt::format("{} members {} to {}", plan_.solver, first, last);
    if (const auto text = kept.store->take(kept.dependencies, key))
      return part_of(*text, plan_, first, last,
                     result_.results.data() + first * plan_.quantities.size());
    if (kept.share.all_kept) throw study::ResultLost("the shards lack " + key);
    Part part = run_part(first, last);
    if (interrupted) throw Interrupted();
    kept.store->add(kept.dependencies, key, text_of(part));
    return part;
  }

  Part run_part(std::uint64_t first, std::uint64_t last) {
    const std::shared_ptr<Runner> runner = runners_.lend();
    Part part;
    std::vector<Outcome> in_lanes = runner->run_in_lanes(first, last);
    const bool needs_energy = std::ranges::any_of(
        plan_.quantities, [](const Quantity& q) { return q.kind == Quantity::Kind::energy; });
    for (std::uint64_t member = first; member < last && !interrupted; ++member) {
      MemberRow row;
      if (plan_.study) {
        row = runner->measure(parameters_of(plan_, member));
      } else {
        const bool lanes = !in_lanes.empty() && in_lanes[member - first].status == Status::ok;
        const Outcome outcome = lanes ? std::move(in_lanes[member - first])
                                      : runner->run(parameters_of(plan_, member), plan_.request);
        if (lanes && needs_energy) runner->place(parameters_of(plan_, member));
        row = row_of(*runner, parameters_of(plan_, member), outcome);
      }
      const bool ok = row.status == to_string(Status::ok);
      part.solved += ok;
      part.evaluations += row.evaluations;
      if (const std::string& ending = plan_.study ? row.answer : row.status;
          ending != to_string(Status::ok))
        add_ending(part.endings, ending, {1, member, row.detail});
      part.lines += fmt::format("{},{},{}", record::csv_schema, member, row.solver);
      for (const double value : plan_.members.values(member))
        part.lines += ',' + record::format_number(value);
      part.lines += fmt::format(",{},{}", row.status,
                                row.detail.empty() ? "" : record::format_text(row.detail));
      double* const results = result_.results.data() + member * plan_.quantities.size();
      for (std::size_t q = 0; q < plan_.quantities.size(); ++q) {
        if (!row.values.empty()) results[q] = row.values[q];
        part.lines += ',' + record::format_number(results[q]);
      }
      part.lines += fmt::format(",{}\n", row.evaluations);
    }
    return part;
  }

  MemberRow row_of(Runner& runner, const std::vector<double>& values,
                   const Outcome& outcome) const {
    MemberRow row{plan_.solver, to_string(outcome.status), outcome.detail};
    row.evaluations = outcome.counters.rhs_evaluations;
    if (outcome.status == Status::ok)
      for (const Quantity& quantity : plan_.quantities)
        row.values.push_back(runner.value(quantity, values, outcome));
    return row;
  }

  const Plan& plan_;
  Runners runners_;
  Result result_;
};

}  // namespace

Quantiles quantiles(std::vector<double> values) {
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  Quantiles found;
  found.fill(nan);
  if (values.empty()) return found;
  constexpr std::array<double, 5> parts{0, 0.05, 0.5, 0.95, 1};
  auto from = values.begin();
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const auto at = values.begin() +
                    static_cast<std::ptrdiff_t>(parts[k] * static_cast<double>(values.size() - 1));
    if (at >= from) std::nth_element(from, at, values.end());
    found[k] = *at;
    from = at;
  }
  return found;
}

std::vector<double> parameters_of(const Plan& plan, std::uint64_t member) {
  std::vector<double> values;
  for (const Parameter& parameter : plan.base->parameters) values.push_back(parameter.value);
  const std::vector<double> own = plan.members.values(member);
  for (std::size_t k = 0; k < own.size(); ++k) {
    const auto& all = plan.base->parameters;
    const auto at = std::ranges::find_if(
        all, [&](const Parameter& each) { return each.name == plan.members.names()[k]; });
    values[static_cast<std::size_t>(at - all.begin())] = own[k];
  }
  return values;
}

std::uint64_t spread(const Plan& plan, std::uint64_t k, std::uint64_t count) {
  return count < 2 ? 0 : k * (plan.members.size() - 1) / (count - 1);
}

const Entrant& fitting(const Entrants& entrants, const std::string& solver) {
  const Entrant* const entrant = entrants.find(solver);
  if (entrant && entrant->solve) return *entrant;
  throw std::invalid_argument("the solver does not fit: " + (entrant ? entrant->unfit : solver));
}

std::string sets_of(const Plan& plan, std::uint64_t member) {
  const std::vector<double> own = plan.members.values(member);
  std::string text;
  for (std::size_t k = 0; k < own.size(); ++k)
    text += fmt::format(" --set {}={}", plan.members.names()[k], own[k]);
  return text;
}

Result run(const Plan& plan) {
  std::vector<std::string> known;
  for (const Parameter& parameter : plan.base->parameters) known.push_back(parameter.name);
  for (const std::string& name : plan.members.names())
    if (std::ranges::find(known, name) == known.end())
      throw std::invalid_argument(known.empty()
                                      ? fmt::format("{} has no parameters", plan.base->id)
                                      : fmt::format("{} has no parameter {}; expected {}",
                                                    plan.base->id, name, one_of(known, name)));
  Result result = Sweep(plan).run();
  if (plan.kept.share.shares || plan.kept.share.plan || plan.study) return result;
  check_members(plan, result);
  if (!plan.over_time.stops.empty()) add_over_time(plan, result);
  return result;
}

}  // namespace odeum::sweep
