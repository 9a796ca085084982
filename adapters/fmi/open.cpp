// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

#include "fmi/fmu.hpp"
#include "odeum/core/checksum.hpp"
#include "odeum/isolated/isolated_process.hpp"
#include "odeum/linear/dense_limit.hpp"
#include "odeum/solvers/foreign_problem.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum {
namespace adapters::fmi {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t most_description_bytes = 64'000'000;

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

Fmu& fmu_of(void* data) { return *static_cast<Fmu*>(data); }

int rhs(void* data, double t, const double* y, double* dydt) {
  return fmu_of(data).model().rhs(t, y, dydt);
}

int jacobian(void* data, double t, const double* y, double* j) {
  return fmu_of(data).model().jacobian(t, y, j);
}

/// df/dt by differences of order 2: central, and to one side at the first time and beside the kinks
/// of inputs.
int time_derivative(void* data, double t, const double* y, double* dfdt) {
  Fmu& fmu = fmu_of(data);
  const std::size_t n = fmu.y0.size();
  double from = fmu.description.t0, to = std::numeric_limits<double>::infinity(), d = fmu.reach;
  if (fmu.inputs) {
    const auto [before, after] = fmu.inputs->around(t);
    from = std::max(from, before);
    to = after;
    d = std::min(d, (to - from) / 4);
  }
  const bool forward = t - d < from, to_side = forward || t + d > to;
  if (to_side && !forward) d = -d;
  std::vector<double> a(n), b(n), here(to_side ? n : 0);
  if (rhs(data, to_side ? t + d : t - d, y, a.data()) ||
      rhs(data, to_side ? t + 2 * d : t + d, y, b.data()))
    return 1;
  if (to_side && rhs(data, t, y, here.data())) return 1;
  for (std::size_t i = 0; i < n; ++i)
    dfdt[i] = (to_side ? 4 * a[i] - b[i] - 3 * here[i] : b[i] - a[i]) / (2 * d);
  return 0;
}

/// Whether f differs between times at one state.
bool depends_on_time(Fmu& fmu) {
  const std::size_t n = fmu.y0.size();
  const double t0 = fmu.description.t0, length = fmu.description.stop - t0;
  std::vector<double> first(n), f(n);
  rhs(&fmu, t0, fmu.y0.data(), first.data());
  for (int k = 1; k <= 64; ++k) {
    // Not on a grid, which a period could meet.
    const double t = t0 + length * std::fmod(k * 0.6180339887498949, 1.0);
    if (rhs(&fmu, t, fmu.y0.data(), f.data()) != 0) return true;
    if (!std::equal(f.begin(), f.end(), first.begin())) return true;
  }
  return false;
}

/// The functions of a model whose facts are known.
odeum_problem functions_of(Fmu& fmu, const char* name) {
  const Description& d = fmu.description;
  odeum_problem p{};
  p.name = name;
  p.dimension = fmu.y0.size();
  p.t0 = d.t0;
  p.y0 = fmu.y0.data();
  p.stops = fmu.stops.data();
  p.stop_count = fmu.stops.size();
  p.data = &fmu;
  p.rhs = rhs;
  if (fmu.has_jacobian && p.dimension <= dense_dimension_limit) p.jacobian = jacobian;
  if (fmu.non_autonomous) p.time_derivative = time_derivative;
  return p;
}

/// Reads an FMU without running its code.
std::shared_ptr<Fmu> read(const std::string& file) {
  auto fmu = std::make_shared<Fmu>();
  unpack(file, fmu->folder.path());
  const fs::path xml = fmu->folder.path() / "modelDescription.xml";
  std::error_code missing;
  const std::uintmax_t size = fs::file_size(xml, missing);
  if (missing) throw LoadError("has no modelDescription.xml");
  if (size > most_description_bytes)
    throw LoadError(fmt::format("modelDescription.xml has {} bytes, at most {} are read", size,
                                most_description_bytes));
  fmu->description = read_description(content_of(xml));
  const Description& d = fmu->description;
  // Quarters: each is on a step of every number of steps that a study takes.
  for (int k = 1; k <= 4; ++k) fmu->stops.push_back(d.t0 + (d.stop - d.t0) * k / 4);
  fmu->stops.back() = d.stop;
  fmu->reach = 1e-6 * (d.stop - d.t0);
  return fmu;
}

/// What the code of a model tells, as the head of a text; its state at the start follows.
struct Told {
  char sign = '+';
  bool non_autonomous = false, has_jacobian = false, has_states = false, has_time_events = false,
       has_events = false;
  std::size_t indicators = 0;
};

/// What is known of a model once its code has run, as text.
std::string facts_from_code(Fmu& fmu, const char* name) {
  Model& model = fmu.model();
  fmu.y0 = model.y0;
  fmu.has_jacobian = model.has_jacobian;
  isolated::alive();
  fmu.non_autonomous = model.has_states && (fmu.description.names_time || depends_on_time(fmu));
  if (std::string fault = foreign::Problem(functions_of(fmu, name)).fault(); !fault.empty())
    return fault;
  const bool jumps = fmu.inputs && std::isfinite(fmu.inputs->next_jump(fmu.description.t0));
  const Told told{.non_autonomous = fmu.non_autonomous,
                  .has_jacobian = fmu.has_jacobian,
                  .has_states = model.has_states,
                  .has_time_events = model.start.has_next,
                  .has_events = model.indicators > 0 || model.start.has_next ||
                                model.asks_at_start || !model.has_states || jumps ||
                                fmu.description.acts_at_steps,
                  .indicators = model.indicators};
  std::string facts(reinterpret_cast<const char*>(&told), sizeof told);
  return facts.append(reinterpret_cast<const char*>(fmu.y0.data()), fmu.y0.size() * sizeof(double));
}

/// Learns that in a process of its own.
void try_out(Fmu& fmu, const char* name) {
  constexpr std::size_t room = 1U << 26U;
  const auto [ended, said] = isolated::text_isolated(
      [&]() -> std::string {
        try {
          return facts_from_code(fmu, name);
        } catch (const LoadError& error) {
          return error.what();
        }
      },
      room);
  Told told;
  if (!ended || !said.starts_with("+") || said.size() < sizeof told) throw LoadError(said);
  std::memcpy(&told, said.data(), sizeof told);
  fmu.non_autonomous = told.non_autonomous;
  fmu.has_jacobian = told.has_jacobian;
  fmu.has_states = told.has_states;
  fmu.has_time_events = told.has_time_events;
  fmu.has_events = told.has_events;
  fmu.indicators = told.indicators;
  fmu.y0.resize((said.size() - sizeof told) / sizeof(double));
  std::memcpy(fmu.y0.data(), said.data() + sizeof told, fmu.y0.size() * sizeof(double));
}

void add_inputs(Fmu& fmu, const std::string& file) {
  if (file.empty()) return;
  fmu.inputs.emplace(file, fmu.description);
  for (const Inputs::Column& column : fmu.inputs->columns())
    if (fmu.values.contains(column.variable.name))
      throw LoadError(fmt::format("--set {}: --inputs {} has it, too", column.variable.name, file));
}

foreign::ProblemCallbacks open(const std::string& file, const Values& values,
                               const std::string& inputs) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) throw LoadError("is not a file");
  const std::shared_ptr<Fmu> fmu = read(file);
  fmu->values = values;
  add_inputs(*fmu, inputs);
  try_out(*fmu, "of the FMU");
  foreign::ProblemCallbacks given;
  given.functions = functions_of(*fmu, "of the FMU");
  given.keep_alive = fmu;
  const Description& d = fmu->description;
  given.title = d.model.empty() ? d.identifier : d.model;
  given.equation = d.text.empty() ? "of the model " + given.title : d.text;
  given.source = "the FMU " + fs::path(file).filename().string();
  given.provider = "the FMU";
  given.tag = "fmu";
  given.content = fmt::format("{:x} {}", checksum(content_of(file)), values);
  if (!inputs.empty()) given.content += fmt::format(" {:x}", checksum(content_of(inputs)));
  given.components = names_of_states(d);
  given.scale = nominal_sizes(d);
  given.facts = facts_of(*fmu, given.components, given.functions.jacobian != nullptr);
  given.events = events_of(*fmu);
  if (fmu->inputs) given.switches = fmu->inputs->kinks();
  if (!d.co_simulation.empty()) given.own_solvers.push_back(co_simulation_of(fmu));
  if (!fmu->has_states)
    given.no_truth = "it has no continuous states, and its outputs are read from it";
  return given;
}

}  // namespace
}  // namespace adapters::fmi

std::string fmi_support() { return "2.0 and 3.0, Model Exchange, by libzip and pugixml"; }

foreign::ProblemCallbacks open_fmu(const std::string& file,
                                   const std::map<std::string, std::string>& values,
                                   const std::string& inputs) {
  try {
    return adapters::fmi::open(file, values, inputs);
  } catch (const LoadError& error) {
    throw LoadError(fmt::format("{}: {}", file, error.what()));
  } catch (const std::filesystem::filesystem_error& error) {
    throw LoadError(fmt::format("{}: {}", file, error.what()));
  }
}

}  // namespace odeum
