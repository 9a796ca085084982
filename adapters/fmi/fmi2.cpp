// SPDX-License-Identifier: BSD-3-Clause
// FMI 2.0 (Modelica Association, "Functional Mock-up Interface 2.0.5", sections 2.1 and 3.2): what
// an importer for Model Exchange calls, declared from the standard's text.
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <type_traits>

#include <fmt/format.h>

#include "fmi/model.hpp"
#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::adapters::fmi {
namespace {

extern "C" {
using Logger = void (*)(void* environment, const char* instance, int status, const char* category,
                        const char* message, ...);
struct Callbacks {
  Logger log;
  void* (*allocate)(std::size_t count, std::size_t size);
  void (*free)(void* memory);
  void (*step_finished)(void* environment, int status);
  void* environment;
};
struct Said {
  int more_needed, terminate, nominals_changed, states_changed, next_time_defined;
  double next_time;
};
using GetVersion = const char* (*)();
using Instantiate = void* (*)(const char* name, int type, const char* guid, const char* resources,
                              const Callbacks* callbacks, int visible, int logging);
using SetUp = int (*)(void*, int tolerance_defined, double tolerance, double start,
                      int stop_defined, double stop);
using SetReal = int (*)(void*, const unsigned* references, std::size_t n, const double* values);
using SetInteger = int (*)(void*, const unsigned* references, std::size_t n, const int* values);
using NewDiscreteStates = int (*)(void*, Said*);
using CompletedStep = int (*)(void*, int no_return, int* event_mode, int* terminate);
using SetTime = int (*)(void*, double t);
using DoStep = int (*)(void*, double t, double h, int no_return);
using SetStates = int (*)(void*, const double* y, std::size_t n);
using GetReal = int (*)(void*, const unsigned* references, std::size_t n, double* values);
using GetInteger = int (*)(void*, const unsigned* references, std::size_t n, int* values);
using GetNumbers = int (*)(void*, double* values, std::size_t n);
using Directional = int (*)(void*, const unsigned* unknowns, std::size_t, const unsigned* knowns,
                            std::size_t, const double* seed, double* sensitivity);
}

/// Has C++ linkage: a C function `log` would take the place of the logarithm.
void note(void*, const char*, int status, const char*, const char* message, ...) {
  if (status < 2 || !message) return;
  std::array<char, 500> text{};
  va_list arguments;
  va_start(arguments, message);
  std::vsnprintf(text.data(), text.size(), message, arguments);
  va_end(arguments);
  last_message() = foreign::cleaned(text.data());
}

class Fmi2 final : public Model {
 public:
  Fmi2(Purpose purpose, const Description& d, const Binary& binary,
       const std::filesystem::path& folder, const Values& values, const Inputs* inputs)
      : Model("fmi2", d, binary, inputs) {
    const std::string version = binary.function<GetVersion>("fmi2GetVersion")();
    if (version != "2.0")
      throw LoadError(fmt::format("its binary is of FMI version \"{}\", its description of 2.0",
                                  foreign::cleaned(version.c_str())));
    const bool steps_itself = purpose == Purpose::co_simulation;
    if (steps_itself) {
      do_step_ = binary.function<DoStep>("fmi2DoStep");
    } else {
      set_time_ = binary.function<SetTime>("fmi2SetTime");
      complete_step_ = binary.function<CompletedStep>("fmi2CompletedIntegratorStep");
    }
    if (!steps_itself && !d.states.empty()) {
      set_states_ = binary.function<SetStates>("fmi2SetContinuousStates");
      derivatives_ = binary.function<GetNumbers>("fmi2GetDerivatives");
    }
    static const Callbacks callbacks{note, std::calloc, std::free, nullptr, nullptr};
    const std::string resources = "file://" + (folder / "resources").string();
    self_ = binary.function<Instantiate>("fmi2Instantiate")(d.model.c_str(), steps_itself ? 1 : 0,
                                                            d.token.c_str(), resources.c_str(),
                                                            &callbacks, 0, 0);
    if (!self_)
      throw LoadError(fmt::format("fmi2Instantiate failed{}{}", last_message().empty() ? "" : ": ",
                                  last_message()));
    initialise(purpose, values);
    if (!steps_itself && d.directional_derivatives && has_states) {
      directional_ = binary.function<Directional>("fmi2GetDirectionalDerivative");
      for (const std::size_t i : d.states) states_.push_back(d.variables[i].reference);
      for (const std::size_t i : d.derivatives) rates_.push_back(d.variables[i].reference);
      has_jacobian = true;
    }
  }

 private:
  void set(const Setting& setting) override {
    const Variable& variable = *setting.variable;
    const unsigned* const reference = &variable.reference;
    if (!with_value(setting, 2, [&](auto value) {
          using Value = decltype(value);
          if constexpr (std::is_same_v<Value, double>) {
            require(put(variable, value), "fmi2SetReal");
          } else if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, std::int32_t>) {
            const char* const name =
                std::is_same_v<Value, bool> ? "fmi2SetBoolean" : "fmi2SetInteger";
            const int whole = value;
            require(binary_.function<SetInteger>(name)(self_, reference, 1, &whole), name);
          }
        }))
      setting.fail_type();
  }
  int put(const Variable& variable, double value) override {
    if (!set_real_) set_real_ = binary_.function<SetReal>("fmi2SetReal");
    return set_real_(self_, &variable.reference, 1, &value);
  }
  double get(const Variable& variable) override {
    double value = 0;
    if (variable.type == "Real") {
      require(binary_.function<GetReal>("fmi2GetReal")(self_, &variable.reference, 1, &value),
              "fmi2GetReal");
      return value;
    }
    const char* const name = variable.type == "Boolean" ? "fmi2GetBoolean" : "fmi2GetInteger";
    int whole = 0;
    require(binary_.function<GetInteger>(name)(self_, &variable.reference, 1, &whole), name);
    return whole;
  }
  void enter_initialisation() override {
    const Description& d = description_;
    require(binary_.function<SetUp>("fmi2SetupExperiment")(self_, d.tolerance.has_value(),
                                                           d.tolerance.value_or(0), d.t0, 0, 0),
            "fmi2SetupExperiment");
    call("EnterInitializationMode");
  }
  int update_discrete_states(EventInfo& info) override {
    Said said{};
    const int status = binary_.function<NewDiscreteStates>("fmi2NewDiscreteStates")(self_, &said);
    info = {said.more_needed != 0, said.terminate != 0, said.states_changed != 0,
            said.next_time_defined != 0, said.next_time};
    return status;
  }
  int complete_step(bool& event, bool& terminate) override {
    int event_mode = 0, end = 0;
    const int status = complete_step_(self_, 1, &event_mode, &end);
    event = event_mode != 0, terminate = end != 0;
    return status;
  }
  bool do_step(double t, double h) override {
    require(do_step_(self_, t, h, 1), "fmi2DoStep");
    return true;
  }
  std::size_t count_states() override { return description_.states.size(); }
  std::size_t count_indicators() override {
    get_indicators_ = binary_.function<GetNumbers>("fmi2GetEventIndicators");
    return description_.indicators;
  }
  int set_time(double t) override { return set_time_(self_, t); }
  int set_states(const double* y) override { return set_states_(self_, y, y0.size()); }
  int get_states(double* y) override {
    return binary_.function<GetNumbers>("fmi2GetContinuousStates")(self_, y, y0.size());
  }
  int derivatives(double* dydt) override { return derivatives_(self_, dydt, y0.size()); }
  int get_indicators(double* values) override { return get_indicators_(self_, values, indicators); }
  int column(std::size_t k, double* out) override {
    constexpr double one = 1;
    return wrong(directional_(self_, rates_.data(), rates_.size(), &states_[k], 1, &one, out));
  }

  DoStep do_step_ = nullptr;
  SetTime set_time_ = nullptr;
  CompletedStep complete_step_ = nullptr;
  SetStates set_states_ = nullptr;
  SetReal set_real_ = nullptr;
  GetNumbers derivatives_ = nullptr, get_indicators_ = nullptr;
  Directional directional_ = nullptr;
  std::vector<unsigned> states_, rates_;
};

}  // namespace

std::unique_ptr<Model> make_model2(Purpose purpose, const Description& d, const Binary& binary,
                                   const std::filesystem::path& folder, const Values& values,
                                   const Inputs* inputs) {
  return std::make_unique<Fmi2>(purpose, d, binary, folder, values, inputs);
}

}  // namespace odeum::adapters::fmi
