// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fmi/archive.hpp"
#include "fmi/inputs.hpp"
#include "fmi/model.hpp"
#include "odeum/isolated/kept_arithmetic.hpp"
#include "odeum/problem/events.hpp"
#include "odeum/solvers/solver.hpp"

namespace odeum::adapters::fmi {

/// An FMU with all that its problem's functions need.
struct Fmu {
  TemporaryFolder folder;  ///< kept for its resources
  Description description;
  Values values;
  std::optional<Inputs> inputs;
  std::vector<double> y0, stops;
  bool non_autonomous = false, has_jacobian = false;
  bool has_states = true;
  /// Whether anything happens to it: else it is a differential equation alone.
  bool has_events = false;
  bool has_time_events = false;  ///< from the start on
  std::size_t indicators = 0;
  double reach = 0;  ///< of differences in time

  /// The model, which is loaded at the first call: in a process of its own.
  Model& model() {
    if (!model_) {
      const isolated::KeptArithmetic kept;
      model_ = make_model(Purpose::model_exchange, description, folder.path(), values,
                          inputs ? &*inputs : nullptr);
    }
    return *model_;
  }
  /// The model at its start.
  Model& restarted() {
    if (has_run_) model_.reset();
    has_run_ = true;
    return model();
  }

 private:
  std::unique_ptr<Model> model_;
  bool has_run_ = false;
};

/// Names of its components; empty where states are arrays.
std::vector<std::string> names_of_states(const Description& description);
/// Their nominal sizes, by which errors are divided; empty where they name none.
std::vector<double> nominal_sizes(const Description& description);
/// What is known of it, for people.
std::vector<std::pair<std::string, std::string>> facts_of(const Fmu& fmu,
                                                          const std::vector<std::string>& names,
                                                          bool has_jacobian);

/// The integrator that it brings, as a solver of fixed communication steps: `fmu/co_simulation`.
/// The FMU has to be one.
Entrant co_simulation_of(const std::shared_ptr<Fmu>& fmu);

/// Its events for runs, one of which at a time has the model; null: it has none. The FMU has to
/// outlive them.
std::shared_ptr<const Events> events_of(Fmu& fmu);

}  // namespace odeum::adapters::fmi
