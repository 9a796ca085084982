// SPDX-License-Identifier: BSD-3-Clause
#include "sundials/structured.hpp"

#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunmatrix/sunmatrix_band.h>
#ifdef ODEUM_SUNDIALS_KLU
#include <sunlinsol/sunlinsol_klu.h>
#include <sunmatrix/sunmatrix_sparse.h>
#endif

#include "odeum/linear/ordering.hpp"
#include "odeum/linear/sparse_system.hpp"

namespace odeum::adapters::sundials {

/// Belongs to a session.
struct StructuredJacobian {
  JacobianEntries entries;
  std::vector<double> values;
  // The matrix by rows, with the diagonal: the library adds to it, and would store it anew at each
  // setup.
  std::vector<sunindextype> start{0}, column;
  std::vector<std::size_t> places;  ///< of the problem's entries among these
};

namespace {

StructuredJacobian& jacobian_of(Session& session) { return *session.structured(); }

int band_jacobian(double t, N_Vector y, N_Vector, SUNMatrix band, void* data, N_Vector, N_Vector,
                  N_Vector) {
  auto& session = *static_cast<Session*>(data);
  StructuredJacobian& jacobian = jacobian_of(session);
  const Sparsity& pattern = *session.problem().view().sparsity;
  jacobian.entries(t, NV_DATA_S(y), jacobian.values.data());
  if (session.problem().guard().tripped()) return -1;
  for (std::size_t i = 0; i < pattern.unknowns(); ++i)
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k)
      SM_ELEMENT_B(band, static_cast<sunindextype>(i), pattern.column[k]) = jacobian.values[k];
  return 0;
}

#ifdef ODEUM_SUNDIALS_KLU
int sparse_jacobian(double t, N_Vector y, N_Vector, SUNMatrix sparse, void* data, N_Vector,
                    N_Vector, N_Vector) {
  auto& session = *static_cast<Session*>(data);
  StructuredJacobian& jacobian = jacobian_of(session);
  if (!session.view().jacobian_entries) session.problem().guard().count_jacobian();
  jacobian.entries(t, NV_DATA_S(y), jacobian.values.data());
  if (session.problem().guard().tripped()) return -1;
  std::ranges::copy(jacobian.start, SUNSparseMatrix_IndexPointers(sparse));
  std::ranges::copy(jacobian.column, SUNSparseMatrix_IndexValues(sparse));
  double* const values = SUNSparseMatrix_Data(sparse);
  std::fill(values, values + jacobian.column.size(), 0.0);
  for (std::size_t k = 0; k < jacobian.places.size(); ++k)
    values[jacobian.places[k]] = jacobian.values[k];
  return 0;
}

void add_diagonal(const Sparsity& pattern, StructuredJacobian& jacobian) {
  for (std::size_t i = 0; i < pattern.unknowns(); ++i) {
    bool placed = false;
    const auto place_diagonal = [&] {
      jacobian.column.push_back(static_cast<sunindextype>(i));
      placed = true;
    };
    for (int k = pattern.start[i]; k < pattern.start[i + 1]; ++k) {
      const auto column = static_cast<std::size_t>(pattern.column[k]);
      if (!placed && column > i) place_diagonal();
      placed = placed || column == i;
      jacobian.places.push_back(jacobian.column.size());
      jacobian.column.push_back(pattern.column[k]);
    }
    if (!placed) place_diagonal();
    jacobian.start.push_back(static_cast<sunindextype>(jacobian.column.size()));
  }
}
#endif

/// The two widths of the band in the order of the unknowns.
std::pair<sunindextype, sunindextype> band_of(const Sparsity& pattern) {
  const linear::Band band = linear::band_of(pattern);
  return {static_cast<sunindextype>(band.lower), static_cast<sunindextype>(band.upper)};
}

}  // namespace

StructuredSolver make_structured_solver(Session& session) {
  const OdeView& view = session.problem().view();
  const Sparsity& pattern = *view.sparsity;
  const auto n = static_cast<sunindextype>(pattern.unknowns());
  const auto jacobian = std::make_shared<StructuredJacobian>();
  jacobian->values.resize(pattern.entries());
  if (view.jacobian_entries)
    jacobian->entries = [&problem = session.problem()](double t, const double* y, double* values) {
      problem.jacobian_entries(t, y, values);
    };
  else
    jacobian->entries = differenced_entries(
        pattern,
        [&problem = session.problem()](double t, const double* y, double* f) {
          problem.rhs(t, y, f);
        },
        session.problem().guard().weights());
  session.keep(jacobian);
  const auto [lower, upper] = band_of(pattern);
  StructuredSolver made;
#ifdef ODEUM_SUNDIALS_KLU
  constexpr sunindextype widest_band = 16;
  if (lower + upper > widest_band) {
    add_diagonal(pattern, *jacobian);
    made.matrix.reset(SUNSparseMatrix(n, n, static_cast<sunindextype>(jacobian->column.size()),
                                      CSR_MAT, session.context()));
    // KLU reads the pattern when the solver is attached.
    if (made.matrix)
      made.solver.reset(SUNLinSol_KLU(session.y(), made.matrix.get(), session.context()));
    made.jacobian = sparse_jacobian;
    return made;
  }
#endif
  made.matrix.reset(SUNBandMatrix(n, upper, lower, session.context()));
  if (made.matrix)
    made.solver.reset(SUNLinSol_Band(session.y(), made.matrix.get(), session.context()));
  if (view.jacobian_entries) made.jacobian = band_jacobian;
  return made;
}

}  // namespace odeum::adapters::sundials
