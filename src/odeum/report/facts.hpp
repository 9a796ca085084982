// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::report {

/// What a page says about a case, apart from any result.
struct CaseFacts {
  std::string id, title, equation, source, truth;
  double truth_floor = 0;  ///< absolute error below which the truth says nothing
  double timed_floor = 0;  ///< the same where studies of time measure the error
  double timed_end = 0;    ///< the time t at which these do
  double scale = 1;  ///< largest component of the initial state, in magnitude; 1 where all are 0
  std::vector<std::string> tags;
  std::vector<std::complex<double>> eigenvalues = {};  ///< see cases/spectrum.hpp
  double eigenvalues_time = 0;
  std::string file = {};  ///< of its own page, relative to index.html; named by the Page

  bool has_tag(const std::string& tag) const;
};

/// What every section may refer to: who took part, and on what. Plain data, so that a test can make
/// it up.
struct Facts {
  std::vector<CaseFacts> cases;
  std::vector<SolverInfo> solvers;  ///< each once, in the order of enrolment
  std::vector<LibraryInfo> libraries;

  /// The libraries whose solvers take part, in the order of the solvers.
  std::vector<std::string> library_names() const;
  /// The version of the library that solvers named `library/...` come from; empty: not known, or
  /// ours.
  std::string library_version(const std::string& library) const;
};

Facts describe(const std::vector<Case>& cases, const std::vector<LibraryInfo>& libraries);

/// Text as part of a file name: letters, digits, - and _, whatever it was.
std::string file_stem(std::string_view text);

}  // namespace odeum::report
