// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/springs/spring_kernels.hpp"

#include <type_traits>

namespace odeum::scene {

// Defined in spring_kernels_lanes.cpp, which is compiled for each of them.
namespace target {
extern const SpringKernelSet kernel_set;
}
#ifdef ODEUM_LANE_SETS_OF_X86
namespace avx2 {
extern const SpringKernelSet kernel_set;
}
namespace avx512 {
extern const SpringKernelSet kernel_set;
}

namespace {

// What the units are compiled with, see CMakeLists.txt.
bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
}

}  // namespace
#endif

template <class Real>
const std::vector<const SpringKernels<Real>*>& spring_kernels() {
  const auto of_real = [](const SpringKernelSet& set) -> const SpringKernels<Real>* {
    if constexpr (std::is_same_v<Real, double>)
      return &set.f64;
    else
      return &set.f32;
  };
  static const auto all = [&] {
    std::vector runnable{of_real(target::kernel_set)};
#ifdef ODEUM_LANE_SETS_OF_X86
    if (has_avx2()) runnable.push_back(of_real(avx2::kernel_set));
    if (has_avx512()) runnable.push_back(of_real(avx512::kernel_set));
#endif
    return runnable;
  }();
  return all;
}

template const std::vector<const SpringKernels<double>*>& spring_kernels();
template const std::vector<const SpringKernels<float>*>& spring_kernels();

}  // namespace odeum::scene
