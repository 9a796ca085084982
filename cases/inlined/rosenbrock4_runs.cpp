// SPDX-License-Identifier: BSD-3-Clause
// Plain C++17, see adapters/odeint/CMakeLists.txt: the problems of rosenbrock4.cpp.
#include "odeint/rosenbrock.hpp"
#include "problems/hires.hpp"
#include "problems/robertson.hpp"
#include "problems/van_der_pol.hpp"

namespace odeum::adapters::odeint {

using Start = const std::vector<double>&;
template Outcome run_bare_rosenbrock4<cases::Hires>(const OdeView&, double, Start, const Request&);
template Outcome run_bare_rosenbrock4_dense_output<cases::Hires>(const OdeView&, double, Start,
                                                                 const Request&);
template Outcome run_bare_rosenbrock4<cases::Robertson>(const OdeView&, double, Start,
                                                        const Request&);
template Outcome run_bare_rosenbrock4_dense_output<cases::Robertson>(const OdeView&, double, Start,
                                                                     const Request&);
template Outcome run_bare_rosenbrock4<cases::VanDerPol>(const OdeView&, double, Start,
                                                        const Request&);
template Outcome run_bare_rosenbrock4_dense_output<cases::VanDerPol>(const OdeView&, double, Start,
                                                                     const Request&);

}  // namespace odeum::adapters::odeint
