// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "odeum/judge/growth.hpp"
#include "odeum/measure/recording.hpp"

/// What is measured of a problem and a solver at a state.
namespace odeum::measure {

inline constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// The right-hand side of a case.
std::vector<double> slope(const Case& c, double t, const std::vector<double>& y);

/// How far a solver's steps may go in a direction of the plane of z = h lambda: measured by its own
/// fixed steps on y' = lambda y, or on the oscillator where it runs on nothing else.
class Region {
 public:
  explicit Region(const std::string& solver);
  /// |z| at the edge in the direction of lambda; infinite where there is none up to 1e3, NaN where
  /// it can't be measured.
  double edge(std::complex<double> lambda);
  /// The logarithm of what one step makes of |y| at z; NaN where it can't be measured.
  double growth(std::complex<double> z) const;

 private:
  judge::Growth at(std::complex<double> z) const;
  double measure(std::complex<double> direction) const;

  std::string solver_;
  bool oscillator_ = false;
  Probe probe_;
  const Entrant* entrant_ = nullptr;
  std::map<long, double> known_;  ///< by the direction
};

/// The eigenvalues of the Jacobian, and who they belong to.
struct Spectrum {
  std::complex<double> fastest;          ///< of those that do not grow
  std::optional<std::size_t> component;  ///< the largest of its eigenvector, by the sizes given
  std::vector<std::complex<double>> all;
};
/// Spectrum of the problem's own Jacobian, or of one by differences; empty `all`: it is not finite.
Spectrum spectrum_at(const Case& c, double t, const std::vector<double>& y,
                     const std::vector<double>& sizes, bool trust_jacobian);

/// An entry of the Jacobian that the problem offers which differences of its right-hand side deny.
struct WrongEntry {
  std::size_t row, column;
  double given, differenced;
};
std::optional<WrongEntry> wrong_jacobian(const Case& c, double t, const std::vector<double>& y);

/// For each component, the error of a single step of the solver from there over what the tolerance
/// allows, against the same step in parts; empty where the solver can't take it.
std::vector<double> step_error(const Case& c, const std::string& solver, const Moment& at,
                               const Tolerance& tolerance, Mode mode);

}  // namespace odeum::measure
