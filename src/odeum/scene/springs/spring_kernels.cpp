// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/scene/springs/spring_kernels.hpp"

namespace odeum::scene {

#define ODEUM_DECLARE_LANE_SET(name)                     \
  namespace name {                                       \
  extern const SpringKernels<double> spring_kernels_f64; \
  extern const SpringKernels<float> spring_kernels_f32;  \
  }
ODEUM_DECLARE_LANE_SET(target)
#ifdef ODEUM_LANE_SETS_OF_X86
ODEUM_DECLARE_LANE_SET(avx2)
ODEUM_DECLARE_LANE_SET(avx512)
#endif

namespace {

#ifdef ODEUM_LANE_SETS_OF_X86
// What the units are compiled with, see CMakeLists.txt.
bool has_avx2() { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }
bool has_avx512() {
  return has_avx2() && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
}
#endif

}  // namespace

template <>
const std::vector<const SpringKernels<double>*>& spring_kernels<double>() {
  static const auto all = [] {
    std::vector<const SpringKernels<double>*> runnable{&target::spring_kernels_f64};
#ifdef ODEUM_LANE_SETS_OF_X86
    if (has_avx2()) runnable.push_back(&avx2::spring_kernels_f64);
    if (has_avx512()) runnable.push_back(&avx512::spring_kernels_f64);
#endif
    return runnable;
  }();
  return all;
}

template <>
const std::vector<const SpringKernels<float>*>& spring_kernels<float>() {
  static const auto all = [] {
    std::vector<const SpringKernels<float>*> runnable{&target::spring_kernels_f32};
#ifdef ODEUM_LANE_SETS_OF_X86
    if (has_avx2()) runnable.push_back(&avx2::spring_kernels_f32);
    if (has_avx512()) runnable.push_back(&avx512::spring_kernels_f32);
#endif
    return runnable;
  }();
  return all;
}

}  // namespace odeum::scene
