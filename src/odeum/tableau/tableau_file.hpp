// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <string>
#include <variant>

#include "odeum/input/yaml_tree.hpp"
#include "odeum/tableau/coefficient.hpp"
#include "odeum/tableau/dynamic_tableau.hpp"
#include "odeum/tableau/row_order.hpp"

namespace odeum {

/// What a person's tableau file says.
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
  /// Over fractions where no coefficient needs more, else to `coefficient_bits`.
  std::variant<DynamicTableau<mpq_class>, DynamicTableau<mpf_class>> tableau;
  DynamicTableau<double> rounded;  ///< the same as double: what runs
  CoefficientRounding rounding;    ///< what decimals that were cut off leave open
  bool has_nodes = false;          ///< c was written

  bool exact() const { return tableau.index() == 0; }
};

/// Most stages that a file may have.
inline constexpr std::size_t most_stages = 40;

/// Reads a file of at most 1 MiB. Throws InputError for everything that is wrong with the path, the
/// text or the numbers; for anchors and aliases, which no tableau needs.
TableauFile read_tableau_file(const std::string& path);
/// The same from a text; `file` is what errors call it.
TableauFile read_tableau(const std::string& file, const std::string& text);

}  // namespace odeum
