// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_nonlinearsolver.h>
#include <sundials/sundials_nvector.h>

#include <memory>

/// Owners of the library's C handles.
namespace odeum::adapters::sundials {

template <auto destroy>
struct Destroy {
  template <class Handle>
  void operator()(Handle* handle) const {
    destroy(handle);
  }
};

using Vector = std::unique_ptr<_generic_N_Vector, Destroy<&N_VDestroy>>;
using Matrix = std::unique_ptr<_generic_SUNMatrix, Destroy<&SUNMatDestroy>>;
using LinearSolver = std::unique_ptr<_generic_SUNLinearSolver, Destroy<&SUNLinSolFree>>;
using NonlinearSolver = std::unique_ptr<_generic_SUNNonlinearSolver, Destroy<&SUNNonlinSolFree>>;

}  // namespace odeum::adapters::sundials
