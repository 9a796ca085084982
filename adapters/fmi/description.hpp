// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace odeum::adapters::fmi {

/// A variable of a model.
struct Variable {
  std::string name, type;  ///< Real, Integer, Boolean of FMI 2; Float64, Int32, Boolean of FMI 3
  std::uint32_t reference = 0;
  std::string start;      ///< as written; empty: none
  double nominal = 0;     ///< 0: none
  bool settable = false;  ///< before the initialisation
  bool is_parameter = false, is_input = false, is_output = false, is_time = false;
  bool is_array = false;
  bool is_discrete = false;  ///< it changes at events alone

  bool is_real() const { return type == "Real" || type == "Float64" || type == "Float32"; }
};

/// What modelDescription.xml says of a model for Model Exchange.
struct Description {
  int version = 2;  ///< of FMI: 2 or 3
  std::string model, text, identifier, token;
  std::string co_simulation;  ///< its identifier with an integrator of its own; empty: it has none
  bool directional_derivatives = false;
  double t0 = 0, stop = 0;
  bool stop_is_given = false;
  std::optional<double> tolerance;
  std::vector<Variable> variables;
  /// The index in `variables` of each state. Where states are arrays, one for each array.
  std::vector<std::size_t> states, derivatives;
  std::vector<std::size_t> outputs;  ///< likewise, of numbers that are not arrays
  std::vector<std::string> unshown;  ///< names of the other outputs
  bool has_arrays = false;
  bool has_indicators = false;  ///< of state events
  std::size_t indicators = 0;   ///< so many, by FMI 2
  bool completes_steps = true;  ///< it is told of each accepted step
  bool acts_at_steps = false;   ///< and says that it acts there
  bool names_time = false;      ///< among what derivatives depend on
};

/// Throws LoadError, without a file name, for a text that is not a description, needs a version
/// that is not read, has clocks, or is not made for Model Exchange.
Description read_description(const std::string& xml);

}  // namespace odeum::adapters::fmi
