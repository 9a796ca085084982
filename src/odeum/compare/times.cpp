// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/compare/times.hpp"

#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>
#include <vector>

#include "odeum/core/interrupt.hpp"
#include "odeum/core/parallel.hpp"

namespace odeum::compare {
namespace {

double seconds_of(const std::string& command, const std::function<double()>& clock) {
  const double before = clock();
  const int status = std::system(("{ " + command + "\n} >/dev/null 2>&1 </dev/null").c_str());
  if (interrupted) throw Interrupted();
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (code != 0) throw std::invalid_argument(fmt::format("{}: exit code {}", command, code));
  return clock() - before;
}

/// How many of the sorted ratios lie outside of the interval at each end: the sign test, 99.9 %.
std::size_t outside(std::size_t pairs) {
  constexpr double sure = 0.0005;
  double tail = 0, term = std::pow(0.5, static_cast<double>(pairs));
  std::size_t k = 0;
  for (; k < pairs / 2; ++k) {
    tail += term;
    if (tail > sure) break;
    term *= static_cast<double>(pairs - k) / static_cast<double>(k + 1);
  }
  return k;
}

double median(std::vector<double> values) {
  std::ranges::sort(values);
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
}

}  // namespace

double children_seconds() {
  rusage usage{};
  getrusage(RUSAGE_CHILDREN, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

TimesRow compare_times(const std::string& before, const std::string& after, std::size_t pairs,
                       const std::function<double()>& clock) {
  TimesRow row;
  row.before = before;
  row.after = after;
  seconds_of(before, clock);
  seconds_of(after, clock);
  std::vector<double> was, is, ratios;
  for (std::size_t k = 0; k < pairs; ++k) {
    const bool turned = k % 2 == 1;
    const double first = seconds_of(turned ? after : before, clock);
    const double second = seconds_of(turned ? before : after, clock);
    was.push_back(turned ? second : first);
    is.push_back(turned ? first : second);
    ratios.push_back(is.back() / was.back());
  }
  row.pairs = static_cast<double>(pairs);
  row.before_seconds = median(was);
  row.after_seconds = median(is);
  row.ratio = median(ratios);
  std::ranges::sort(ratios);
  if (const std::size_t out = outside(pairs); out > 0) {
    row.ratio_low = ratios[out - 1];
    row.ratio_high = ratios[pairs - out];
  }
  return row;
}

}  // namespace odeum::compare
