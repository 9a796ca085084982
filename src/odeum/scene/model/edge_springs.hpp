// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <vector>

#include "odeum/scene/model/terms.hpp"

namespace odeum::scene {

/// Springs as a list of edges, sorted by their first ends.
class EdgeSprings final : public Term {
 public:
  EdgeSprings(const char* name, std::vector<Spring> springs);

  const std::vector<Spring>& springs() const { return springs_; }
  TermInfo info(const Bodies& bodies) const override;
  std::uint64_t add(const Bodies& bodies, const double* q, const double* v,
                    double* force) const override;
  void add_blocks(const Bodies& bodies, const double* q, const double* v,
                  BlockSink& sink) const override;
  double potential(const Bodies& bodies, const double* q) const override;

 private:
  const char* name_;
  std::vector<Spring> springs_;
};

}  // namespace odeum::scene
