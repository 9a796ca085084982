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
  bool is_parameter = false, is_input = false, is_time = false, is_array = false;
};

/// What modelDescription.xml says of a model for Model Exchange.
struct Description {
  int version = 2;  ///< of FMI: 2 or 3
  std::string model, text, identifier, token;
  bool directional_derivatives = false;
  double t0 = 0, stop = 0;
  bool stop_is_given = false;
  std::optional<double> tolerance;
  std::vector<Variable> variables;
  /// The index in `variables` of each state. Where states are arrays, one for each array.
  std::vector<std::size_t> states, derivatives;
  bool has_arrays = false;
  bool names_time = false;  ///< among what derivatives depend on
};

/// Throws LoadError, without a file name, for a text that is not a description, needs a version
/// that is not read, has events, or is made for co-simulation only.
Description read_description(const std::string& xml);

}  // namespace odeum::adapters::fmi
