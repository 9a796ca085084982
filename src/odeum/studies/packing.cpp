// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/packing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <queue>
#include <sstream>
#include <tuple>

namespace odeum::study {
namespace {

double length_of(const PlannedTasks& foreseen, const std::vector<std::size_t>& tasks) {
  double sum = 0;
  for (const std::size_t task : tasks) sum += foreseen.seconds[task];
  return sum;
}

/// Adds shards of these tasks to the packing.
void add_shards(const PlannedTasks& foreseen, std::vector<std::size_t> tasks, double wanted,
                Packing& packing) {
  if (tasks.empty()) return;
  const auto count = static_cast<std::size_t>(
      std::clamp(std::ceil(wanted), 1., static_cast<double>(tasks.size())));
  std::ranges::stable_sort(tasks, [&](std::size_t a, std::size_t b) {
    return foreseen.seconds[a] > foreseen.seconds[b];
  });
  struct Bin {
    double seconds = 0;
    std::vector<std::size_t> tasks = {};
  };
  std::vector<Bin> bins(count);
  using Load = std::tuple<double, std::size_t, std::size_t>;  // seconds, tasks, bin
  std::priority_queue<Load, std::vector<Load>, std::greater<>> loads;
  for (std::size_t k = 0; k < count; ++k) loads.emplace(0, 0, k);
  for (const std::size_t task : tasks) {
    const auto [seconds, held, at] = loads.top();
    loads.pop();
    Bin& bin = bins[at];
    bin.seconds += foreseen.seconds[task];
    bin.tasks.push_back(task);
    loads.emplace(bin.seconds, bin.tasks.size(), at);
  }
  std::ranges::stable_sort(bins, [](const Bin& a, const Bin& b) { return a.seconds > b.seconds; });
  for (const Bin& bin : bins) {
    for (const std::size_t task : bin.tasks)
      packing.shares[task] = static_cast<std::uint32_t>(packing.seconds.size());
    packing.seconds.push_back(bin.seconds);
  }
}

}  // namespace

Packing pack(const PlannedTasks& foreseen, double shards) {
  std::vector<std::size_t> beside, alone;
  for (std::size_t task = 0; task < foreseen.seconds.size(); ++task)
    (foreseen.alone[task] ? alone : beside).push_back(task);
  // One shard has all, alone on its machine.
  if (shards < 2 && !alone.empty()) {
    alone.insert(alone.end(), beside.begin(), beside.end());
    beside.clear();
  }
  Packing packing;
  packing.shares.resize(foreseen.seconds.size());
  const double of_alone = length_of(foreseen, alone), of_beside = length_of(foreseen, beside),
               part = of_alone / std::max(of_alone + of_beside, 1e-30);
  const double for_alone =
      alone.empty()    ? 0
      : beside.empty() ? shards
                       : std::clamp(std::round(part * shards), 1., std::max(1., shards - 1));
  add_shards(foreseen, beside, shards - for_alone, packing);
  packing.first_alone = packing.seconds.size();
  add_shards(foreseen, alone, for_alone, packing);
  return packing;
}

std::string text_of_shares(const std::vector<std::uint32_t>& shares) {
  return fmt::format("{}", fmt::join(shares, " "));
}

std::vector<std::uint32_t> shares_of(const std::string& text) {
  std::istringstream in(text);
  return {std::istream_iterator<std::uint32_t>(in), {}};
}

}  // namespace odeum::study
