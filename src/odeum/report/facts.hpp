// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <complex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "odeum/solvers/case.hpp"

namespace odeum::report {

/// What a page says about a case, apart from any result.
struct CaseFacts {
  std::string id, title, equation, source, truth;
  std::string words = {};  ///< that name it on a command line; empty: the id
  bool scaled = false;     ///< errors are in the units of its scale
  std::string unit;        ///< of time: "s" where a scene, which is in SI units, states the problem
  double truth_floor = 0;  ///< absolute error below which the truth says nothing
  double timed_floor = 0;  ///< the same where studies of time measure the error
  double start = 0;        ///< initial time
  double timed_end = 0;    ///< the time t at which these do
  double scale = 1;  ///< largest component of the initial state, in magnitude; 1 where all are 0
  std::vector<std::string> tags;
  std::vector<std::complex<double>> eigenvalues = {};  ///< see cases/spectrum.hpp
  double eigenvalues_time = 0;
  odeum::Facts linear = {};  ///< of a linear problem of few unknowns, see cases/linear_form.hpp
};

/// What every part of a report may refer to: who took part, and on what. Plain data, so that a test
/// can make it up.
struct Facts {
  std::vector<CaseFacts> cases;
  std::vector<SolverInfo> solvers;  ///< each once, in the order of enrolment
  std::vector<LibraryInfo> libraries;
};

Facts describe(const std::vector<const Case*>& cases, const std::vector<LibraryInfo>& libraries,
               unsigned jobs = 1);

/// Entries of page.json. Texts are made plain (report/text.hpp), numbers that are not finite are
/// null.
nlohmann::ordered_json json_of(const CaseFacts& c);
nlohmann::ordered_json json_of(const SolverInfo& solver);
nlohmann::ordered_json json_of(const std::vector<LibraryInfo>& libraries);

/// What repeats a run, for manifest.json: `words` and `folder` of the command that this process
/// executes, and `loaded`, the files of its shared libraries, whose names have their versions, each
/// with its bytes and their sum.
nlohmann::ordered_json facts_of_process();

}  // namespace odeum::report
