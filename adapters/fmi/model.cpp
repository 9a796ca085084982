// SPDX-License-Identifier: BSD-3-Clause
#include "fmi/model.hpp"

#include <dlfcn.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <set>

#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::adapters::fmi {
namespace {

namespace fs = std::filesystem;

#if defined(__x86_64__) && defined(__linux__)
constexpr const char* platforms[] = {"linux64", "x86_64-linux"};
#elif defined(__aarch64__) && defined(__linux__)
constexpr const char* platforms[] = {"aarch64-linux", "aarch64-linux"};
#else
constexpr const char* platforms[] = {"unknown", "unknown"};
#endif

template <class Number>
Number parsed(const Setting& setting, const char* expected) {
  const char* const first = setting.text.data();
  const char* const last = first + setting.text.size();
  Number value{};
  const auto [end, error] = std::from_chars(first, last, value);
  if (error != std::errc{} || end != last)
    throw LoadError(fmt::format("--set {}: got \"{}\", expected {}", setting.variable->name,
                                foreign::cleaned(setting.text.c_str()), expected));
  return value;
}

}  // namespace

Binary::Binary(const Description& d, const fs::path& folder) {
  const std::string platform = platforms[d.version - 2];
  const fs::path file = folder / "binaries" / platform / (d.identifier + ".so");
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) {
    std::set<std::string> others;
    for (const auto& entry : fs::directory_iterator(folder / "binaries", ignored))
      others.insert(entry.path().filename().string());
    throw LoadError(fmt::format(
        "has no binary for this machine: no binaries/{}/{}.so; {}", platform, d.identifier,
        others.empty() ? "it has none at all"
                       : fmt::format("it has those for {}", fmt::join(others, ", "))));
  }
  handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle_) throw LoadError(fmt::format("cannot be loaded: {}", dlerror()));
}

void* Binary::symbol(const std::string& name) const {
  void* const found = dlsym(handle_, name.c_str());
  if (!found) throw LoadError(fmt::format("its binary exports no function {}", name));
  return found;
}

int Model::jacobian(double t, const double* y, double* j) {
  const std::size_t n = y0.size();
  if (const int failed = place(t, y)) return failed;
  std::vector<double> out(n);
  for (std::size_t k = 0; k < n; ++k) {
    if (const int failed = column(k, out.data())) return failed;
    for (std::size_t i = 0; i < n; ++i) j[i * n + k] = out[i];
  }
  return 0;
}

double Setting::real() const { return parsed<double>(*this, "a number"); }

long long Setting::integer(long long least, long long most) const {
  const auto value = parsed<long long>(*this, "a whole number");
  if (value < least || value > most)
    throw LoadError(
        fmt::format("--set {}: got {}, expected {} to {}", variable->name, value, least, most));
  return value;
}

bool Setting::boolean() const {
  if (text == "true" || text == "1") return true;
  if (text == "false" || text == "0") return false;
  throw LoadError(fmt::format("--set {}: got \"{}\", expected true or false", variable->name,
                              foreign::cleaned(text.c_str())));
}

std::vector<Setting> settings_of(const Description& description, const Values& values) {
  std::vector<Setting> settings;
  for (const auto& [name, text] : values) {
    const Variable* found = nullptr;
    std::vector<std::string> names;
    for (const Variable& v : description.variables) {
      if (v.name == name) found = &v;
      if (v.settable && !v.is_array && names.size() < 20) names.push_back(v.name);
    }
    if (!found)
      throw LoadError(fmt::format(
          "--set: the model has no variable {}; {}", foreign::cleaned(name.c_str()),
          names.empty() ? "none can be set" : fmt::format("it has {}", fmt::join(names, ", "))));
    if (!found->settable || found->is_array)
      throw LoadError(fmt::format("--set: {} {}; {} can", name,
                                  found->is_array ? "is an array, which cannot be set"
                                                  : "is computed or constant and cannot be set",
                                  fmt::join(names, ", ")));
    settings.push_back({found, text});
  }
  return settings;
}

std::string& last_message() {
  static std::string text;
  return text;
}

void require(int status, const char* function) {
  if (status == 0 || status == 1) return;
  constexpr const char* names[] = {"ok", "warning", "discard", "error", "fatal", "pending"};
  throw LoadError(fmt::format("{} returned {}{}{}", function,
                              status > 0 && status < 6 ? names[status] : std::to_string(status),
                              last_message().empty() ? "" : ": ", last_message()));
}

void refuse_events(bool next_event_time, double when, bool terminate, bool at_steps) {
  if (next_event_time)
    throw LoadError(
        fmt::format("has time events (the first at t = {}), which are not followed", when));
  if (terminate) throw LoadError("ends its simulation when it is initialised");
  if (at_steps) throw LoadError("has events at the end of steps, which are not followed");
}

std::unique_ptr<Model> make_model(const Description& d, const fs::path& folder,
                                  const Values& values) {
  const Binary binary(d, folder);
  last_message().clear();
  return d.version == 2 ? make_model2(d, binary, folder, values)
                        : make_model3(d, binary, folder, values);
}

}  // namespace odeum::adapters::fmi
