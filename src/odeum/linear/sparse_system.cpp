// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/sparse_system.hpp"

#include <memory>
#include <stdexcept>
#include <utility>

#include "odeum/linear/sparse_factors.hpp"

namespace odeum {
namespace {

using linear::Band;

/// Multiplications per unknown of a factorisation without exchanges of rows.
double work_of(const Band& band) {
  return static_cast<double>((band.lower + 1) * (band.upper + 1));
}

/// The better of the given and the reverse Cuthill-McKee ordering.
Band narrow_band(const Sparsity& pattern) {
  Band as_given = linear::band_of(pattern);
  if (work_of(as_given) <= 9) return as_given;  // tridiagonal, or nearly
  Band ordered = linear::band_of(pattern, linear::reverse_cuthill_mckee(pattern));
  return work_of(ordered) < work_of(as_given) ? ordered : as_given;
}

void require_pattern(const Sparsity& pattern) {
  const auto n = static_cast<int>(pattern.unknowns());
  bool sound = n > 0 && pattern.start[0] == 0 &&
               pattern.start.back() == static_cast<int>(pattern.column.size());
  for (int i = 0; i < n && sound; ++i) {
    sound = pattern.start[i] <= pattern.start[i + 1];
    for (int k = pattern.start[i]; k < pattern.start[i + 1] && sound; ++k)
      sound = pattern.column[k] >= 0 && pattern.column[k] < n &&
              (k == pattern.start[i] || pattern.column[k] > pattern.column[k - 1]);
  }
  if (!sound)
    throw std::invalid_argument(
        "sparsity: each row's columns must rise and lie below the number of unknowns");
}

/// A band is factorised at two to three multiplications a nanosecond, Eigen's sparse LU takes some
/// 0.3 us an unknown and 10 ns for each entry of its factors.
constexpr double most_band_work = 2000;

/// What is found in a pattern.
struct Structure {
  Sparsity pattern;
  Band band;
  bool is_band;
  std::shared_ptr<const linear::Elimination> few;  ///< where it takes less than the band

  explicit Structure(const Sparsity& of)
      : pattern(of), band(narrow_band(of)), is_band(work_of(band) <= most_band_work) {
    const bool is_small = of.unknowns() <= linear::Elimination::few_unknowns;
    if (of.unknowns() > linear::Elimination::most_unknowns || (!is_small && is_band)) return;
    try {
      few = linear::elimination_of(of);
    } catch (const std::length_error&) {  // much fill
      return;
    }
    // A multiplication at a place that is looked up takes as long as some of a band.
    constexpr double some = 2.5;
    const double by_places = few->multiplications + static_cast<double>(few->column.size());
    // Beyond these many Eigen's blocks of columns are faster.
    constexpr double many = 3e7;
    if (is_small ? some * by_places > work_of(band) * static_cast<double>(of.unknowns())
                 : few->multiplications > many)
      few.reset();
  }
};

/// Kept from the last call of the thread, since runs of a problem follow each other, and for few
/// unknowns it takes as long as several steps.
std::shared_ptr<const Structure> structure_of(const Sparsity& pattern) {
  thread_local std::shared_ptr<const Structure> last;
  if (!last || last->pattern.start != pattern.start || last->pattern.column != pattern.column)
    last = std::make_shared<const Structure>(pattern);
  return last;
}

}  // namespace

struct SparseSystem::Parts {
  std::shared_ptr<const Structure> structure;
  JacobianEntries entries;
  std::vector<double> values, y;
  double t = 0;
  bool linearised = false, finite = false;
  std::vector<std::unique_ptr<linear::Factors>> real, complex;  // by shift; made when first needed

  Parts(const Sparsity& s, JacobianEntries e, std::size_t shifts)
      : structure(structure_of(s)),
        entries(std::move(e)),
        values(s.entries()),
        y(s.unknowns()),
        real(shifts),
        complex(shifts) {}

  std::unique_ptr<linear::Factors>& factors(std::size_t shift, bool is_complex) {
    std::unique_ptr<linear::Factors>& of = (is_complex ? complex : real)[shift];
    if (of) return of;
    const auto& [pattern, band, is_band, few] = *structure;
    if (few && is_complex)
      of = std::make_unique<linear::FewFactors<std::complex<double>>>(pattern, few);
    else if (few)
      of = std::make_unique<linear::FewFactors<double>>(pattern, few);
    else if (is_band && is_complex)
      of = linear::band_factors<true>(pattern, band);
    else if (is_band)
      of = linear::band_factors<false>(pattern, band);
    else if (is_complex)
      of = std::make_unique<linear::SparseFactors<std::complex<double>>>(pattern);
    else
      of = std::make_unique<linear::SparseFactors<double>>(pattern);
    return of;
  }
};

SparseSystem::SparseSystem(const Sparsity& pattern, JacobianEntries entries, std::size_t shifts) {
  require_pattern(pattern);
  parts_ = std::make_unique<Parts>(pattern, std::move(entries), shifts);
}
SparseSystem::~SparseSystem() = default;

void SparseSystem::linearise(double t, const double* y) {
  Parts& p = *parts_;
  if (p.linearised && t == p.t && std::equal(p.y.begin(), p.y.end(), y)) return;
  p.entries(t, y, p.values.data());
  p.t = t;
  std::copy(y, y + p.y.size(), p.y.begin());
  double finite = 0;  // NaN when any value is not finite
  for (const double value : p.values) finite += value * 0.0;
  p.finite = finite == 0;
  p.linearised = true;
}

bool SparseSystem::factorise(std::size_t shift, std::complex<double> g) {
  Parts& p = *parts_;
  return p.finite && p.factors(shift, g.imag() != 0)->factorise(p.values, g);
}

void SparseSystem::solve(std::size_t shift, double* re, double* im) {
  parts_->factors(shift, im != nullptr)->solve(re, im);
}

std::string SparseSystem::method() const {
  const Band& band = parts_->structure->band;
  if (parts_->structure->few) return "LU of the pattern's entries";
  if (!parts_->structure->is_band) return "sparse LU";
  return "LU of a band of " + std::to_string(band.lower) + " below and " +
         std::to_string(band.upper) + " above the diagonal";
}

namespace {

class SparseShiftedSolver final : public ShiftedSolver {
 public:
  SparseShiftedSolver(const Sparsity& pattern, JacobianEntries entries)
      : system_(pattern, std::move(entries), 1) {}
  bool factorise(double t, const double* y, double gamma_h) override {
    system_.linearise(t, y);
    return system_.factorise(0, gamma_h);
  }
  bool solve(double* x, double) override {
    system_.solve(0, x, nullptr);
    return true;
  }

 private:
  SparseSystem system_;
};

}  // namespace

std::unique_ptr<ShiftedSolver> make_sparse_solver(const Sparsity& pattern,
                                                  JacobianEntries entries) {
  return std::make_unique<SparseShiftedSolver>(pattern, std::move(entries));
}

}  // namespace odeum
