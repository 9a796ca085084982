// SPDX-License-Identifier: BSD-3-Clause
// Compiled for speed in every build type and for wide vectors, see CMakeLists.txt.
#include "odeum/studies/stability/raster_lanes.hpp"

#include <algorithm>

#include "odeum/kernel/explicit_rk.hpp"
#include "odeum_methods.hpp"

namespace odeum::study {
namespace {

template <class M>
void run_lanes(const double* re, const double* im, std::size_t count, unsigned steps,
               double* squared) {
  using Problem = DahlquistLanes<lanes>;
  Problem problem;
  typename M::template Stepper<Problem> stepper(problem);
  for (std::size_t begin = 0; begin < count; begin += lanes) {
    const std::size_t used = std::min(lanes, count - begin);
    std::copy_n(re + begin, used, problem.re.begin());  // lanes beyond `used` compute on old values
    std::copy_n(im + begin, used, problem.im.begin());
    State<Problem> y{};
    std::fill_n(y.begin(), lanes, 1.0);
    for (unsigned i = 0; i < steps; ++i) stepper.step(i, 1, y);
    for (std::size_t i = 0; i < used; ++i)
      squared[begin + i] = y[i] * y[i] + y[lanes + i] * y[lanes + i];
  }
}

}  // namespace

LaneRunner find_lane_runner(std::string_view method) {
  LaneRunner runner = nullptr;
  methods::All::for_each([&]<class M>() {
    if constexpr (ExplicitTableauMethod<M>)
      if (method == M::info.id) runner = &run_lanes<M>;
  });
  return runner;
}

}  // namespace odeum::study
