// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include "odeum/studies/elements/rows.hpp"

namespace odeum::study {

/// Errors and orders of the model problems (globs on their ids; empty: all) at up to `most`
/// divisions. Throws Interrupted.
ElementsResult measure_orders(std::size_t most, const Runner& runner,
                              const std::vector<std::string>& cases = {});
/// Iterations of every solver at up to `most` divisions, but no more than 64, against the textbook
/// bound, and what stopping earlier costs. Throws Interrupted.
ElementsResult measure_solvers(std::size_t most, const Runner& runner);
/// Times on the finest mesh, one after the other.
std::vector<ElementsTimeRow> time_solvers(std::size_t most);

}  // namespace odeum::study
