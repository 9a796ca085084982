// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <Eigen/Core>
#include <memory>
#include <string>
#include <vector>

#include "odeum/formula/problem.hpp"
#include "odeum/truth/ball.hpp"

namespace odeum::formula {
template <class Real>
class Series;
}

namespace odeum::truth {

using Balls = std::vector<Ball>;

/// A set that holds the solution of y' = f(t, y), from its start on: m + A r, of a point, a matrix
/// close to an orthogonal one and a box, so that a flow that turns and shears widens it by what it
/// stretches alone (Lohner). A step is the flow of m, by Taylor's method with its remainder, and
/// the flow's derivative over the set times A r.
class EnclosedFlow {
 public:
  /// The problem has no kinks.
  explicit EnclosedFlow(const formula::Problem& problem);
  ~EnclosedFlow();

  /// Goes on to a later time; otherwise returns why it can't.
  std::string run_to(double time);
  /// The balls in which the states of the solution lie.
  Balls box() const;

 private:
  using Series = formula::Series<Ball>;

  bool step(const Ball& h);
  bool enclose_path(const Ball& time, const Ball& part, const Balls& start, Balls& path);
  void turn(const Balls& derivative, const Balls& flow_of_middle);

  std::size_t n_, all_;  ///< states, and with the flow's derivative
  std::unique_ptr<Series> plain_, both_;
  Ball t_;
  Balls middle_, rest_;     ///< m and r
  Eigen::MatrixXd matrix_;  ///< A
  double cost_ = 0, spent_ = 0;
  double h_ = 0, grown_ = 0;  ///< the next step, and by how much it may be longer than the last
};

}  // namespace odeum::truth
