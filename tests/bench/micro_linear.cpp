// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <complex>
#include <random>
#include <vector>

#include "micro.hpp"
#include "odeum/linear/complex_inverse.hpp"
#include "odeum/linear/dense_lu.hpp"
#include "odeum/linear/small_inverse.hpp"

namespace odeum::bench {
namespace {

using linear::ComplexInverse;
using linear::DenseLu;
using linear::SmallInverse;

/// Entries in [-1, 1) plus n on the diagonal: far from singular, as I - gamma h J is where a step
/// succeeds. The same every time.
std::vector<double> matrix(std::size_t n) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> entry(-1, 1);
  std::vector<double> a(n * n);
  for (double& each : a) each = entry(random);
  for (std::size_t i = 0; i < n; ++i) a[i * n + i] += static_cast<double>(n);
  return a;
}

// Filling the matrix is part of it, as it is part of a step.
template <class Solver>
void factorise(benchmark::State& state, Solver solver, std::size_t n) {
  const std::vector<double> a = matrix(n);
  for (auto _ : state) {
    std::copy(a.begin(), a.end(), solver.data());
    bool regular = solver.factorise();
    benchmark::DoNotOptimize(regular);
    benchmark::ClobberMemory();
  }
}

template <class Solver>
void solve(benchmark::State& state, Solver solver, std::size_t n) {
  const std::vector<double> a = matrix(n);
  std::copy(a.begin(), a.end(), solver.data());
  if (!solver.factorise()) return state.SkipWithError("singular");
  std::vector<double> x(n, 1.0);
  for (auto _ : state) {
    // From 1 each time: iterates of the inverse would become subnormal.
    std::fill(x.begin(), x.end(), 1.0);
    solver.solve(x.data());
    benchmark::DoNotOptimize(x.data());
    benchmark::ClobberMemory();
  }
}

template <class Inverse>
void factorise_complex(benchmark::State& state, Inverse inverse, std::size_t n) {
  const std::vector<double> a = matrix(n);
  const std::complex<double> g(-0.1, 0.05);
  for (auto _ : state) {
    bool regular = inverse.factorise(g, a.data());
    benchmark::DoNotOptimize(regular);
    benchmark::ClobberMemory();
  }
}

template <class Inverse>
void solve_complex(benchmark::State& state, Inverse inverse, std::size_t n) {
  const std::vector<double> a = matrix(n);
  if (!inverse.factorise({-0.1, 0.05}, a.data())) return state.SkipWithError("singular");
  std::vector<double> re(n), im(n);
  for (auto _ : state) {
    std::fill(re.begin(), re.end(), 1.0);
    std::fill(im.begin(), im.end(), 0.5);
    inverse.solve(re.data(), im.data());
    benchmark::DoNotOptimize(re.data());
    benchmark::ClobberMemory();
  }
}

template <class Body>
void add(const char* what, std::size_t n, Body body) {
  benchmark::RegisterBenchmark(fmt::format("linear/{}/{}", what, n).c_str(), body);
}

template <std::size_t N>
void add_size() {
  if constexpr (N <= linear::small_inverse_limit) {
    add("small_inverse/factorise", N,
        [](benchmark::State& state) { factorise(state, SmallInverse<N>(), N); });
    add("small_inverse/solve", N,
        [](benchmark::State& state) { solve(state, SmallInverse<N>(), N); });
  }
  add("dense_lu/factorise", N, [](benchmark::State& state) { factorise(state, DenseLu(N), N); });
  add("dense_lu/solve", N, [](benchmark::State& state) { solve(state, DenseLu(N), N); });
  add("complex_inverse/factorise", N,
      [](benchmark::State& state) { factorise_complex(state, ComplexInverse<N>(N), N); });
  add("complex_inverse/solve", N,
      [](benchmark::State& state) { solve_complex(state, ComplexInverse<N>(N), N); });
}

}  // namespace

void register_linear() {
  add_size<2>();
  add_size<3>();
  add_size<8>();
  add_size<28>();
}

}  // namespace odeum::bench
