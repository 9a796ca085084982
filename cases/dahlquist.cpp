// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>

#include <cmath>
#include <complex>

#include "odeum/cases/catalogue.hpp"
#include "odeum/cases/parameters.hpp"
#include "odeum/cases/set_problem.hpp"
#include "odeum/scene/model/scene.hpp"

namespace odeum::cases {
namespace {

/// y' = lambda y, lambda real.
struct DahlquistReal {
  static constexpr std::size_t dimension = 1;
  double lambda = -1;

  template <class R>
  void rhs(R, const R* y, R* dydt) const {
    dydt[0] = lambda * y[0];
  }
  void jacobian(double, const double*, double* j) const { j[0] = lambda; }
  void linear_matrix(double* a) const { jacobian(0, nullptr, a); }
};

/// y' = lambda y, lambda = re + i im complex, as the real 2 x 2 block on (Re y, Im y).
struct DahlquistComplex {
  static constexpr std::size_t dimension = 2;
  double re = -1, im = 0;

  template <class R>
  void rhs(R, const R* y, R* dydt) const {
    dydt[0] = re * y[0] - im * y[1];
    dydt[1] = im * y[0] + re * y[1];
  }
  void jacobian(double, const double*, double* j) const {
    j[0] = j[3] = re;
    j[1] = -im;
    j[2] = im;
  }
  void linear_matrix(double* a) const { jacobian(0, nullptr, a); }
};

/// For physics engines: a particle with the force m B v; y is the velocity, one component for real
/// lambda, two for complex.
scene::Scene as_scene(std::complex<double> lambda, bool complex) {
  scene::Scene scene;
  scene.particles = {{.velocity = {1, 0, 0}, .mass = 1}};
  scene.velocity_matrix = {
      lambda.real(), -lambda.imag(), 0, lambda.imag(), complex ? lambda.real() : 0, 0};
  scene.select = {3};
  if (complex) scene.select.push_back(4);
  return scene;
}

// y_n = R(h lambda)^n for the schemes whose R is written down here.
bool scheme_of(std::complex<double> lambda, bool complex, const std::string& solver, double h,
               double n, double* y) {
  const std::complex<double> z = lambda * h;
  std::complex<double> r;
  if (solver == "odeum/explicit_euler")
    r = 1.0 + z;
  else if (solver == "odeum/implicit_euler")
    r = 1.0 / (1.0 - z);
  else if (solver == "odeum/trapezoidal" || solver == "odeum/implicit_midpoint")
    r = (1.0 + z / 2.0) / (1.0 - z / 2.0);
  else if (solver == "odeum/midpoint" || solver == "odeum/heun")
    r = 1.0 + z + z * z / 2.0;
  else if (solver == "odeum/rk4")
    r = 1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)));
  else
    return false;
  const std::complex<double> exact = n == 0 ? 1.0 : std::pow(r, n);
  y[0] = exact.real();
  if (complex) y[1] = exact.imag();
  return true;
}

Case describe(const char* equation, std::complex<double> lambda, bool complex) {
  Case c;
  c.nature.linear = c.nature.smooth = true;
  c.equation = equation;
  c.source = "Dahlquist, BIT 3 (1963) 27-43";
  c.stops = {4};
  c.settings.coarsest_steps = 16;
  c.settings.finest_steps = 16384;
  c.scheme = [lambda, complex](const std::string& solver, double h, double steps, double* y) {
    return scheme_of(lambda, complex, solver, h, steps, y);
  };
  c.truth.source = "closed form";
  c.truth.closed_form = true;
  c.truth.at = [lambda, complex](double t, double* y) {
    const std::complex<double> exact = std::exp(lambda * t);
    y[0] = exact.real();
    if (complex) y[1] = exact.imag();
    return true;
  };
  return c;
}

Case real_case_of(double lambda) {
  const std::string equation =
      lambda == -1 ? "y' = -y, y(0) = 1" : fmt::format("y' = {} y, y(0) = 1", lambda);
  Case c = describe(equation.c_str(), lambda, false);
  c.y0 = {1};
  c.components = {"y"};
  set_problem(c, DahlquistReal{lambda}, std::make_shared<scene::Scene>(as_scene(lambda, false)));
  return c;
}

Case real_case(double lambda) {
  return with_parameters({{"lambda", lambda, "1/s"}},
                         [](const Values& values) { return real_case_of(values[0]); });
}

Case complex_case_of(std::complex<double> lambda) {
  const std::string equation =
      fmt::format("y' = ({} + {}i) y, y(0) = 1", lambda.real(), lambda.imag());
  Case c = describe(equation.c_str(), lambda, true);
  c.y0 = {1, 0};
  c.components = {"re", "im"};
  set_problem(c, DahlquistComplex{lambda.real(), lambda.imag()},
              std::make_shared<scene::Scene>(as_scene(lambda, true)));
  return c;
}

Case complex_case(std::complex<double> lambda) {
  return with_parameters({{"re", lambda.real(), "real part of lambda, 1/s"},
                          {"im", lambda.imag(), "imaginary part of lambda, 1/s"}},
                         [](const Values& values) {
                           return complex_case_of({values[0], values[1]});
                         });
}

Probe lambda_probe() {
  return make_probe(DahlquistComplex{}, {1, 0}, as_scene({-1, 0}, true),
                    [](DahlquistComplex& problem, scene::Scene& scene, double re, double im) {
                      problem.re = re;
                      problem.im = im;
                      scene.velocity_matrix = {re, -im, 0, im, re, 0};
                    });
}

Statement state(const char* id, const char* title, std::function<Case()> make) {
  return {.id = id, .title = title, .tags = {}, .make = std::move(make)};
}

}  // namespace

/// Dahlquist's test equation: real, complex and imaginary lambda.
std::vector<Statement> dahlquist() {
  return {state("dahlquist_real", "Dahlquist's equation, decay", [] { return real_case(-1); }),
          state("dahlquist_complex", "Dahlquist's equation, damped rotation",
                [] {
                  Case c = complex_case({-0.5, 2});
                  c.plane = "lambda";
                  c.probe = lambda_probe;
                  return c;
                }),
          state("dahlquist_imaginary", "Dahlquist's equation, rotation", [] {
            return complex_case({0, 2});
          })};
}

}  // namespace odeum::cases
