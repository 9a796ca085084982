// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/studies/runner.hpp"

#include <charconv>
#include <chrono>
#include <cmath>

#include "odeum/cases/catalogue.hpp"
#include "odeum/core/glob.hpp"
#include "odeum/core/interrupt.hpp"
#include "odeum/record/csv.hpp"
#include "odeum/solvers/pieces.hpp"

namespace odeum::study {

void PlannedTasks::add(std::size_t tasks, const std::function<double(std::size_t)>& earlier_of,
                       const std::function<void(std::size_t)>& work) {
  constexpr std::size_t most = 32, one_of = 64;
  constexpr double most_seconds = 5;
  std::vector<double> known(tasks);
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < tasks; ++i) {
    if (interrupted) throw Interrupted();
    known[i] = earlier_of(i);
    std::isnan(known[i]) ? open.push_back(i) : void(++earlier);
  }
  using Clock = std::chrono::steady_clock;
  const auto since = [](Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
  };
  const Clock::time_point start = Clock::now();
  const std::size_t sample =
      work ? std::min(open.size(), std::clamp<std::size_t>(tasks / one_of, 1, most)) : 0;
  // In the order of a golden ratio, so that they are spread wherever the seconds end.
  for (std::size_t k = 0; k < sample && since(start) < most_seconds; ++k) {
    const double part = std::fmod(0.5 + 0.6180339887498949 * static_cast<double>(k), 1);
    const std::size_t i = open[static_cast<std::size_t>(part * static_cast<double>(open.size()))];
    if (!std::isnan(known[i])) continue;
    if (interrupted) throw Interrupted();
    const double begin = thread_seconds();
    work(i);
    known[i] = thread_seconds() - begin;
    ++timed;
  }
  alone.insert(alone.end(), tasks, !work);
  for (std::size_t i = 0, last = tasks, next = 0; i < tasks; ++i) {
    if (!std::isnan(known[i])) last = i;
    for (next = std::max(next, i); next < tasks && std::isnan(known[next]);) ++next;
    const bool nearer = last < tasks && (next >= tasks || i - last <= next - i);
    seconds.push_back(nearer ? known[last] : next < tasks ? known[next] : 1);
  }
}

const std::string& Runner::dependencies_of(const Pair& pair) const {
  const bool built_in = !cache_.dependencies_of_built_in.empty() && is_built_in(*pair.c);
  return built_in ? cache_.dependencies_of_built_in : cache_.dependencies;
}

double Runner::seconds_of(const std::string& name) const {
  if (!cache_.seconds) return nan;
  const std::string text = cache_.seconds->take(cache_.settings, name).value_or("");
  double seconds = nan;
  std::from_chars(text.data(), text.data() + text.size(), seconds);
  return seconds;
}

void Runner::keep_seconds(const std::string& name, double seconds) const {
  if (cache_.seconds) cache_.seconds->add(cache_.settings, name, record::format_number(seconds));
}

std::vector<const Case*> select_cases(const std::vector<std::string>& globs) {
  std::vector<const Case*> cases;
  for (const std::string& id : known_ids())
    if (any_glob_matches(globs, id)) cases.push_back(&known_case(id));
  return cases;
}

std::vector<Pair> select_pairs(const std::vector<const Case*>& cases,
                               const std::vector<std::string>& solver_globs) {
  std::vector<Pair> pairs;
  std::vector<std::string> of_second = solver_globs;
  std::erase_if(of_second, [](const std::string& glob) { return !glob.ends_with(as_it_comes); });
  for (const Case* c : cases)
    for (std::size_t k = 0; k < c->entrants.size(); ++k) {
      const std::string id = c->entrants.info(k).id(), second = id + std::string(as_it_comes);
      if (any_glob_matches(solver_globs, id)) pairs.push_back({c, &c->entrants[k]});
      if (!of_second.empty() && any_glob_matches(of_second, second))
        if (const Entrant* const entrant = c->entrants.find(second)) pairs.push_back({c, entrant});
    }
  return pairs;
}

const Entrant& find_solver(const Entrants& entrants, const std::string& id) {
  if (const Entrant* const entrant = entrants.find(id)) return *entrant;
  throw std::out_of_range("no solver " + id);
}

std::string key_of(const Pair& pair) {
  return pair.c->id + ' ' + pair.entrant->info.id() + ' ' + to_string(pair.mode);
}

}  // namespace odeum::study
