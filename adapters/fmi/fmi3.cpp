// SPDX-License-Identifier: BSD-3-Clause
// FMI 3.0 (Modelica Association, "Functional Mock-up Interface 3.0.2", sections 2.2 and 3.2): what
// an importer for Model Exchange calls, declared from the standard's text.
#include <fmt/format.h>

#include <cstdint>
#include <limits>

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
using EnterInitialisation = int (*)(void*, bool tolerance_defined, double tolerance, double start,
                                    bool stop_defined, double stop);
using Plain = int (*)(void*);
using UpdateDiscreteStates = int (*)(void*, bool* more_needed, bool* terminate, bool* nominals,
                                     bool* states, bool* next_time_defined, double* next_time);
using CompletedStep = int (*)(void*, bool no_return, bool* event_mode, bool* terminate);
using CountStates = int (*)(void*, std::size_t*);
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

class Fmi3 final : public Model {
 public:
  Fmi3(const Description& d, const Binary& binary, const std::filesystem::path& folder,
       const Values& values)
      : set_time_(binary.function<SetTime>("fmi3SetTime")),
        set_states_(binary.function<SetStates>("fmi3SetContinuousStates")),
        derivatives_(binary.function<GetNumbers>("fmi3GetContinuousStateDerivatives")) {
    const std::string version = binary.function<GetVersion>("fmi3GetVersion")();
    if (!version.starts_with("3."))
      throw LoadError(fmt::format("its binary is of FMI version \"{}\", its description of 3.0",
                                  foreign::cleaned(version.c_str())));
    const std::string resources = (folder / "resources").string() + "/";
    self_ = binary.function<Instantiate>("fmi3InstantiateModelExchange")(
        d.model.c_str(), d.token.c_str(), resources.c_str(), false, false, nullptr, note);
    if (!self_)
      throw LoadError(fmt::format("fmi3InstantiateModelExchange failed{}{}",
                                  last_message().empty() ? "" : ": ", last_message()));
    for (const Setting& setting : settings_of(d, values)) set(binary, setting);
    initialise(d, binary);
    std::size_t n = 0;
    require(binary.function<CountStates>("fmi3GetNumberOfContinuousStates")(self_, &n),
            "fmi3GetNumberOfContinuousStates");
    if (n == 0) throw LoadError("the model has no continuous states");
    if (n > 1'000'000 || (!d.has_arrays && n != d.states.size()))
      throw LoadError(fmt::format("the binary has {} continuous states, the description lists {}",
                                  n, d.states.size()));
    y0.resize(n);
    require(binary.function<GetNumbers>("fmi3GetContinuousStates")(self_, y0.data(), n),
            "fmi3GetContinuousStates");
    if (d.directional_derivatives && !d.has_arrays) {
      directional_ = binary.function<Directional>("fmi3GetDirectionalDerivative");
      for (const std::size_t i : d.states) states_.push_back(d.variables[i].reference);
      for (const std::size_t i : d.derivatives) rates_.push_back(d.variables[i].reference);
      has_jacobian_ = true;
    }
  }

 private:
  template <class Value>
  void set_as(const Binary& binary, const Setting& setting, Value value) {
    using Set = int (*)(void*, const std::uint32_t*, std::size_t, const Value*, std::size_t);
    const std::string name = "fmi3Set" + setting.variable->type;
    const std::uint32_t reference = setting.variable->reference;
    require(binary.function<Set>(name)(self_, &reference, 1, &value, 1), name.c_str());
  }
  template <class Integer>
  void set_integer(const Binary& binary, const Setting& setting) {
    using Limits = std::numeric_limits<Integer>;
    constexpr auto most = std::numeric_limits<long long>::max();
    const long long largest = sizeof(Integer) == 8 ? most : static_cast<long long>(Limits::max());
    set_as(binary, setting,
           static_cast<Integer>(setting.integer(static_cast<long long>(Limits::min()), largest)));
  }
  void set(const Binary& binary, const Setting& s) {
    const std::string& type = s.variable->type;
    if (type == "Float64") return set_as(binary, s, s.real());
    if (type == "Float32") return set_as(binary, s, static_cast<float>(s.real()));
    if (type == "Boolean") return set_as(binary, s, s.boolean());
    if (type == "Int8") return set_integer<std::int8_t>(binary, s);
    if (type == "UInt8") return set_integer<std::uint8_t>(binary, s);
    if (type == "Int16") return set_integer<std::int16_t>(binary, s);
    if (type == "UInt16") return set_integer<std::uint16_t>(binary, s);
    if (type == "Int32") return set_integer<std::int32_t>(binary, s);
    if (type == "UInt32") return set_integer<std::uint32_t>(binary, s);
    if (type == "Int64") return set_integer<std::int64_t>(binary, s);
    if (type == "UInt64") return set_integer<std::uint64_t>(binary, s);
    throw LoadError(fmt::format("--set {}: a {} cannot be set", s.variable->name, type));
  }

  void initialise(const Description& d, const Binary& binary) {
    const auto call = [&](const char* name) { require(binary.function<Plain>(name)(self_), name); };
    require(binary.function<EnterInitialisation>("fmi3EnterInitializationMode")(
                self_, d.tolerance.has_value(), d.tolerance.value_or(0), d.t0, false, 0),
            "fmi3EnterInitializationMode");
    call("fmi3ExitInitializationMode");
    bool more = false, terminate = false, nominals = false, states = false, defined = false;
    double next = 0;
    for (int i = 0; i == 0 || (more && i < 1000); ++i)
      require(binary.function<UpdateDiscreteStates>("fmi3UpdateDiscreteStates")(
                  self_, &more, &terminate, &nominals, &states, &defined, &next),
              "fmi3UpdateDiscreteStates");
    call("fmi3EnterContinuousTimeMode");
    bool event = false;
    if (!terminate && !d.states.empty())
      require(binary.function<CompletedStep>("fmi3CompletedIntegratorStep")(self_, true, &event,
                                                                            &terminate),
              "fmi3CompletedIntegratorStep");
    refuse_events(defined, next, terminate, event || more);
  }

  int place(double t, const double* y) override {
    const int status = set_time_(self_, t);
    return status > 1 ? status : wrong(set_states_(self_, y, y0.size()));
  }
  int derivatives(double* dydt) override { return wrong(derivatives_(self_, dydt, y0.size())); }
  int column(std::size_t k, double* out) override {
    constexpr double one = 1;
    const std::size_t n = y0.size();
    return wrong(directional_(self_, rates_.data(), n, &states_[k], 1, &one, 1, out, n));
  }
  static int wrong(int status) { return status > 1 ? status : 0; }

  void* self_ = nullptr;
  SetTime set_time_;
  SetStates set_states_;
  GetNumbers derivatives_;
  Directional directional_ = nullptr;
  std::vector<std::uint32_t> states_, rates_;
};

}  // namespace

std::unique_ptr<Model> make_model3(const Description& d, const Binary& binary,
                                   const std::filesystem::path& folder, const Values& values) {
  return std::make_unique<Fmi3>(d, binary, folder, values);
}

}  // namespace odeum::adapters::fmi
