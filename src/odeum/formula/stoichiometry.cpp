// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/stoichiometry.hpp"

#include <algorithm>
#include <cmath>
#include <set>

namespace odeum::formula {
namespace {

using Real = long double;
constexpr Real rounding = 1e-12L;  // of numbers of the size of 1 after as many steps as species

void add(Weights& to, const Weights& other, Real factor) {
  for (const auto& [species, weight] : other) {
    const auto [at, is_new] = to.try_emplace(species, 0);
    at->second += factor * weight;
    if (std::abs(at->second) <= rounding) to.erase(at);
  }
}

/// What reactions make as a reduced basis: each has a species, its pivot, with the weight 1 that no
/// other one has. There are few other species in it, since sums are few.
class Made {
 public:
  void add_reaction(Weights made) {
    const Weights given = made;
    for (const auto& [species, weight] : given)
      if (const auto pivot = basis_.find(species); pivot != basis_.end())
        add(made, pivot->second, -weight);
    if (made.empty()) return;
    const auto [pivot, size] = *made.begin();
    for (auto& [species, weight] : made) weight /= size;
    if (const auto users = having_.find(pivot); users != having_.end())
      for (const std::uint32_t user : std::set<std::uint32_t>(users->second)) {
        Weights& row = basis_.at(user);
        const auto has = row.find(pivot);
        if (has == row.end()) continue;
        add(row, made, -Real(has->second));
        note(user, row);
      }
    having_.erase(pivot);
    note(pivot, made);
    basis_[pivot] = std::move(made);
  }

  /// For each species that is not a pivot, the sum of it and pivots.
  std::vector<Weights> sums(std::uint32_t species) const {
    std::vector<Weights> all;
    for (std::uint32_t free = 0; free < species; ++free) {
      if (basis_.contains(free)) continue;
      Weights sum{{free, 1}};
      if (const auto users = having_.find(free); users != having_.end())
        for (const std::uint32_t user : users->second)
          if (const auto at = basis_.at(user).find(free); at != basis_.at(user).end())
            sum[user] = -at->second;
      if (sum.size() > 1) all.push_back(std::move(sum));
    }
    return all;
  }

 private:
  void note(std::uint32_t pivot, const Weights& row) {
    for (const auto& [species, weight] : row)
      if (species != pivot) having_[species].insert(pivot);
  }

  std::map<std::uint32_t, Weights> basis_;                   ///< by pivot
  std::map<std::uint32_t, std::set<std::uint32_t>> having_;  ///< pivots by species; perhaps more
};

std::size_t negatives(const Weights& sum) {
  return static_cast<std::size_t>(
      std::ranges::count_if(sum, [](const auto& each) { return each.second < 0; }));
}

/// Adds other sums until none has fewer negative weights thereby.
void without_negatives(std::vector<Weights>& sums) {
  for (Weights& sum : sums)
    for (bool better = negatives(sum) > 0; better;) {
      better = false;
      for (const Weights& other : sums) {
        if (&other == &sum || negatives(other) > 0) continue;
        const auto needed = std::ranges::find_if(
            sum, [&](const auto& each) { return each.second < 0 && other.contains(each.first); });
        if (needed == sum.end()) continue;
        Weights sought = sum;
        add(sought, other, -needed->second / other.at(needed->first));
        if (negatives(sought) >= negatives(sum)) continue;
        sum = std::move(sought);
        better = true;
        break;
      }
    }
}

/// As whole numbers, where a factor up to 12 makes them so.
void make_whole(Weights& sum) {
  Real least = std::abs(sum.begin()->second);
  for (const auto& [species, weight] : sum) least = std::min(least, std::abs(weight));
  const bool negative = 2 * negatives(sum) > sum.size();
  for (auto& [species, weight] : sum) weight /= negative ? -least : least;
  for (int factor = 1; factor <= 12; ++factor) {
    const auto near = [factor](const auto& each) {
      const Real value = factor * each.second;
      return std::abs(value - std::round(value)) <= 1e-9L * std::abs(value);
    };
    if (!std::ranges::all_of(sum, near)) continue;
    for (auto& [species, weight] : sum) weight = std::round(factor * weight);
    return;
  }
}

}  // namespace

std::vector<Weights> conserved_sums(std::uint32_t species, const std::vector<Weights>& reactions) {
  Made made;
  for (const Weights& each : std::set<Weights>(reactions.begin(), reactions.end()))
    made.add_reaction(each);
  std::vector<Weights> sums = made.sums(species);
  without_negatives(sums);
  for (Weights& sum : sums) make_whole(sum);
  std::ranges::sort(sums, {}, [](const Weights& sum) { return sum.begin()->first; });
  return sums;
}

}  // namespace odeum::formula
