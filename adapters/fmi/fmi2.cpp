// SPDX-License-Identifier: BSD-3-Clause
// FMI 2.0 (Modelica Association, "Functional Mock-up Interface 2.0.5", sections 2.1 and 3.2): what
// an importer for Model Exchange calls, declared from the standard's text.
#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <limits>

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
struct EventInfo {
  int more_needed, terminate, nominals_changed, states_changed, next_time_defined;
  double next_time;
};
using GetVersion = const char* (*)();
using Instantiate = void* (*)(const char* name, int type, const char* guid, const char* resources,
                              const Callbacks* callbacks, int visible, int logging);
using SetUp = int (*)(void*, int tolerance_defined, double tolerance, double start,
                      int stop_defined, double stop);
using Plain = int (*)(void*);
using SetReal = int (*)(void*, const unsigned* references, std::size_t n, const double* values);
using SetInteger = int (*)(void*, const unsigned* references, std::size_t n, const int* values);
using NewDiscreteStates = int (*)(void*, EventInfo*);
using CompletedStep = int (*)(void*, int no_return, int* event_mode, int* terminate);
using SetTime = int (*)(void*, double t);
using SetStates = int (*)(void*, const double* y, std::size_t n);
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

constexpr int model_exchange = 0;

class Fmi2 final : public Model {
 public:
  Fmi2(const Description& d, const Binary& binary, const std::filesystem::path& folder,
       const Values& values)
      : set_time_(binary.function<SetTime>("fmi2SetTime")),
        set_states_(binary.function<SetStates>("fmi2SetContinuousStates")),
        derivatives_(binary.function<GetNumbers>("fmi2GetDerivatives")) {
    const std::string version = binary.function<GetVersion>("fmi2GetVersion")();
    if (version != "2.0")
      throw LoadError(fmt::format("its binary is of FMI version \"{}\", its description of 2.0",
                                  foreign::cleaned(version.c_str())));
    static const Callbacks callbacks{note, std::calloc, std::free, nullptr, nullptr};
    const std::string resources = "file://" + (folder / "resources").string();
    self_ = binary.function<Instantiate>("fmi2Instantiate")(
        d.model.c_str(), model_exchange, d.token.c_str(), resources.c_str(), &callbacks, 0, 0);
    if (!self_)
      throw LoadError(fmt::format("fmi2Instantiate failed{}{}", last_message().empty() ? "" : ": ",
                                  last_message()));
    set(binary, settings_of(d, values));
    initialise(d, binary);
    y0.resize(d.states.size());
    if (y0.empty()) throw LoadError("the model has no continuous states");
    require(binary.function<GetNumbers>("fmi2GetContinuousStates")(self_, y0.data(), y0.size()),
            "fmi2GetContinuousStates");
    if (d.directional_derivatives) {
      directional_ = binary.function<Directional>("fmi2GetDirectionalDerivative");
      for (const std::size_t i : d.states) states_.push_back(d.variables[i].reference);
      for (const std::size_t i : d.derivatives) rates_.push_back(d.variables[i].reference);
      has_jacobian_ = true;
    }
  }

 private:
  void set(const Binary& binary, const std::vector<Setting>& settings) {
    for (const Setting& s : settings) {
      const std::string& type = s.variable->type;
      const unsigned reference = s.variable->reference;
      if (type == "Real") {
        const double value = s.real();
        require(binary.function<SetReal>("fmi2SetReal")(self_, &reference, 1, &value),
                "fmi2SetReal");
        continue;
      }
      if (type != "Integer" && type != "Enumeration" && type != "Boolean")
        throw LoadError(fmt::format("--set {}: a {} cannot be set", s.variable->name, type));
      const bool truth = type == "Boolean";
      using Limits = std::numeric_limits<int>;
      const int value =
          truth ? s.boolean() : static_cast<int>(s.integer(Limits::min(), Limits::max()));
      const char* const name = truth ? "fmi2SetBoolean" : "fmi2SetInteger";
      require(binary.function<SetInteger>(name)(self_, &reference, 1, &value), name);
    }
  }

  void initialise(const Description& d, const Binary& binary) {
    const auto call = [&](const char* name) { require(binary.function<Plain>(name)(self_), name); };
    require(binary.function<SetUp>("fmi2SetupExperiment")(self_, d.tolerance.has_value(),
                                                          d.tolerance.value_or(0), d.t0, 0, 0),
            "fmi2SetupExperiment");
    call("fmi2EnterInitializationMode");
    call("fmi2ExitInitializationMode");
    EventInfo info{};
    for (int i = 0; i == 0 || (info.more_needed && i < 1000); ++i)
      require(binary.function<NewDiscreteStates>("fmi2NewDiscreteStates")(self_, &info),
              "fmi2NewDiscreteStates");
    call("fmi2EnterContinuousTimeMode");
    int event = 0, terminate = info.terminate;
    if (!terminate && !d.states.empty())
      require(binary.function<CompletedStep>("fmi2CompletedIntegratorStep")(self_, 1, &event,
                                                                            &terminate),
              "fmi2CompletedIntegratorStep");
    refuse_events(info.next_time_defined, info.next_time, terminate, event || info.more_needed);
  }

  int place(double t, const double* y) override {
    const int status = set_time_(self_, t);
    return status > 1 ? status : wrong(set_states_(self_, y, y0.size()));
  }
  int derivatives(double* dydt) override { return wrong(derivatives_(self_, dydt, y0.size())); }
  int column(std::size_t k, double* out) override {
    constexpr double one = 1;
    return wrong(directional_(self_, rates_.data(), rates_.size(), &states_[k], 1, &one, out));
  }
  static int wrong(int status) { return status > 1 ? status : 0; }

  void* self_ = nullptr;
  SetTime set_time_;
  SetStates set_states_;
  GetNumbers derivatives_;
  Directional directional_ = nullptr;
  std::vector<unsigned> states_, rates_;
};

}  // namespace

std::unique_ptr<Model> make_model2(const Description& d, const Binary& binary,
                                   const std::filesystem::path& folder, const Values& values) {
  return std::make_unique<Fmi2>(d, binary, folder, values);
}

}  // namespace odeum::adapters::fmi
