// SPDX-License-Identifier: BSD-3-Clause
#include "odeum/fem/second_order_pde.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <set>

#include "odeum/core/enum_names.hpp"
#include "odeum/formula/parser.hpp"

namespace odeum::fem {
namespace {

using formula::ExpressionError;
using formula::Graph;
using formula::Id;
using formula::Op;

// States of the graph: the point, the second derivatives, the first ones and u.
constexpr std::uint32_t u_xx = 2, u_xy = 3, u_yy = 4, u_x = 5, u_y = 6, u_itself = 7, states = 8;

formula::Scope scope_of(Graph& graph, const std::string& second, bool with_u) {
  formula::Scope scope;
  scope.names["x"] = graph.state(0);
  if (second == "t")
    scope.refused["y"] = "x and t, or x and y";
  else
    scope.names["y"] = graph.state(1), scope.refused["t"] = "x and t, or x and y";
  if (!with_u) return scope;
  const std::string xy = "u_x" + second, yx = "u_" + second + "x";
  scope.names["u_xx"] = graph.state(u_xx), scope.names["u_x"] = graph.state(u_x);
  scope.names[xy] = scope.names[yx] = graph.state(u_xy);
  scope.names["u_" + second + second] = graph.state(u_yy);
  scope.names["u_" + second] = graph.state(u_y), scope.names["u"] = graph.state(u_itself);
  return scope;
}

/// t stands alone or as the variable of a derivative, so that it is not part of a function's name.
bool uses_time(const std::string& text) {
  static const std::set<std::string> names{"t", "u_t", "u_tt", "u_xt", "u_tx"};
  const auto part_of_name = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  for (auto end = text.begin(); end != text.end();) {
    const auto begin = std::find_if(end, text.end(), part_of_name);
    end = std::find_if_not(begin, text.end(), part_of_name);
    if (names.contains({begin, end})) return true;
  }
  return false;
}

Id parsed(const std::string& text, std::size_t offset, const formula::Scope& scope, Graph& graph) {
  try {
    return formula::parse_expression(text, scope, graph);
  } catch (const ExpressionError& error) {
    throw ExpressionError(offset + error.at(), error.what());
  }
}

/// On any of the states `first` to `last`.
bool depends(const Graph& graph, Id root, std::uint32_t first, std::uint32_t last) {
  const std::vector<Id> needed = graph.needed({root});
  return std::ranges::any_of(needed, [&](Id id) {
    return graph[id].op == Op::state && graph[id].index >= first && graph[id].index <= last;
  });
}

PdePoint judged(const long double* k, bool lower_known) {
  PdePoint point;
  point.a = k[0], point.b = k[1], point.c = k[2];
  if (!std::all_of(k, k + 5, [](long double v) { return std::isfinite(v); })) return point;
  // Scaled, so that squares neither overflow nor vanish.
  const long double size = std::max({std::abs(k[0]), std::abs(k[1]), std::abs(k[2])});
  if (size == 0) {
    point.type = PdeType::first_order;
    return point;
  }
  const long double a = k[0] / size, b = k[1] / size, c = k[2] / size;
  long double d = b * b - 4 * a * c;
  // What rounding of decimal coefficients leaves of a discriminant that is 0.
  constexpr long double rounding = 16 * std::numeric_limits<long double>::epsilon();
  if (std::abs(d) <= rounding * (b * b + 4 * std::abs(a * c))) d = 0;
  point.discriminant = d * size * size;
  const auto add = [&](long double x, long double y) {
    const long double length = std::hypot(x, y);
    point.characteristics.push_back(
        {static_cast<double>(x / length), static_cast<double>(y / length)});
  };
  if (d < 0) {
    point.type = PdeType::elliptic;
  } else if (d > 0) {
    point.type = PdeType::hyperbolic;
    // The roots q / a and c / q of a m^2 - b m + c = 0 without cancellation, as directions.
    const long double q = (b + std::copysign(std::sqrt(d), b)) / 2;
    add(a, q), add(q, c);
  } else {
    point.type = PdeType::parabolic;
    const bool along_x = std::abs(a) > std::abs(c);
    const long double x = along_x ? a : b / 2, y = along_x ? b / 2 : c;
    add(x, y);
    // The second derivative is along the characteristic's direction turned by the form: what it
    // does not see is the null vector of [[a, b/2], [b/2, c]], (-y, x).
    point.degenerate = lower_known && std::abs(k[4] * x - k[3] * y) <=
                                          rounding * (std::abs(k[4] * x) + std::abs(k[3] * y));
  }
  return point;
}

}  // namespace

const char* to_string(PdeType type) {
  return text_of_enumerator<PdeType::undefined>(
      type, {"elliptic", "parabolic", "hyperbolic", "first_order", "undefined"});
}

void SecondOrderPde::prepare(Graph& graph, const std::vector<Id>& coefficients) {
  constant_ = std::all_of(coefficients.begin(), coefficients.begin() + 3,
                          [&](Id id) { return graph.is_constant(id); });
  evaluate_ = std::make_shared<const formula::Evaluator<long double>>(graph, coefficients);
}

SecondOrderPde::SecondOrderPde(const std::string& text) {
  if (uses_time(text)) second_ = "t";
  Graph graph;
  const formula::Scope scope = scope_of(graph, second_, true);
  // One = outside of conditions, which have == and ones beside < > and !.
  std::size_t equals = std::string::npos;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char before = i > 0 ? text[i - 1] : ' ', after = i + 1 < text.size() ? text[i + 1] : ' ';
    if (text[i] != '=' || before == '<' || before == '>' || before == '!' || before == '=' ||
        after == '=')
      continue;
    if (equals != std::string::npos)
      throw ExpressionError(i, "a second =; got it, expected one equation");
    equals = i;
  }
  Id root = parsed(text.substr(0, equals), 0, scope, graph);
  if (equals != std::string::npos)
    root =
        graph.make(Op::subtract, root, parsed(text.substr(equals + 1), equals + 1, scope, graph));
  std::vector<Id> coefficients(5, graph.constant(0));
  const auto gradient = formula::gradients(graph, {root}, states);
  for (const formula::Entry& entry : gradient[0])
    if (entry.by >= u_xx && entry.by <= u_y) coefficients[entry.by - u_xx] = entry.value;
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (!depends(graph, coefficients[k], u_xx, u_itself)) continue;
    const bool on_second = depends(graph, coefficients[k], u_xx, u_yy);
    throw ExpressionError(
        0, on_second ? "not linear in the second derivatives; its type depends on the solution"
                     : "the coefficients of the second derivatives contain u or its first "
                       "derivatives: quasilinear, its type depends on the solution; put a known "
                       "state's values in their place");
  }
  // Lower terms that are not linear do not change the type; they are left out of the coefficients.
  lower_known_ = true;
  for (std::uint32_t k = 3; k < 5; ++k)
    if (depends(graph, coefficients[k], u_xx, u_itself))
      coefficients[k] = graph.constant(0), lower_known_ = false;
  prepare(graph, coefficients);
}

SecondOrderPde::SecondOrderPde(const std::string& a, const std::string& b, const std::string& c) {
  if (uses_time(a) || uses_time(b) || uses_time(c)) second_ = "t";
  Graph graph;
  const formula::Scope scope = scope_of(graph, second_, false);
  std::vector<Id> coefficients;
  for (const std::string* text : {&a, &b, &c})
    coefficients.push_back(parsed(*text, 0, scope, graph));
  coefficients.resize(5, graph.constant(0));
  prepare(graph, coefficients);
}

PdePoint SecondOrderPde::at(double x, double y) const {
  const long double point[states] = {x, y};
  long double k[5];
  (*evaluate_)(y, point, k);
  return judged(k, lower_known_);
}

std::array<double, 2> PdeMap::place(std::size_t i, std::size_t j) const {
  const auto n = static_cast<double>(divisions);
  const double s = static_cast<double>(i) / n, r = static_cast<double>(j) / n;
  return {(1 - s) * region.x0 + s * region.x1, (1 - r) * region.y0 + r * region.y1};
}

double PdeMap::share(PdeType type) const {
  const auto count =
      std::ranges::count_if(points, [&](const PdePoint& point) { return point.type == type; });
  return static_cast<double>(count) / static_cast<double>(points.size());
}

PdeMap map_types(const SecondOrderPde& pde, const PdeRegion& region, std::size_t divisions) {
  if (!(region.x1 > region.x0) || !(region.y1 > region.y0) ||
      !std::isfinite(region.x1 - region.x0) || !std::isfinite(region.y1 - region.y0))
    throw std::invalid_argument("the region is empty: its ends have to rise");
  if (divisions == 0) throw std::invalid_argument("a map needs at least one division");
  PdeMap map;
  map.region = region, map.divisions = divisions;
  for (std::size_t j = 0; j <= divisions; ++j)
    for (std::size_t i = 0; i <= divisions; ++i) {
      const auto [x, y] = map.place(i, j);
      map.points.push_back(pde.at(x, y));
    }
  const auto sign = [](const PdePoint& p) {
    return p.type == PdeType::hyperbolic ? 1 : p.type == PdeType::elliptic ? -1 : 0;
  };
  const auto look = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l) {
    const int before = sign(map.point(i, j));
    if (before == 0 || before * sign(map.point(k, l)) >= 0) return;
    auto low = map.place(i, j), high = map.place(k, l);
    for (int halving = 0; halving < 60; ++halving) {
      const std::array half{(low[0] + high[0]) / 2, (low[1] + high[1]) / 2};
      const PdePoint found = pde.at(half[0], half[1]);
      // A change of sign across a pole is not a curve on which the equation is parabolic.
      if (found.type == PdeType::undefined) return;
      (sign(found) == before ? low : high) = half;
    }
    map.changes.push_back(high);
  };
  const bool on_curve = map.share(PdeType::parabolic) < 0.5;
  for (std::size_t j = 0; j <= divisions; ++j)
    for (std::size_t i = 0; i <= divisions; ++i) {
      // The grid may meet the curve itself.
      if (on_curve && map.point(i, j).type == PdeType::parabolic)
        map.changes.push_back(map.place(i, j));
      if (i < divisions) look(i, j, i + 1, j);
      if (j < divisions) look(i, j, i, j + 1);
    }
  return map;
}

}  // namespace odeum::fem
