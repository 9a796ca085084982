// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstddef>
#include <vector>

/// The arithmetic of GridSprings as plain functions, compiled for more than one instruction set
/// where the build is not tuned for one processor: the widest that the processor at hand has is
/// taken at run time. Nothing here but plain data, since inline code that an AVX build emits must
/// not be what the linker keeps for everyone.
namespace odeum::scene {

/// What the springs to the neighbour at one offset are like.
template <class Real>
struct SpringNeighbour {
  int row_offset;
  std::ptrdiff_t offset;  ///< in a component's array
  Real stiffness, stiffness_length, damping;
  Real least;        ///< of k (1 - L/l): 0 for tension-only springs
  const Real* mask;  ///< by column: 1 where the neighbour is on the grid
};

/// A grid and its springs (see GridLayout and GridSprings), at most 16 neighbours a particle, of
/// which each is followed by that on the other side.
template <class Real>
struct SpringRows {
  std::size_t rows, columns, stride, size, margin;
  const SpringNeighbour<Real>* neighbours;
  std::size_t count;
  bool damped;
  bool moderate;  ///< rest lengths are 0, or the exponents of float suffice for their squares
  // Only the functions of forces use these:
  Real* kept;         ///< 12 lines for every two neighbours, zero beyond the grid's columns
  std::size_t line;   ///< from line to line
  const Real* scale;  ///< forces are multiplied by it where it is not null, then `add` is added
  const Real* add;
};

/// One compilation of GridSprings' functions, which have the same arguments.
template <class Real>
struct SpringKernels {
  const char* name;  ///< the instruction set; "target": what the build is for
  void (*forces)(const SpringRows<Real>& springs, const Real* q, const Real* v, Real* force,
                 std::size_t begin, std::size_t end);
  void (*damping)(const SpringRows<Real>& springs, const Real* v, Real* force, std::size_t begin,
                  std::size_t end);
  void (*derivative)(const SpringRows<Real>& springs, const Real* q, const Real* dq, const Real* dv,
                     Real* change, std::size_t begin, std::size_t end);
  void (*stiffness)(const SpringRows<Real>& springs, std::size_t kind, const Real* q, bool clamped,
                    Real* across, Real* s);
};

struct SpringKernelSet {
  SpringKernels<double> f64;
  SpringKernels<float> f32;
};

/// The kernels that this processor can run, the widest last; never empty.
template <class Real>
const std::vector<const SpringKernels<Real>*>& spring_kernels();

}  // namespace odeum::scene
