// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <memory>
#include <string>

#include "odeum/plugin.h"
#include "odeum/solvers/solver.hpp"
#include "plugin/image.hpp"

namespace odeum::adapters::plugin {

/// What is wrong with the description, in a sentence; empty where nothing is.
std::string fault_of(const odeum_solver& solver);

/// A solver of the plug-in; each solve is made in a copy of a process that has loaded it.
Solver solver_of(const std::shared_ptr<const Plugin>& plugin, std::size_t number);

}  // namespace odeum::adapters::plugin
