// SPDX-License-Identifier: BSD-3-Clause
// The integrator that an FMU brings (Modelica Association, "Functional Mock-up Interface 2.0.5",
// section 4; 3.0.2, section 4).
#include <utility>

#include "fmi/fmu.hpp"
#include "odeum/core/guard.hpp"
#include "odeum/core/text_of.hpp"
#include "odeum/isolated/isolated_process.hpp"
#include "odeum/solvers/runtime_library.hpp"

namespace odeum::adapters::fmi {
namespace {

/// In a process of its own. An evaluation is a communication step: what the FMU evaluates inside of
/// it is not told.
Outcome walk(Fmu& fmu, const Request& request) {
  Outcome outcome;
  const double t0 = fmu.description.t0;
  double t = t0;
  const auto end = [&](Status status, std::string why) {
    outcome.status = status;
    outcome.t = t;
    outcome.detail = std::move(why) + " at t = " + text_of(t);
    return std::move(outcome);
  };
  if (request.mode != Mode::fixed) return end(Status::refused, "needs a fixed step");
  const FixedGrid grid(t0, request);
  if (!grid.fits()) return end(Status::refused, "a stop is not on the grid of steps");
  Guard guard(fmu.y0.size(), request.budget);
  try {
    const isolated::KeptArithmetic kept;
    const std::unique_ptr<Model> model =
        make_model(Purpose::co_simulation, fmu.description, fmu.folder.path(), fmu.values,
                   fmu.inputs ? &*fmu.inputs : nullptr);
    std::vector<double> y = model->y0;
    std::size_t stop = 0;
    for (std::uint64_t i = 0; i < grid.steps(); ++i) {
      if (!guard.admit()) break;
      model->step(grid.t(i), grid.t(i + 1) - grid.t(i), y.data());
      isolated::alive(guard);
      t = grid.t(i + 1);
      if (!guard.inspect(t, y.data(), y.size())) break;
      ++outcome.counters.steps;
      for (; stop < grid.stop_count() && grid.index_of(stop) == i + 1; ++stop)
        outcome.record(request.stops[stop], y.data(), y.size());
    }
  } catch (const LoadError& error) {
    return end(Status::refused, error.what());
  }
  guard.conclude(request, outcome);
  return outcome;
}

}  // namespace

Entrant co_simulation_of(const std::shared_ptr<Fmu>& fmu) {
  Entrant entrant{.info = {}, .unfit = {}, .solve = {}};
  entrant.info.library = "fmu";
  entrant.info.method = "co_simulation";
  entrant.info.family = "co-simulation";
  entrant.info.needs = "an FMU that brings its own integrator beside its equations";
  entrant.info.source = "the FMU's own integrator, from one communication point to the next";
  entrant.solve = [fmu](const Request& request) {
    require_sound(request, fmu->description.t0, fmu->y0.size());
    return walk(*fmu, request);
  };
  return entrant;
}

}  // namespace odeum::adapters::fmi
