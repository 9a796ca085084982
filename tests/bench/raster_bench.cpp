// SPDX-License-Identifier: BSD-3-Clause
// The stability raster: 512 x 512 values of z, 50 RK4 steps each. Odeum's lanes against the loop
// that a user of Boost.odeint writes, std::complex and one z at a time; both compiled with the
// flags of the build. Repetitions alternate, so that a drift of the clock speed affects both.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <boost/numeric/odeint/algebra/vector_space_algebra.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>
#include <chrono>
#include <cmath>
#include <complex>
#include <cstdio>
#include <string>
#include <vector>

#include "odeum/studies/stability/raster_lanes.hpp"

namespace {

constexpr std::size_t side = 512;
constexpr unsigned steps = 50;
constexpr double goal = 12;

/// The square of z that holds RK4's region, row by row.
struct Raster {
  std::vector<double> re, im, squared;
  Raster() : re(side * side), im(side * side), squared(side * side) {
    for (std::size_t j = 0; j < side; ++j)
      for (std::size_t i = 0; i < side; ++i) {
        re[side * j + i] = -4 + 6 * static_cast<double>(i) / (side - 1);
        im[side * j + i] = -3 + 6 * static_cast<double>(j) / (side - 1);
      }
  }
};

void run_lanes(Raster& raster) {
  static const odeum::study::LaneRunner rk4 = odeum::study::find_lane_runner("rk4");
  rk4(raster.re.data(), raster.im.data(), raster.re.size(), steps, raster.squared.data());
}

void run_odeint(Raster& raster) {
  using State = std::complex<double>;
  namespace odeint = boost::numeric::odeint;
  odeint::runge_kutta4<State, double, State, double, odeint::vector_space_algebra> stepper;
  for (std::size_t i = 0; i < raster.re.size(); ++i) {
    const State z(raster.re[i], raster.im[i]);
    const auto system = [z](const State& y, State& dydt, double) {
      // (a + ib)(c + id) written out: operator* also handles infinities, whose cost should not
      // enter the comparison.
      dydt = State(z.real() * y.real() - z.imag() * y.imag(),
                   z.real() * y.imag() + z.imag() * y.real());
    };
    State y = 1;
    for (unsigned step = 0; step < steps; ++step) stepper.do_step(system, y, step, 1.0);
    raster.squared[i] = std::norm(y);
  }
}

template <void (*Run)(Raster&)>
void benchmark_raster(benchmark::State& state) {
  Raster raster;
  for (auto _ : state) {
    Run(raster);
    benchmark::DoNotOptimize(raster.squared.data());
    benchmark::ClobberMemory();
  }
  state.counters["per_step"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * side * side * steps,
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

/// The largest relative difference of what both computed.
double disagreement() {
  Raster own, odeint;
  run_lanes(own);
  run_odeint(odeint);
  double worst = 0;
  for (std::size_t i = 0; i < own.squared.size(); ++i)
    worst = std::max(
        worst, std::abs(own.squared[i] - odeint.squared[i]) / std::max(odeint.squared[i], 1e-200));
  return worst;
}

/// Keeps the CPU time of each repetition (the machine may be shared, and both run in one thread),
/// to set the two against each other.
class Ratio : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        (run.benchmark_name().starts_with("odeint") ? odeint_ : own_)
            .push_back(run.GetAdjustedCPUTime());
  }
  void summarise() {
    if (own_.empty() || odeint_.empty()) return;
    std::sort(own_.begin(), own_.end());
    std::sort(odeint_.begin(), odeint_.end());
    std::printf("odeint / lanes: %.1f by minima, %.1f by medians of %zu repetitions (goal %.0f)\n",
                odeint_.front() / own_.front(), odeint_[odeint_.size() / 2] / own_[own_.size() / 2],
                own_.size(), goal);
  }

 private:
  std::vector<double> own_, odeint_;
};

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const auto& [name, run] : {std::pair{"lanes/rk4", &benchmark_raster<run_lanes>},
                                  std::pair{"odeint/rk4", &benchmark_raster<run_odeint>}})
    benchmark::RegisterBenchmark(name, run)
        ->Unit(benchmark::kMillisecond)
        ->Repetitions(9)
        ->ReportAggregatesOnly(false);
  // Both compute the same to the rounding of 200 evaluations, or the times mean nothing. Relative
  // to |y|^2, which near zeros of R falls to 1e-200 through cancellation of its stages.
  const double worst = disagreement();
  std::printf("largest relative difference of |y|^2: %.1e\n", worst);
  if (!(worst < 1e-6)) return 1;
  Ratio reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.summarise();
  return 0;
}
