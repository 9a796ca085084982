// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "odeum/formula/analysis.hpp"
#include "odeum/formula/compile.hpp"
#include "odeum/problem/concepts.hpp"
#include "odeum/problem/implicit_form.hpp"

namespace odeum::formula {

/// The C text of a problem: functions with the signatures of OdeView (the dense Jacobian of few
/// states only), and rhs_extended and entries_extended in long double. Each node is computed once,
/// in the order in which the user wrote it. The text has no name and no character that the user
/// wrote: nodes and states are numbers.
std::string print_c(const Problem& problem, const Analysis& analysis);

/// The residuals of a problem with their derivatives as compiled code, interpreted where there is
/// no compiler; null where the problem has none that stay implicit.
std::shared_ptr<const ImplicitForm> implicit_form(const Problem& problem);
/// The constraints of a problem with their exact derivatives, interpreted.
Constraints constraints_of(const Problem& problem);

/// A problem that was read from text, with all that was found in it, as compiled code; interpreted
/// where there is no compiler. Its derivatives are finite wherever the equations are, see
/// formula/finite_entries.hpp; the evaluations that this takes at single points are not counted.
class TextOde {
 public:
  static constexpr std::size_t dimension = dynamic;

  enum class Code { compiled, interpreted };
  /// `code`: interpreted, whether there is a compiler or not. Throws std::length_error where the
  /// derivatives are too many.
  explicit TextOde(Problem problem, Code code = Code::compiled);

  std::size_t size() const { return problem_.states.size(); }
  void rhs(double t, const double* y, double* f) const { view_.rhs(&handle_, t, y, f); }
  OdeView view() const { return view_; }

  /// The right-hand side in extended precision.
  void rhs_extended(long double t, const long double* y, long double* f) const {
    raw_.extended_rhs(&handle_, t, y, f);
  }
  /// The values of sparsity().
  void entries_extended(long double t, const long double* y, long double* values) const;
  /// Dense, row-major.
  void jacobian_extended(long double t, const long double* y, long double* j) const;
  /// Which entries of the Jacobian are not zero by form.
  const Sparsity& sparsity() const { return sparsity_; }

  /// Gives these values to the parameters of a problem that kept their names (Parameters::names),
  /// in compiled code, and to the start that follows from them. False where there is no compiled
  /// code. Not while another thread computes with this.
  bool set_parameters(const std::map<std::string, long double>& values);
  /// The values of the graph's definitions that were set last.
  const std::vector<double>& constants() const { return constants_; }

  const Problem& problem() const { return problem_; }
  const Analysis& analysis() const { return analysis_; }
  const std::string& how() const { return how_; }  ///< how it runs, in a sentence

 private:
  template <class Real>
  using Function = void (*)(const void*, Real, const Real*, Real*);
  /// The functions as they are computed, with values that are not finite.
  struct Raw {
    Function<double> jacobian = nullptr, entries = nullptr, implicit_jacobian = nullptr,
                     time_derivative = nullptr;
    Function<long double> extended_rhs = nullptr, extended_entries = nullptr;
  };
  void use(const Library& library);
  void interpret();
  void offer_derivatives();
  std::vector<double> entries(double t, const double* y) const;
  void fill_entries(double t, const double* y, double* values) const;
  void fill_jacobian(double t, const double* y, double* j) const;
  void fill_implicit_jacobian(double t, const double* y, double* j) const;
  void fill_time_derivative(double t, const double* y, double* dfdt) const;
  template <auto member>
  static void call(const void* handle, double t, const double* y, double* out) {
    (of(handle).*member)(t, y, out);
  }

  /// What the functions of the view get: C code reads the constants alone.
  struct Handle {
    const double* constants;
    const TextOde* ode;
  };
  static const TextOde& of(const void* handle) { return *static_cast<const Handle*>(handle)->ode; }

  Problem problem_;
  std::vector<double> constants_;  ///< of the graph's definitions
  Handle handle_{nullptr, this};
  Analysis analysis_;
  Sparsity sparsity_;
  std::string how_;
  std::shared_ptr<const Library> library_;
  struct Interpreted;
  template <auto values, class Real>
  static void interpreted(const void* handle, Real t, const Real* y, Real* out);
  std::shared_ptr<const Interpreted> interpreted_;
  OdeView view_;
  Raw raw_;

 public:
  TextOde(const TextOde&) = delete;
  TextOde& operator=(const TextOde&) = delete;
};

}  // namespace odeum::formula
