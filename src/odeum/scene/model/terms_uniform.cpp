// SPDX-License-Identifier: BSD-3-Clause
// Forces on each particle that depend on its own velocity alone.
#include <cmath>

#include "odeum/scene/model/terms.hpp"

namespace odeum::scene {
namespace {

/// How a force acts: its info(), force(v, f) and derivative(v).
template <class Force>
struct Law;

template <class Force>
class UniformTerm final : public Term {
 public:
  explicit UniformTerm(const Force& force) : law_{force} {}

  TermInfo info(const Bodies& bodies) const override {
    TermInfo info = law_.info();
    info.count = bodies.size() - bodies.fixed();
    info.unit = "particles";
    info.velocity_dependent = true;
    return info;
  }

  void add(const Bodies& bodies, const double*, const double* v, double* force) const override {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      if (!bodies.free(i)) continue;
      double f[3];
      law_.force(v + 3 * i, f);
      for (std::size_t d = 0; d < 3; ++d) force[3 * i + d] += f[d];
    }
  }

  void add_blocks(const Bodies& bodies, const double*, const double* v,
                  BlockSink& sink) const override {
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (bodies.free(i)) sink.add(i, i, Mat3{}, law_.derivative(v + 3 * i));
  }

 private:
  Law<Force> law_;
};

Mat3 diagonal(double x) { return {x, 0, 0, 0, x, 0, 0, 0, x}; }

template <>
struct Law<Drag> : Drag {
  static TermInfo info() { return {.name = "drag", .law = "-c v", .unit = {}, .linear = true}; }
  void force(const double* v, double* f) const {
    for (int d = 0; d < 3; ++d) f[d] = -coefficient * v[d];
  }
  Mat3 derivative(const double*) const { return diagonal(-coefficient); }
};

template <>
struct Law<Wind> : Wind {
  static TermInfo info() {
    return {.name = "wind", .law = "c (w - v)", .unit = {}, .linear = true};
  }
  void force(const double* v, double* f) const {
    for (std::size_t d = 0; d < 3; ++d) f[d] = coefficient * (velocity[d] - v[d]);
  }
  Mat3 derivative(const double*) const { return diagonal(-coefficient); }
};

template <>
struct Law<QuadraticDrag> : QuadraticDrag {
  static TermInfo info() { return {.name = "quadratic_drag", .law = "-c |v| v", .unit = {}}; }
  static double speed(const double* v) {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  }
  void force(const double* v, double* f) const {
    const double factor = coefficient * speed(v);
    for (int d = 0; d < 3; ++d) f[d] = -factor * v[d];
  }
  // -c (|v| I + v v^T / |v|), which goes to 0 with v.
  Mat3 derivative(const double* v) const {
    const double s = speed(v);
    Mat3 m = diagonal(-coefficient * s);
    if (s > 0)
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) m[3 * i + j] -= coefficient * v[i] * v[j] / s;
    return m;
  }
};

template <>
struct Law<MagneticField> : MagneticField {
  static TermInfo info() {
    return {.name = "magnetic", .law = "q v x B", .unit = {}, .linear = true};
  }
  void force(const double* v, double* f) const {
    f[0] = charge * (v[1] * field[2] - v[2] * field[1]);
    f[1] = charge * (v[2] * field[0] - v[0] * field[2]);
    f[2] = charge * (v[0] * field[1] - v[1] * field[0]);
  }
  Mat3 derivative(const double*) const {
    const double x = charge * field[0], y = charge * field[1], z = charge * field[2];
    return {0, z, -y, -z, 0, x, y, -x, 0};
  }
};

}  // namespace

std::unique_ptr<Term> make_uniform_force(const UniformForce& force) {
  return std::visit(
      []<class Force>(const Force& f) -> std::unique_ptr<Term> {
        return std::make_unique<UniformTerm<Force>>(f);
      },
      force);
}

}  // namespace odeum::scene
