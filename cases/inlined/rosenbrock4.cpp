// SPDX-License-Identifier: BSD-3-Clause
#include "odeint/inlined_rosenbrock.hpp"
#include "problems/hires.hpp"
#include "problems/robertson.hpp"
#include "problems/van_der_pol.hpp"

namespace odeum::cases::inlined {

void add_rosenbrock4(const Case& c, std::vector<Entrant>& all) {
  add_rosenbrock4<Hires>(c, all);
  add_rosenbrock4<Robertson>(c, all);
  add_rosenbrock4<VanDerPol>(c, all);
}

}  // namespace odeum::cases::inlined
