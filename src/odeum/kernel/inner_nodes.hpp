// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

namespace odeum {

/// The state inside a step by a polynomial through the states at its ends and at nodes inside it,
/// Chebyshev's between Lobatto's ends. The method fills them once a step, so that the cost of
/// output does not grow with the number of outputs.
template <class S>
class InnerNodes {
 public:
  bool hold(double t, double h) const { return filled_ && t == t_ && h == h_; }
  /// Nodes 0, ..., inner + 1 of the step from t to t + h, the first and the last at its ends;
  /// states and slopes are those of `like` until they are set.
  void begin(double t, double h, int inner, const S& like) {
    t_ = t, h_ = h;
    filled_ = false;
    shares_.clear();
    for (int k = 0; k < inner + 2; ++k)
      shares_.push_back((1 - std::cos(std::numbers::pi * k / (inner + 1))) / 2);
    shares_.back() = 1;
    states_.resize(shares_.size(), like);
    slopes_.resize(shares_.size(), like);
  }
  void filled() { filled_ = true; }
  std::size_t size() const { return shares_.size(); }
  double share(std::size_t node) const { return shares_[node]; }  ///< of the step: 0, ..., 1
  S& state(std::size_t node) { return states_[node]; }
  S& slope(std::size_t node) { return slopes_[node]; }  ///< y' at the node

  /// Interpolates by the states: degree inner + 1.
  void by_states(double share, S& y) const {
    y = states_.front();
    for (std::size_t k = 1; k < size(); ++k) add(basis(k, share), states_[k], y);
  }
  /// Interpolates by the states and slopes (Hermite): degree 2 inner + 3.
  void by_slopes(double share, S& y) const {
    y = states_.front();
    for (std::size_t k = 0; k < size(); ++k) {
      const double from = share - shares_[k], square = std::pow(basis(k, share), 2);
      add(square * (1 - 2 * from * basis_slope(k)), states_[k], y);
      for (std::size_t i = 0; i < y.size(); ++i) y[i] += square * from * h_ * slopes_[k][i];
    }
  }

 private:
  // The weights of the states sum to 1: differences from the first round less than states.
  void add(double weight, const S& state, S& y) const {
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += weight * (state[i] - states_.front()[i]);
  }
  double basis(std::size_t node, double share) const {  // Lagrange's polynomial
    double product = 1;
    for (std::size_t k = 0; k < size(); ++k)
      if (k != node) product *= (share - shares_[k]) / (shares_[node] - shares_[k]);
    return product;
  }
  double basis_slope(std::size_t node) const {  // its derivative at its own node
    double sum = 0;
    for (std::size_t k = 0; k < size(); ++k)
      if (k != node) sum += 1 / (shares_[node] - shares_[k]);
    return sum;
  }

  double t_ = 0, h_ = 0;
  bool filled_ = false;
  std::vector<double> shares_;
  std::vector<S> states_, slopes_;
};

}  // namespace odeum
