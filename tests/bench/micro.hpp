// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Micro-benchmarks of single parts. Each registers its own; no test depends on the times.
namespace odeum::bench {

/// A step of a few methods in a complete run, with an inlined right-hand side.
void register_steps();
/// Factorising and solving with small dense matrices, real and complex.
void register_linear();
/// Forces of a cloth on a grid, and the transform of stages.
void register_kernels();

}  // namespace odeum::bench
