// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/formula/operations.hpp"

#include <cmath>
#include <iterator>
#include <type_traits>

namespace odeum::formula {
namespace {

constexpr bool with_kinks = true;
using Partials = std::array<const char*, 2>;

template <class F, class Real>
constexpr Real (*value_of)(Real, Real, Real) =
    [](Real a, [[maybe_unused]] Real b, [[maybe_unused]] Real c) -> Real {
  if constexpr (std::is_invocable_v<F, Real>)
    return static_cast<Real>(F{}(a));
  else if constexpr (std::is_invocable_v<F, Real, Real>)
    return static_cast<Real>(F{}(a, b));
  else
    return static_cast<Real>(F{}(a, b, c));
};

template <class F>
constexpr Operation row(const char* name, const char* c, Partials partials, F /*value*/,
                        bool kinks = false) {
  constexpr std::size_t arguments = std::is_invocable_v<F, double>           ? 1
                                    : std::is_invocable_v<F, double, double> ? 2
                                                                             : 3;
  return {name, c, partials, kinks, arguments, value_of<F, double>, value_of<F, long double>};
}
template <class F>
constexpr Operation function(const char* name, Partials partials, F value) {
  return row(name, nullptr, partials, value);
}
template <class F>
constexpr Operation jumps(const char* name, const char* c, F value) {
  return row(name, c, {}, value, with_kinks);
}
template <class F>
constexpr Operation signs(const char* c, Partials partials, F value) {
  return row(nullptr, c, partials, value);
}

// The operations in the order of Op.
constexpr Operation table[] = {
    signs("-{0}", {"-1"}, [](auto a) { return -a; }),
    function("sin", {"cos(a)"}, [](auto a) { return std::sin(a); }),
    function("cos", {"-sin(a)"}, [](auto a) { return std::cos(a); }),
    function("tan", {"1 + w^2"}, [](auto a) { return std::tan(a); }),
    function("asin", {"1/sqrt(1 - a^2)"}, [](auto a) { return std::asin(a); }),
    function("acos", {"-1/sqrt(1 - a^2)"}, [](auto a) { return std::acos(a); }),
    function("atan", {"1/(1 + a^2)"}, [](auto a) { return std::atan(a); }),
    function("sinh", {"cosh(a)"}, [](auto a) { return std::sinh(a); }),
    function("cosh", {"sinh(a)"}, [](auto a) { return std::cosh(a); }),
    function("tanh", {"1 - w^2"}, [](auto a) { return std::tanh(a); }),
    function("exp", {"w"}, [](auto a) { return std::exp(a); }),
    function("log", {"1/a"}, [](auto a) { return std::log(a); }),
    function("log10", {"1/(log(10)*a)"}, [](auto a) { return std::log10(a); }),
    function("sqrt", {"0.5/w"}, [](auto a) { return std::sqrt(a); }),
    jumps("floor", nullptr, [](auto a) { return std::floor(a); }),
    // derivative.cpp has the derivatives of abs, min, max and if, and a power's by its base for all
    // but series, whose rule has to lead back to w.
    jumps("abs", "{3}fabs{4}({0})", [](auto a) { return std::abs(a); }),
    jumps(nullptr, "{3}copysign{4}(1.0, {0})",
          [](auto a) { return std::copysign(decltype(a)(1), a); }),
    // NaN of NaN.
    jumps("sign", "({0} > 0) - ({0} < 0) + 0 * {0}",
          [](auto a) { return static_cast<int>(a > 0) - static_cast<int>(a < 0) + 0 * a; }),
    signs("{0} + {1}", {"1", "1"}, [](auto a, auto b) { return a + b; }),
    signs("{0} - {1}", {"1", "-1"}, [](auto a, auto b) { return a - b; }),
    signs("{0} * {1}", {"b", "a"}, [](auto a, auto b) { return a * b; }),
    signs("{0} / {1}", {"1/b", "-(w/b)"}, [](auto a, auto b) { return a / b; }),
    signs("{0} < {1}", {}, [](auto a, auto b) { return a < b; }),
    signs("{0} <= {1}", {}, [](auto a, auto b) { return a <= b; }),
    signs("{0} == {1}", {}, [](auto a, auto b) { return a == b; }),
    signs("{3}pow{4}({0}, {1})", {"b*(w/a)", "w*log(a)"},
          [](auto a, auto b) { return std::pow(a, b); }),
    function("atan2", {"b/(a^2 + b^2)", "-(a/(a^2 + b^2))"},
             [](auto a, auto b) { return std::atan2(a, b); }),
    function("hypot", {"a/w", "b/w"}, [](auto a, auto b) { return std::hypot(a, b); }),
    jumps("min", "{1} < {0} ? {1} : {0}", [](auto a, auto b) { return b < a ? b : a; }),
    jumps("max", "{0} < {1} ? {1} : {0}", [](auto a, auto b) { return a < b ? b : a; }),
    jumps("if", "{0} != 0 ? {1} : {2}", [](auto a, auto b, auto c) { return a != 0 ? b : c; })};
static_assert(std::size(table) + leaves == static_cast<std::size_t>(Op::choose) + 1);

}  // namespace

const Operation& meaning_of(Op op) { return table[static_cast<std::size_t>(op) - leaves]; }

}  // namespace odeum::formula
