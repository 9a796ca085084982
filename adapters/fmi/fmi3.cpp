// SPDX-License-Identifier: BSD-3-Clause
// FMI 3.0 (Modelica Association, "Functional Mock-up Interface 3.0.2", sections 2.2 and 3.2): what
// an importer for Model Exchange calls, declared from the standard's text.
#include <fmt/format.h>

#include <cstdint>
#include <type_traits>

#include "fmi/model.hpp"
#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::adapters::fmi {
namespace {

extern "C" {
using Logger = void (*)(void* environment, int status, const char* category, const char* message);
using GetVersion = const char* (*)();
using Instantiate = void* (*)(const char* name, const char* token, const char* resources,
                              bool visible, bool logging, void* environment, Logger);
using InstantiateSteps = void* (*)(const char* name, const char* token, const char* resources,
                                   bool visible, bool logging, bool event_mode, bool early_return,
                                   const std::uint32_t* intermediate, std::size_t,
                                   void* environment, Logger, void* intermediate_update);
using DoStep = int (*)(void*, double t, double h, bool no_return, bool* event, bool* terminate,
                       bool* early, double* reached);
using EnterInitialisation = int (*)(void*, bool tolerance_defined, double tolerance, double start,
                                    bool stop_defined, double stop);
using UpdateDiscreteStates = int (*)(void*, bool* more_needed, bool* terminate, bool* nominals,
                                     bool* states, bool* next_time_defined, double* next_time);
using CompletedStep = int (*)(void*, bool no_return, bool* event_mode, bool* terminate);
using Count = int (*)(void*, std::size_t*);
using SetTime = int (*)(void*, double t);
using SetStates = int (*)(void*, const double* y, std::size_t n);
using GetNumbers = int (*)(void*, double* values, std::size_t n);
using Directional = int (*)(void*, const std::uint32_t* unknowns, std::size_t,
                            const std::uint32_t* knowns, std::size_t, const double* seed,
                            std::size_t, double* sensitivity, std::size_t);
}

void note(void*, int status, const char*, const char* message) {
  if (status >= 2 && message) last_message() = foreign::cleaned(message);
}

template <class Value>
constexpr const char* type_name() {
  if constexpr (std::is_same_v<Value, double>) return "Float64";
  if constexpr (std::is_same_v<Value, float>) return "Float32";
  if constexpr (std::is_same_v<Value, bool>) return "Boolean";
  if constexpr (std::is_same_v<Value, std::int8_t>) return "Int8";
  if constexpr (std::is_same_v<Value, std::uint8_t>) return "UInt8";
  if constexpr (std::is_same_v<Value, std::int16_t>) return "Int16";
  if constexpr (std::is_same_v<Value, std::uint16_t>) return "UInt16";
  if constexpr (std::is_same_v<Value, std::int32_t>) return "Int32";
  if constexpr (std::is_same_v<Value, std::uint32_t>) return "UInt32";
  if constexpr (std::is_same_v<Value, std::int64_t>) return "Int64";
  if constexpr (std::is_same_v<Value, std::uint64_t>) return "UInt64";
}

class Fmi3 final : public Model {
 public:
  Fmi3(Purpose purpose, const Description& d, const Binary& binary,
       const std::filesystem::path& folder, const Values& values, const Inputs* inputs)
      : Model("fmi3", d, binary, inputs) {
    const std::string version = binary.function<GetVersion>("fmi3GetVersion")();
    if (!version.starts_with("3."))
      throw LoadError(fmt::format("its binary is of FMI version \"{}\", its description of 3.0",
                                  foreign::cleaned(version.c_str())));
    const bool steps_itself = purpose == Purpose::co_simulation;
    if (steps_itself) {
      do_step_ = binary.function<DoStep>("fmi3DoStep");
    } else {
      set_time_ = binary.function<SetTime>("fmi3SetTime");
      complete_step_ = binary.function<CompletedStep>("fmi3CompletedIntegratorStep");
    }
    if (!steps_itself && !d.states.empty()) {
      set_states_ = binary.function<SetStates>("fmi3SetContinuousStates");
      derivatives_ = binary.function<GetNumbers>("fmi3GetContinuousStateDerivatives");
    }
    const std::string resources = (folder / "resources").string() + "/";
    const char* const maker =
        steps_itself ? "fmi3InstantiateCoSimulation" : "fmi3InstantiateModelExchange";
    self_ = steps_itself ? binary.function<InstantiateSteps>(maker)(
                               d.model.c_str(), d.token.c_str(), resources.c_str(), false, false,
                               false, false, nullptr, 0, nullptr, note, nullptr)
                         : binary.function<Instantiate>(maker)(d.model.c_str(), d.token.c_str(),
                                                               resources.c_str(), false, false,
                                                               nullptr, note);
    if (!self_)
      throw LoadError(
          fmt::format("{} failed{}{}", maker, last_message().empty() ? "" : ": ", last_message()));
    initialise(purpose, values);
    if (!steps_itself && d.directional_derivatives && has_states && !d.has_arrays) {
      directional_ = binary.function<Directional>("fmi3GetDirectionalDerivative");
      for (const std::size_t i : d.states) states_.push_back(d.variables[i].reference);
      for (const std::size_t i : d.derivatives) rates_.push_back(d.variables[i].reference);
      has_jacobian = true;
    }
  }

 private:
  template <class Value>
  using Access = int (*)(void*, const std::uint32_t*, std::size_t, Value*, std::size_t);

  void set(const Setting& setting) override {
    if (!with_value(setting, 3, [&](auto value) {
          require(set_as(*setting.variable, value), "fmi3Set" + setting.variable->type);
        }))
      setting.fail_type();
  }
  template <class Value>
  int set_as(const Variable& variable, Value value) {
    const std::string name = std::string("fmi3Set") + type_name<Value>();
    return binary_.function<Access<const Value>>(name)(self_, &variable.reference, 1, &value, 1);
  }
  int put(const Variable& variable, double value) override {
    return variable.type == "Float64" ? set_as(variable, value)
                                      : set_as(variable, static_cast<float>(value));
  }
  double get(const Variable& variable) override {
    double found = 0;
    with_value(Setting{&variable, "0"}, 3, [&](auto value) {
      using Value = decltype(value);
      const std::string name = std::string("fmi3Get") + type_name<Value>();
      require(binary_.function<Access<Value>>(name)(self_, &variable.reference, 1, &value, 1),
              name);
      found = static_cast<double>(value);
    });
    return found;
  }
  void enter_initialisation() override {
    const Description& d = description_;
    require(binary_.function<EnterInitialisation>("fmi3EnterInitializationMode")(
                self_, d.tolerance.has_value(), d.tolerance.value_or(0), d.t0, false, 0),
            "fmi3EnterInitializationMode");
  }
  int update_discrete_states(EventInfo& info) override {
    bool nominals = false;
    return binary_.function<UpdateDiscreteStates>("fmi3UpdateDiscreteStates")(
        self_, &info.more, &info.terminate, &nominals, &info.states, &info.has_next, &info.next);
  }
  int complete_step(bool& event, bool& terminate) override {
    return complete_step_(self_, true, &event, &terminate);
  }
  bool do_step(double t, double h) override {
    bool event = false, terminate = false, early = false;
    double reached = t + h;
    require(do_step_(self_, t, h, true, &event, &terminate, &early, &reached), "fmi3DoStep");
    return !terminate;
  }
  std::size_t count(const char* name) {
    constexpr std::size_t most = 1'000'000;
    std::size_t n = 0;
    require(binary_.function<Count>(name)(self_, &n), name);
    if (n > most) throw LoadError(fmt::format("{} says {}, at most {} are read", name, n, most));
    return n;
  }
  std::size_t count_states() override {
    if (description_.states.empty()) return 0;
    const std::size_t n = count("fmi3GetNumberOfContinuousStates");
    if (!description_.has_arrays && n != description_.states.size())
      throw LoadError(fmt::format("the binary has {} continuous states, the description lists {}",
                                  n, description_.states.size()));
    return n;
  }
  std::size_t count_indicators() override {
    get_indicators_ = binary_.function<GetNumbers>("fmi3GetEventIndicators");
    return count("fmi3GetNumberOfEventIndicators");
  }
  int set_time(double t) override { return set_time_(self_, t); }
  int set_states(const double* y) override { return set_states_(self_, y, y0.size()); }
  int get_states(double* y) override {
    return binary_.function<GetNumbers>("fmi3GetContinuousStates")(self_, y, y0.size());
  }
  int derivatives(double* dydt) override { return derivatives_(self_, dydt, y0.size()); }
  int get_indicators(double* values) override { return get_indicators_(self_, values, indicators); }
  int column(std::size_t k, double* out) override {
    constexpr double one = 1;
    const std::size_t n = y0.size();
    return wrong(directional_(self_, rates_.data(), n, &states_[k], 1, &one, 1, out, n));
  }

  DoStep do_step_ = nullptr;
  SetTime set_time_ = nullptr;
  CompletedStep complete_step_ = nullptr;
  SetStates set_states_ = nullptr;
  GetNumbers derivatives_ = nullptr, get_indicators_ = nullptr;
  Directional directional_ = nullptr;
  std::vector<std::uint32_t> states_, rates_;
};

}  // namespace

std::unique_ptr<Model> make_model3(Purpose purpose, const Description& d, const Binary& binary,
                                   const std::filesystem::path& folder, const Values& values,
                                   const Inputs* inputs) {
  return std::make_unique<Fmi3>(purpose, d, binary, folder, values, inputs);
}

}  // namespace odeum::adapters::fmi
