// SPDX-License-Identifier: BSD-3-Clause
#include "fmi/model.hpp"

#include <dlfcn.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "fmi/inputs.hpp"
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

}  // namespace

Binary::Binary(Purpose purpose, const Description& d, const fs::path& folder) {
  const std::string& name = purpose == Purpose::co_simulation ? d.co_simulation : d.identifier;
  const std::string platform = platforms[d.version - 2];
  const fs::path file = folder / "binaries" / platform / (name + ".so");
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) {
    std::set<std::string> others;
    for (const auto& entry : fs::directory_iterator(folder / "binaries", ignored))
      others.insert(entry.path().filename().string());
    throw LoadError(
        fmt::format("has no binary for this machine: no binaries/{}/{}.so; {}", platform, name,
                    others.empty() ? "it has none at all"
                                   : fmt::format("it has those for {}", fmt::join(others, ", "))));
  }
  handle_ = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle_) throw LoadError(fmt::format("cannot be loaded: {}", dlerror()));
}

void* Binary::found(const std::string& name) const { return dlsym(handle_, name.c_str()); }

void* Binary::symbol(const std::string& name) const {
  void* const there = found(name);
  if (!there) throw LoadError(fmt::format("its binary exports no function {}", name));
  return there;
}

Model::~Model() {
  if (!self_) return;
  if (void* const release = binary_.found(prefix_ + "FreeInstance"))
    reinterpret_cast<void (*)(void*)>(release)(self_);
}

int Model::place(double t, const double* y) {
  // No model goes back behind an event, or before its start.
  if (const int failed = wrong(set_time(std::max(t, event_)))) return failed;
  if (inputs_)
    for (const Inputs::Column& column : inputs_->columns())
      if (column.linear)
        if (const int failed = wrong(put(column.variable, inputs_->at(column, t, passed_))))
          return failed;
  return has_states ? wrong(set_states(y)) : 0;
}

int Model::rhs(double t, const double* y, double* dydt) {
  if (const int failed = place(t, y)) return failed;
  if (has_states) return wrong(derivatives(dydt));
  std::fill_n(dydt, y0.size(), 0.0);
  return 0;
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

int Model::indicate(double t, const double* y, double* values) {
  if (indicators == 0) return 0;
  const int failed = place(t, y);
  return failed ? failed : wrong(get_indicators(values));
}

int Model::observe(double t, double* y) {
  if (has_states) return 0;
  if (const int failed = place(t, y)) return failed;
  read(description_.outputs, y);
  return 0;
}

void Model::read(const std::vector<std::size_t>& variables, double* y) {
  for (const std::size_t i : variables) *y++ = get(description_.variables[i]);
}

void Model::step(double t, double h, double* y) {
  if (inputs_) set_inputs(t);
  if (!do_step(t, h)) throw LoadError("the model ends its simulation");
  read(has_states ? description_.states : description_.outputs, y);
}

void Model::call(const char* name) {
  require(binary_.function<int (*)(void*)>(prefix_ + name)(self_), prefix_ + name);
}

EventInfo Model::update() {
  constexpr int most = 1000;
  bool states = false;
  for (int k = 0; k < most; ++k) {
    EventInfo info;
    require(update_discrete_states(info), "the update of discrete states");
    states = states || info.states;
    if (info.more && !info.terminate) continue;
    info.states = states;
    return info;
  }
  throw LoadError(fmt::format("an event at t = {:.9g} asks for new discrete states without end",
                              std::max(event_, description_.t0)));
}

bool Model::step_asks() {
  bool event = false, end = false;
  require(complete_step(event, end), prefix_ + "CompletedIntegratorStep");
  return event || end;
}

void Model::begin_steps() {
  if (description_.has_arrays)
    throw LoadError("co-simulation: its states are arrays, which are not read");
  has_states = !description_.states.empty();
  const std::vector<std::size_t>& shown = has_states ? description_.states : description_.outputs;
  y0.resize(shown.size());
  read(shown, y0.data());
}

void Model::initialise(Purpose purpose, const Values& values) {
  for (const Setting& setting : settings_of(description_, values)) set(setting);
  if (inputs_) set_inputs(description_.t0);
  enter_initialisation();
  call("ExitInitializationMode");
  if (purpose == Purpose::co_simulation) return begin_steps();
  start = update();
  if (start.terminate) throw LoadError("ends its simulation when it is initialised");
  call("EnterContinuousTimeMode");
  const std::size_t n = count_states();
  has_states = n > 0;
  if (description_.has_indicators) indicators = count_indicators();
  event_ = description_.t0;
  y0.resize(has_states ? n : description_.outputs.size());
  if (y0.empty()) throw LoadError("the model has no continuous states, and no outputs in numbers");
  if (!has_states) return read(description_.outputs, y0.data());
  asks_at_start = step_asks();
  require(get_states(y0.data()), prefix_ + "GetContinuousStates");
}

void Model::set_inputs(double t) {
  passed_ = t;
  for (const Inputs::Column& column : inputs_->columns())
    set({&column.variable, inputs_->start(column, t), "input "});
}

EventInfo Model::happen(double t, double* y, double jump) {
  require(place(t, y), "placing the model at an event");
  if (has_states && description_.completes_steps) step_asks();
  call("EnterEventMode");
  event_ = std::max(t, event_);
  if (jump > passed_) set_inputs(jump);
  const EventInfo info = update();
  if (!info.terminate) call("EnterContinuousTimeMode");
  if (!has_states)
    read(description_.outputs, y);
  else if (info.states)
    require(get_states(y), prefix_ + "GetContinuousStates");
  return info;
}

bool Model::completes(double t, const double* y) {
  require(place(t, y), "placing the model at the end of a step");
  return step_asks();
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
    settings.push_back({found, text, "--set "});
  }
  return settings;
}

std::string& last_message() {
  static std::string text;
  return text;
}

void require(int status, const std::string& function) {
  if (status == 0 || status == 1) return;
  constexpr const char* names[] = {"ok", "warning", "discard", "error", "fatal", "pending"};
  throw LoadError(fmt::format("{} returned {}{}{}", function,
                              status > 0 && status < 6 ? names[status] : std::to_string(status),
                              last_message().empty() ? "" : ": ", last_message()));
}

std::unique_ptr<Model> make_model(Purpose purpose, const Description& d, const fs::path& folder,
                                  const Values& values, const Inputs* inputs) {
  const Binary binary(purpose, d, folder);
  last_message().clear();
  return d.version == 2 ? make_model2(purpose, d, binary, folder, values, inputs)
                        : make_model3(purpose, d, binary, folder, values, inputs);
}

}  // namespace odeum::adapters::fmi
