// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/cases/reference.hpp"

#include <charconv>
#include <filesystem>
#include <map>
#include <memory>
#include <stdexcept>
#include <string_view>

#include "odeum/input/text_file.hpp"

namespace odeum::cases {
namespace {

constexpr std::size_t most_reference_bytes = 64'000'000;

template <class Real>
Real number(std::string_view text, const std::string& name) {
  Real value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size())
    throw std::runtime_error("reference " + name + ": not a number: " + std::string(text));
  return value;
}

template <class Real>
using WayPoints = std::map<double, std::vector<Real>>;

/// Lines of `t,component,value` under a header line.
template <class Real>
WayPoints<Real> parse(std::string_view text, const std::string& name) {
  WayPoints<Real> way_points;
  text.remove_prefix(text.find('\n') + 1);
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    const std::size_t first = line.find(','), second = line.rfind(',');
    if (first == second) throw std::runtime_error("reference " + name + ": not three columns");
    auto& state = way_points[number<double>(line.substr(0, first), name)];
    if (number<double>(line.substr(first + 1, second - first - 1), name) !=
        static_cast<double>(state.size()))
      throw std::runtime_error("reference " + name + ": components out of order");
    state.push_back(number<Real>(line.substr(second + 1), name));
  }
  return way_points;
}

/// Looks the state at a time up in the file.
template <class Real>
std::function<bool(double, Real*)> lookup(std::string_view text, const std::string& name) {
  const auto way_points = std::make_shared<const WayPoints<Real>>(parse<Real>(text, name));
  return [way_points](double t, Real* y) {
    const auto found = way_points->find(t);
    if (found == way_points->end()) return false;
    std::ranges::copy(found->second, y);
    return true;
  };
}

}  // namespace

Truth reference_truth(const std::string& name, double floor, const std::string& folder) {
  Truth truth;
  truth.floor = floor;
  for (const char* ending : {"", ".csv"}) {
    const std::filesystem::path file = std::filesystem::path(folder) / (name + ending);
    if (folder.empty() || !std::filesystem::is_regular_file(file)) continue;
    truth.source = file.filename().string();
    truth.at = lookup<double>(read_text_file(file.string(), "reference", most_reference_bytes),
                              truth.source);
    return truth;
  }
  truth.source = "cases/reference/" + name + ".csv";
  truth.at = lookup<double>(reference_text(name), name);
  return truth;
}

std::function<bool(double t, long double* y)> extended_truth(const std::string& name) {
  return lookup<long double>(reference_text(name), name);
}

}  // namespace odeum::cases
