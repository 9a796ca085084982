// SPDX-License-Identifier: BSD-3-Clause
#ifdef ODEUM_HAS_ARB
#include "odeum/truth/enclosed_flow.hpp"

#include <arb_mat.h>
#include <fmt/format.h>

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "odeum/formula/series_rules.hpp"

namespace odeum::truth {
namespace {

constexpr int order = 20;
constexpr double most_work = 2e8;      // products of coefficients: two seconds
constexpr double remainder = 0x1p-69;  // of a step, to which states of size 1 are enclosed
constexpr double lost = 1e-3;          // an enclosure so wide is of no use

/// The equations, and then dV/dt = J V by rows: the derivative V of the flow.
std::vector<formula::Id> with_derivative(formula::Graph& graph,
                                         const std::vector<formula::Id>& equations) {
  using formula::Id, formula::Op;
  const auto n = static_cast<std::uint32_t>(equations.size());
  const auto rows = formula::gradients(graph, equations, n);
  std::vector<Id> all = equations;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < n; ++j) {
      Id sum = graph.constant(0);
      for (const formula::Entry& entry : rows[i])
        if (entry.by < n)
          sum =
              graph.make(Op::add, sum,
                         graph.make(Op::multiply, entry.value, graph.state(n + entry.by * n + j)));
      all.push_back(sum);
    }
  return all;
}

bool all_finite(const Ball* balls, std::size_t count) {
  return std::all_of(balls, balls + count, [](const Ball& ball) { return ball.finite(); });
}

/// sum_k c[k * states + i] h^k up to order - 1, and the remainder.
Ball sum_of(const Balls& c, std::size_t states, std::size_t i, const Ball& h, const Ball& rest) {
  Ball sum = c[static_cast<std::size_t>(order - 1) * states + i];
  for (int k = order - 2; k >= 0; --k) sum = sum * h + c[static_cast<std::size_t>(k) * states + i];
  return sum + rest;
}

/// The factor Q of a matrix, its columns taken by descending length; near enough.
Eigen::MatrixXd orthogonal(const Eigen::MatrixXd& a, const std::vector<double>& lengths) {
  std::vector<Eigen::Index> by_length(lengths.size());
  std::iota(by_length.begin(), by_length.end(), 0);
  std::ranges::stable_sort(by_length, std::greater(), [&](Eigen::Index j) { return lengths[j]; });
  return a(Eigen::all, by_length).householderQr().householderQ();
}

/// The inverse of a matrix, enclosed.
Balls inverse_of(const Eigen::MatrixXd& q) {
  const slong size = q.rows();
  arb_mat_t a, inverse;
  arb_mat_init(a, size, size);
  arb_mat_init(inverse, size, size);
  for (slong i = 0; i < size; ++i)
    for (slong j = 0; j < size; ++j) arb_set_d(arb_mat_entry(a, i, j), q(i, j));
  Balls result(static_cast<std::size_t>(size * size));
  const bool regular = arb_mat_inv(inverse, a, Ball::bits) != 0;
  for (slong i = 0; i < size; ++i)
    for (slong j = 0; j < size; ++j) {
      Ball& entry = result[static_cast<std::size_t>(i * size + j)];
      if (regular)
        arb_set(entry.get(), arb_mat_entry(inverse, i, j));
      else
        arb_indeterminate(entry.get());
    }
  arb_mat_clear(a);
  arb_mat_clear(inverse);
  return result;
}

}  // namespace

EnclosedFlow::EnclosedFlow(const formula::Problem& problem)
    : n_(problem.states.size()),
      all_(n_ + n_ * n_),
      t_(problem.t0),
      matrix_(Eigen::MatrixXd::Identity(n_, n_)) {
  formula::Graph graph = problem.graph;
  const auto series = [&](const std::vector<formula::Id>& equations) {
    formula::SeriesPlan plan = formula::make_series_plan(graph, equations);
    cost_ += static_cast<double>(plan.steps.size()) * order * order / 2;
    return std::make_unique<Series>(graph, std::move(plan), equations.size());
  };
  plain_ = series(problem.equations);
  both_ = series(with_derivative(graph, problem.equations));
  for (std::size_t i = 0; i < n_; ++i) {
    const Ball start(problem.y0[i]);
    middle_.push_back(start.midpoint());
    rest_.push_back(start - middle_.back());
  }
}
EnclosedFlow::~EnclosedFlow() = default;

Balls EnclosedFlow::box() const {
  Balls result = middle_;
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t j = 0; j < n_; ++j) result[i] += Ball(matrix_(i, j)) * rest_[j];
  return result;
}

std::string EnclosedFlow::run_to(double time) {
  const double span = (Ball(time) - t_).middle(), start = t_.middle(), before = spent_;
  // Where an eighth of the work makes a fiftieth of the way the rest is not tried.
  const auto is_spent = [&] {
    return spent_ > most_work ||
           (spent_ - before > most_work / 8 && t_.middle() - start < span / 50);
  };
  if (h_ == 0) h_ = span / 16;
  for (;;) {
    const Ball left = Ball(time) - t_;
    const double distance = left.middle();
    if (!(distance > 0)) return "";
    const bool last = h_ >= distance * (1 - 1e-9);
    const double next = h_;
    if (is_spent() || !(h_ > 1e-9 * span))
      return fmt::format("the work is spent at t = {:.4g}", t_.middle());
    spent_ += 2 * cost_;
    if (!step(last ? left : Ball(std::min(h_, distance / 2)))) continue;
    if (last) {
      t_ = Ball(time);
      h_ = std::max(h_, next);
    }
    for (const Ball& each : box())
      if (!(each.radius() < lost * (1 + std::abs(each.middle()))))
        return fmt::format("the enclosure is lost at t = {:.4g}: perturbations grow without end",
                           t_.middle());
  }
}

/// The path over the part [0, h] of a step: Picard's operator takes it into itself.
bool EnclosedFlow::enclose_path(const Ball& time, const Ball& part, const Balls& start,
                                Balls& path) {
  constexpr int rounds = 8;
  Balls c(2 * all_);
  const auto image = [&](std::size_t i) { return start[i] + part * c[all_ + i]; };
  (*both_)(time, start.data(), 1, c.data());
  path = start;
  for (int round = 0; round < rounds; ++round) {
    bool inside = round > 0;
    Balls next(all_);
    for (std::size_t i = 0; i < all_; ++i) {
      next[i] = image(i);
      if (!next[i].finite()) return false;
      inside = inside && path[i].holds(next[i]);
    }
    path = std::move(next);
    if (inside) return true;
    for (std::size_t i = 0; i < all_; ++i) path[i] += Ball::around(0.2 * path[i].radius() + 1e-30);
    (*both_)(time, path.data(), 1, c.data());
  }
  return false;
}

/// One step of h; else false, and `h_` is shorter.
bool EnclosedFlow::step(const Ball& h) {
  const double length = h.middle();
  Balls start = box(), path;
  for (std::size_t k = 0; k < n_ * n_; ++k) start.emplace_back(static_cast<int>(k % (n_ + 1) == 0));
  const Ball part = h * (Ball(0.5) + Ball::around(0.5));
  grown_ = std::min(2.0, 1.1 * std::max(grown_, 1.0));
  const auto shorter = [&](double factor) {
    h_ = length * factor;
    grown_ = 0;
    return false;
  };
  if (!enclose_path(t_ + part, part, start, path)) return shorter(0.6);
  // The remainder, from the last coefficient over the path.
  const std::size_t top = static_cast<std::size_t>(order) * all_;
  Balls c(top + all_);
  (*both_)(t_ + part, path.data(), order, c.data());
  if (!all_finite(c.data() + top, all_)) return shorter(0.6);
  Ball power = h;
  for (int k = 1; k < order; ++k) power = power * h;
  Balls rest(all_);
  double worst = 0;
  for (std::size_t i = 0; i < all_; ++i) {
    rest[i] = c[top + i] * power;
    // Errors of the derivative act on a set that is narrow.
    const double size = (1 + start[i].largest()) * (i < n_ ? 1 : 1e9);
    worst = std::max(worst, rest[i].largest() / size);
  }
  const double factor = 0.9 * std::pow(remainder / std::max(worst, 1e-300), 1.0 / order);
  if (worst > remainder) return shorter(std::clamp(factor, 0.2, 0.9));
  h_ = length * std::clamp(factor, 0.5, grown_);

  (*both_)(t_, start.data(), order - 1, c.data());
  Balls derivative(n_ * n_), flow(n_);
  for (std::size_t k = 0; k < n_ * n_; ++k)
    derivative[k] = sum_of(c, all_, n_ + k, h, rest[n_ + k]);
  (*plain_)(t_, middle_.data(), order - 1, c.data());
  for (std::size_t i = 0; i < n_; ++i) flow[i] = sum_of(c, n_, i, h, rest[i]);
  turn(derivative, flow);
  t_ += h;
  return true;
}

/// m', A' and r' that hold flow(m) + V A r: A' as the columns of V A lie, r' = A'^-1 (V A r + ...).
void EnclosedFlow::turn(const Balls& derivative, const Balls& flow_of_middle) {
  Balls moved(n_ * n_);
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t j = 0; j < n_; ++j)
      for (std::size_t k = 0; k < n_; ++k)
        moved[i * n_ + j] += derivative[i * n_ + k] * Ball(matrix_(k, j));
  Eigen::MatrixXd near(n_, n_);
  std::vector<double> lengths(n_);
  for (std::size_t i = 0; i < n_; ++i)
    for (std::size_t j = 0; j < n_; ++j) {
      near(i, j) = moved[i * n_ + j].middle();
      lengths[j] += std::pow(near(i, j) * rest_[j].radius(), 2);
    }
  // The columns stay as they lie, as long as they point to different sides.
  constexpr double most_oblique = 300;
  matrix_ = near.colwise().normalized();
  Balls inverse = inverse_of(matrix_);
  if (std::ranges::any_of(inverse,
                          [](const Ball& each) { return !(each.largest() < most_oblique); })) {
    matrix_ = orthogonal(near, lengths);
    inverse = inverse_of(matrix_);
  }
  Balls off(n_), rest(n_);
  for (std::size_t i = 0; i < n_; ++i) {
    middle_[i] = flow_of_middle[i].midpoint();
    off[i] = flow_of_middle[i] - middle_[i];
  }
  for (std::size_t i = 0; i < n_; ++i) {
    for (std::size_t j = 0; j < n_; ++j) {
      Ball entry;
      for (std::size_t k = 0; k < n_; ++k) entry += inverse[i * n_ + k] * moved[k * n_ + j];
      rest[i] += entry * rest_[j] + inverse[i * n_ + j] * off[j];
    }
  }
  rest_ = std::move(rest);
}

}  // namespace odeum::truth
#endif
