// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <variant>

#include "odeum/input/yaml_tree.hpp"
#include "odeum/tableau/coefficient.hpp"
#include "odeum/tableau/dynamic_tableau.hpp"
#include "odeum/tableau/row_order.hpp"

namespace odeum {

/// The contents of a tableau file.
///
///     name: Heun with Euler            # optional, as is source
///     order: 2                         # claims, both optional
///     order_embedded: 1
///     c: [0, 1]                        # optional: the row sums of A
///     A: [[], [1]]                     # rows may leave out trailing zeros
///     b: [1/2, 1/2]
///     b_hat: [1, 0]                    # optional
struct TableauFile {
  std::string name, source;
  /// The tableau in fractions where every coefficient is rational, else to `coefficient_bits`.
  std::variant<DynamicTableau<mpq_class>, DynamicTableau<mpf_class>> tableau;
  DynamicTableau<double> rounded;  ///< the same rounded to double, for running it
  CoefficientRounding rounding;    ///< error bounds of rounded decimals
  bool has_nodes = false;          ///< the file has c

  bool exact() const { return tableau.index() == 0; }
};

/// The largest number of stages of a file.
inline constexpr std::size_t most_stages = 40;

/// Reads a file of at most 1 MiB. Throws InputError for a path that cannot be read, a text or
/// numbers that are wrong, anchors and aliases.
TableauFile read_tableau_file(const std::string& path);
/// The same from a text; `file` is its name in errors.
TableauFile read_tableau(const std::string& file, const std::string& text);

}  // namespace odeum
