// SPDX-License-Identifier: BSD-3-Clause
#include "micro.hpp"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  try {
    odeum::bench::register_steps();
    odeum::bench::register_linear();
    odeum::bench::register_kernels();
    benchmark::RunSpecifiedBenchmarks();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "odeum_micro: %s\n", error.what());
    return 1;
  }
  benchmark::Shutdown();
}
