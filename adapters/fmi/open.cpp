// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <utility>

#include "fmi/archive.hpp"
#include "fmi/model.hpp"
#include "odeum/core/checksum.hpp"
#include "odeum/isolated/isolated_process.hpp"
#include "odeum/isolated/kept_arithmetic.hpp"
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

/// An FMU with all that its problem's functions need.
struct Fmu {
  TemporaryFolder folder;  ///< kept for its resources
  Description description;
  Values values;
  std::vector<double> y0, stops;
  bool non_autonomous = false, has_jacobian = false;
  double reach = 0;  ///< of differences in time

  /// The model, which is loaded at the first call: in a process of its own.
  Model& model() {
    if (!model_) {
      const isolated::KeptArithmetic kept;
      model_ = make_model(description, folder.path(), values);
    }
    return *model_;
  }

 private:
  std::unique_ptr<Model> model_;
};

Fmu& fmu_of(void* data) { return *static_cast<Fmu*>(data); }

int rhs(void* data, double t, const double* y, double* dydt) {
  return fmu_of(data).model().rhs(t, y, dydt);
}

int jacobian(void* data, double t, const double* y, double* j) {
  return fmu_of(data).model().jacobian(t, y, j);
}

/// df/dt by differences of order 2: central, from the first time on forward.
int time_derivative(void* data, double t, const double* y, double* dfdt) {
  Fmu& fmu = fmu_of(data);
  const std::size_t n = fmu.y0.size();
  const double d = fmu.reach;
  const bool forward = t - d < fmu.description.t0;
  std::vector<double> a(n), b(n), here(forward ? n : 0);
  if (rhs(data, forward ? t + d : t - d, y, a.data()) ||
      rhs(data, forward ? t + 2 * d : t + d, y, b.data()))
    return 1;
  if (forward && rhs(data, t, y, here.data())) return 1;
  for (std::size_t i = 0; i < n; ++i)
    dfdt[i] = (forward ? 4 * a[i] - b[i] - 3 * here[i] : b[i] - a[i]) / (2 * d);
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

std::vector<std::string> names_of_states(const Description& d) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  if (d.has_arrays) return names;
  for (const std::size_t i : d.states) {
    std::string name = d.variables[i].name;
    for (char& c : name)
      if (c == ',' || c == '"' || c == ' ') c = '_';
    while (!taken.insert(name).second) name += '_';
    names.push_back(name);
  }
  return names;
}

/// Their nominal sizes, by which errors are divided; empty where they name none.
std::vector<double> nominal_sizes(const Description& d) {
  std::vector<double> sizes;
  bool any = false;
  for (const std::size_t i : d.states) {
    const double nominal = d.variables[i].nominal;
    sizes.push_back(nominal > 0 && std::isfinite(nominal) ? nominal : 1);
    any = any || sizes.back() != 1;
  }
  return any && !d.has_arrays ? sizes : std::vector<double>{};
}

std::vector<std::pair<std::string, std::string>> facts_of(const Fmu& fmu,
                                                          const std::vector<std::string>& names,
                                                          const Values& values,
                                                          const odeum_problem& p) {
  const Description& d = fmu.description;
  std::vector<std::pair<std::string, std::string>> facts;
  facts.emplace_back("model", fmt::format("{} (FMI {}.0, Model Exchange)", d.model, d.version));
  std::vector<std::string> parameters, inputs;
  for (const Variable& v : d.variables) {
    if (v.is_array || !(v.is_parameter || v.is_input)) continue;
    const auto given = values.find(v.name);
    (v.is_parameter ? parameters : inputs)
        .push_back(fmt::format(
            "{} = {}", v.name,
            foreign::cleaned((given == values.end() ? v.start : given->second).c_str())));
  }
  if (!parameters.empty())
    facts.emplace_back("set", fmt::format("{}", fmt::join(parameters, ", ")));
  if (!inputs.empty())
    facts.emplace_back("inputs", fmt::format("held: {}", fmt::join(inputs, ", ")));
  facts.emplace_back(
      "states", fmt::format("{}{}{}", p.dimension, names.empty() ? "" : ": ",
                            fmt::join(names.begin(),
                                      names.begin() + static_cast<std::ptrdiff_t>(
                                                          std::min<std::size_t>(8, names.size())),
                                      ", ")));
  facts.emplace_back("time", fmt::format("{} to {}{}", d.t0, d.stop,
                                         d.stop_is_given ? "" : ", since the FMU names no end"));
  facts.emplace_back("found", p.time_derivative ? "depends on time; df/dt by differences"
                                                : "does not depend on time");
  facts.emplace_back("Jacobian", p.jacobian ? "the FMU's directional derivatives"
                                            : "by differences: the FMU offers no derivatives");
  return facts;
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

/// What is known of a model once its code has run, as text.
std::string facts_from_code(Fmu& fmu, const char* name) {
  fmu.y0 = fmu.model().y0;
  fmu.has_jacobian = fmu.model().has_jacobian();
  isolated::alive();
  fmu.non_autonomous = fmu.description.names_time || depends_on_time(fmu);
  if (std::string fault = foreign::Problem(functions_of(fmu, name)).fault(); !fault.empty())
    return fault;
  std::string facts{'+', fmu.non_autonomous ? 't' : ' ', fmu.has_jacobian ? 'j' : ' '};
  return facts.append(reinterpret_cast<const char*>(fmu.y0.data()), fmu.y0.size() * sizeof(double));
}

/// Learns that in a process of its own.
void try_out(Fmu& fmu, const char* name) {
  constexpr std::size_t room = 1U << 26U, head = 3;
  const auto [ended, said] = isolated::text_isolated(
      [&]() -> std::string {
        try {
          return facts_from_code(fmu, name);
        } catch (const LoadError& error) {
          return error.what();
        }
      },
      room);
  if (!ended || !said.starts_with("+") || said.size() < head) throw LoadError(said);
  fmu.non_autonomous = said[1] == 't';
  fmu.has_jacobian = said[2] == 'j';
  fmu.y0.resize((said.size() - head) / sizeof(double));
  std::memcpy(fmu.y0.data(), said.data() + head, fmu.y0.size() * sizeof(double));
}

foreign::ProblemCallbacks open(const std::string& file, const Values& values) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) throw LoadError("is not a file");
  const std::shared_ptr<Fmu> fmu = read(file);
  fmu->values = values;
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
  given.components = names_of_states(d);
  given.scale = nominal_sizes(d);
  given.facts = facts_of(*fmu, given.components, values, given.functions);
  return given;
}

}  // namespace
}  // namespace adapters::fmi

std::string fmi_support() { return "2.0 and 3.0, Model Exchange, by libzip and pugixml"; }

foreign::ProblemCallbacks open_fmu(const std::string& file,
                                   const std::map<std::string, std::string>& values) {
  try {
    return adapters::fmi::open(file, values);
  } catch (const LoadError& error) {
    throw LoadError(fmt::format("{}: {}", file, error.what()));
  } catch (const std::filesystem::filesystem_error& error) {
    throw LoadError(fmt::format("{}: {}", file, error.what()));
  }
}

}  // namespace odeum
