// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// Micro-benchmarks: what single parts cost, to see what a change of one of them does. Each
/// registers its own; no time is judged.
namespace odeum::bench {

/// A step of a few methods, in a run as a user makes it, with the right-hand side compiled in.
void register_steps();
/// Factorising and solving with small dense matrices, real and complex.
void register_linear();
/// Forces of a cloth on a grid, and the transform of stages.
void register_kernels();

}  // namespace odeum::bench
