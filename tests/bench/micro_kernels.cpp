// SPDX-License-Identifier: BSD-3-Clause
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "grid_forces.hpp"
#include "micro.hpp"
#include "odeum/cases/square_cloth.hpp"
#include "odeum/kernel/stage_transform.hpp"
#include "odeum/methods/radau_iia5.hpp"
#include "odeum/methods/radau_iia9.hpp"

namespace odeum::bench {
namespace {

template <class Real>
void cloth_forces(benchmark::State& state, std::size_t n) {
  const scene::Scene scene = cases::square_cloth(n, 10);
  GridForces<Real> grid(scene);
  for (auto _ : state) {
    grid.forces();
    benchmark::DoNotOptimize(grid.f.data());
    benchmark::ClobberMemory();
  }
  state.counters["a_spring"] = benchmark::Counter(
      static_cast<double>(scene.springs.size()) * static_cast<double>(state.iterations()),
      benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

// Computed once per method and program, in the first solve of a fully implicit method.
template <const auto& T>
void transform(benchmark::State& state) {
  std::vector<double> a;
  for (const auto& row : T.a) a.insert(a.end(), row.begin(), row.end());
  const std::vector<double> b(T.b.begin(), T.b.end());
  for (auto _ : state) {
    StageTransform made = make_stage_transform(a, b);
    benchmark::DoNotOptimize(made.estimate.data());
  }
}

}  // namespace

void register_kernels() {
  for (const std::size_t n : {11U, 64U, 256U}) {
    benchmark::RegisterBenchmark(fmt::format("cloth/forces/f64/{}", n).c_str(),
                                 [n](benchmark::State& state) { cloth_forces<double>(state, n); });
    benchmark::RegisterBenchmark(fmt::format("cloth/forces/f32/{}", n).c_str(),
                                 [n](benchmark::State& state) { cloth_forces<float>(state, n); });
  }
  benchmark::RegisterBenchmark("stage_transform/radau_iia5", transform<methods::radau_iia5_tableau>)
      ->Unit(benchmark::kMicrosecond);
  benchmark::RegisterBenchmark("stage_transform/radau_iia9", transform<methods::radau_iia9_tableau>)
      ->Unit(benchmark::kMicrosecond);
}

}  // namespace odeum::bench
