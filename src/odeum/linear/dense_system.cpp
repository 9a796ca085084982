// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/linear/dense_system.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "odeum/linear/complex_inverse.hpp"
#include "odeum/linear/complex_lu.hpp"
#include "odeum/linear/pattern_lu.hpp"
#include "odeum/linear/small_inverse.hpp"

namespace odeum::linear {
namespace {

template <std::size_t N>
class OfKnownSize final : public DenseSystem::Solver {
 public:
  explicit OfKnownSize(std::size_t) {}
  double* data() override { return inverse_.data(); }
  bool factorise() override { return inverse_.factorise(); }
  void solve(double* x) override { inverse_.solve(x); }
  bool negative_determinant() override {
    DenseLu lu(N);
    std::copy(data(), data() + N * N, lu.data());
    return lu.factorise() && lu.negative_determinant();
  }

 private:
  SmallInverse<N> inverse_;
};

template <std::size_t N>
class ComplexOfKnownSize final : public ComplexSystem::Solver {
 public:
  explicit ComplexOfKnownSize(std::size_t n) : inverse_(n) {}
  bool factorise(std::complex<double> g, const double* j) override {
    return inverse_.factorise(g, j);
  }
  void solve(double* re, double* im) override { inverse_.solve(re, im); }

 private:
  ComplexInverse<N> inverse_;
};

/// The entries that are not zero, or were not in an earlier matrix, and factors of them alone.
template <class Scalar>
class Entries {
 public:
  explicit Entries(std::size_t n) : n_(n), was_(n * n) {}

  /// Factors of the matrix with value(m[k], on the diagonal) at each entry of m, 0 where there is
  /// none. Null where that does not pay, a multiplier is large, or the matrix is singular.
  template <class Value>
  ListedLu<Scalar>* factorise(const double* m, Value&& value) {
    if (n_ > Elimination::few_unknowns) return nullptr;
    if (!how_) find(m);
    if (!lu_) return nullptr;
    if (!fill(m, value)) {
      find(m);
      if (!lu_ || !fill(m, value)) return nullptr;
    }
    return lu_->eliminate() ? &*lu_ : nullptr;
  }

 private:
  /// False where an entry that is not zero has no place.
  template <class Value>
  bool fill(const double* m, Value&& value) {
    std::size_t all = 0, placed = 0;
    for (std::size_t k = 0; k < n_ * n_; ++k) all += m[k] != 0;
    Scalar* const lu = lu_->cleared();
    for (std::size_t k = 0; k < n_; ++k) lu[how_->diagonal[k]] = value(0.0, true);
    for (std::size_t k = 0; k < from_.size(); ++k) {
      const double entry = m[from_[k]];
      placed += entry != 0;
      lu[how_->places[k]] = value(entry, from_[k] % (n_ + 1) == 0);
    }
    return placed == all;
  }

  void find(const double* m) {
    Sparsity pattern;
    from_.clear();
    for (std::size_t i = 0; i < n_; ++i) {
      std::vector<int> row;
      for (std::size_t j = 0; j < n_; ++j) {
        const std::size_t at = i * n_ + j;
        if (m[at] == 0 && !was_[at]) continue;
        was_[at] = true;
        from_.push_back(at);
        row.push_back(static_cast<int>(j));
      }
      pattern.add_row(row);
    }
    how_ = elimination_of(pattern);
    // A multiplication at a place that is looked up takes as long as some in a row.
    constexpr std::size_t some = 2;
    lu_.reset();
    if (some * (how_->targets.size() + how_->column.size()) < n_ * n_ * (n_ / 3 + 1))
      lu_.emplace(*how_);
  }

  std::size_t n_;
  std::vector<bool> was_;          ///< not zero, so far
  std::vector<std::size_t> from_;  ///< where these are
  std::shared_ptr<const Elimination> how_;
  std::optional<ListedLu<Scalar>> lu_;
};

class OfItsEntries final : public DenseSystem::Solver {
 public:
  explicit OfItsEntries(std::size_t n) : dense_(n), entries_(n) {}

  double* data() override { return dense_.data(); }
  bool factorise() override {
    listed_ = entries_.factorise(data(), [](double entry, bool) { return entry; });
    return listed_ || dense_.factorise();
  }
  void solve(double* x) override { listed_ ? listed_->solve(x) : dense_.solve(x); }
  bool negative_determinant() override {
    return listed_ ? listed_->negative_determinant() : dense_.negative_determinant();
  }

 private:
  DenseLu dense_;
  Entries<double> entries_;
  ListedLu<double>* listed_ = nullptr;
};

class ComplexOfItsEntries final : public ComplexSystem::Solver {
 public:
  explicit ComplexOfItsEntries(std::size_t n) : n_(n), entries_(n), x_(n) {}

  bool factorise(std::complex<double> g, const double* j) override {
    listed_ = entries_.factorise(
        j, [g](double entry, bool diagonal) { return (diagonal ? 1.0 : 0.0) - g * entry; });
    if (listed_) return true;
    if (!dense_) dense_.emplace(n_);
    return dense_->factorise(g, j);
  }
  void solve(double* re, double* im) override {
    if (!listed_) return dense_->solve(re, im);
    for (std::size_t k = 0; k < n_; ++k) x_[k] = {re[k], im[k]};
    listed_->solve(x_.data());
    for (std::size_t k = 0; k < n_; ++k) re[k] = x_[k].real(), im[k] = x_[k].imag();
  }

 private:
  std::size_t n_;
  Entries<std::complex<double>> entries_;
  std::vector<std::complex<double>> x_;
  std::optional<ComplexLu> dense_;
  ListedLu<std::complex<double>>* listed_ = nullptr;
};

template <class Base, template <std::size_t> class Known, class Unknown>
std::unique_ptr<Base> made(std::size_t n) {
  std::unique_ptr<Base> solver;
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    ((n == I + 2 ? void(solver = std::make_unique<Known<I + 2>>(n)) : void()), ...);
  }
  (std::make_index_sequence<small_inverse_limit - 1>{});
  if (!solver) solver = std::make_unique<Unknown>(n);
  return solver;
}

}  // namespace

DenseSystem::DenseSystem(std::size_t n)
    : solver_(made<Solver, OfKnownSize, OfItsEntries>(n)), data_(solver_->data()) {}

ComplexSystem::ComplexSystem(std::size_t n)
    : solver_(made<Solver, ComplexOfKnownSize, ComplexOfItsEntries>(n)) {}

}  // namespace odeum::linear
